# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Scenes in GetFEM (python3-getfem++): augmented Lagrangian contact with Coulomb friction on a rigid joint.

As a module: run_scene() writes the meshes and the job and measures a child process. As a program
(getfem_run.py JOB.json): that child process. GetFEM's integral contact brick knows no elastic layer, so the joint
is rigid, and its error is taken against the rigid solution.
"""
import json
import sys

BOTTOM, SIDES, BASE, PUSHED = 21, 22, 23, 24  # numbers of the boundaries in the files written for GetFEM


def _write_msh2(path, mesh, body, lines):
    """Gmsh 2.2 with one body; the numbers of its boundaries become regions in GetFEM."""
    cells = mesh.group(body)
    used = sorted({v for cell in cells for v in cell})
    number = {v: k for k, v in enumerate(used, 1)}
    elements = [(1, tag, e) for tag, group in lines.items() for e in group] + [(3, 1, cell) for cell in cells]
    with open(path, "w") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n%d\n" % len(used))
        file.writelines("%d %r %r 0\n" % (number[v], *mesh.nodes[v - 1]) for v in used)
        file.write("$EndNodes\n$Elements\n%d\n" % len(elements))
        file.writelines("%d %d 2 %d %d %s\n" % (k, kind, tag, tag, " ".join(str(number[v]) for v in e))
                        for k, (kind, tag, e) in enumerate(elements, 1))
        file.write("$EndElements\n")


def start_seconds():
    import fuga_runs
    from process import measure
    directory = fuga_runs.WORK / "runs"
    directory.mkdir(parents=True, exist_ok=True)
    return measure(["/usr/bin/python3", "-c", "import getfem, numpy, json"], str(directory)).cpu


def run_scene(scene, increments, reference, cpu_limit=600):
    import fuga_runs
    from process import Result, measure, relative_error
    tag = "getfem_%s_%d" % (fuga_runs.tag_of(scene, "%r" % scene.joint["f"]), increments)
    directory = fuga_runs.WORK / "runs" / tag
    directory.mkdir(parents=True, exist_ok=True)
    (directory / "result.json").unlink(missing_ok=True)
    mesh, double = scene.mesh.opened("base", scene.structure)
    base = scene.mesh.group("base")
    _write_msh2(directory / "lower.msh", mesh, "foundation",
                {BOTTOM: mesh.group("foundation_bottom"), SIDES: mesh.group("foundation_sides"), BASE: base})
    _write_msh2(directory / "upper.msh", mesh, scene.structure,
                {BASE: [tuple(double[v] for v in e) for e in base], PUSHED: mesh.group("upstream")})
    job = {"upper": scene.bodies[scene.structure], "lower": scene.bodies["foundation"], "f": scene.joint["f"],
           "pressure": scene.pressure, "stages": scene.stages, "increments": increments}
    (directory / "job.json").write_text(json.dumps(job))
    start = start_seconds()
    process = measure(["/usr/bin/python3", __file__, "job.json"], str(directory), cpu_limit)
    result = Result({"total": process.cpu, "total_after_start": process.cpu - start}, process.memory_MB, scene.n,
                    scene.dofs)
    if not (directory / "result.json").exists():
        last = process.output.strip().splitlines()[-1:] or ["no message"]
        result.failure = "stopped at the limit of %d s of CPU time" % cpu_limit if process.timed_out else last[0]
        return result
    found = json.loads((directory / "result.json").read_text())
    result.info = {"solutions": found["solutions"], "getfem": found["version"]}
    if found["failure"]:
        result.failure = found["failure"]
    else:
        jumps = found["jump_n"], found["jump_t"]
        result.error = relative_error(jumps[0] + jumps[1], reference[-1][0] + reference[-1][1])
    return result


def _body(gf, np, file, E, nu):
    mesh = gf.Mesh("import", "gmsh", file)
    field = gf.MeshFem(mesh, 2)
    field.set_fem(gf.Fem("FEM_QK(2,1)"))
    integration = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,3)"))
    return mesh, field, integration, E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


def _lip(np, mesh, field, u):
    """Displacements of the nodes of the base from left to right: (x, ux, uy)."""
    dofs = field.basic_dof_on_region(BASE)
    places = field.basic_dof_nodes(dofs)
    order = np.argsort(places[0][0::2])
    return [(float(places[0][2 * k]), float(u[dofs[2 * k]]), float(u[dofs[2 * k + 1]])) for k in order]


def solve(job):
    import getfem as gf
    import numpy as np
    gf.util_trace_level(0)
    model = gf.Model("real")
    upper = _body(gf, np, "upper.msh", *job["upper"][:2])
    lower = _body(gf, np, "lower.msh", *job["lower"][:2])
    for name, (mesh, field, integration, lam, mu) in (("u", upper), ("v", lower)):
        model.add_fem_variable(name, field)
        model.add_initialized_data("lambda_" + name, lam)
        model.add_initialized_data("mu_" + name, mu)
        model.add_isotropic_linearized_elasticity_brick(integration, name, "lambda_" + name, "mu_" + name)
        model.add_initialized_data("old_" + name, np.zeros(field.nbdof()))
    model = _with_loads_and_joint(model, np, job, upper, lower)
    factors, solutions, failure = {"weight": 0., "push": 0.}, 0, ""
    for number, stage in enumerate(job["stages"], 1):
        begin = dict(factors)
        for k in range(1, job["increments"] + 1):
            for load, end in stage.items():
                factors[load] = begin[load] + (end - begin[load]) * k / job["increments"]
            model.set_variable("weight", [0., -job["upper"][2] * factors["weight"]])
            model.set_variable("push", [job["pressure"][0] * factors["push"]])
            model.set_variable("push_y", [job["pressure"][1] * factors["push"]])
            # a larger residual leaves errors of several per cent here, a smaller one costs more solutions
            iterations = model.solve("max_res", 1e-9, "max_iter", 100, "lsolver", "mumps")[0]
            solutions += int(iterations)
            if iterations >= 100:
                failure = "no convergence in 100 iterations: stage %d, increment %d of %d" % (
                    number, k, job["increments"])
                break
            for name in "uv":
                model.set_variable("old_" + name, model.variable(name))
        if failure:
            break
    above = _lip(np, upper[0], upper[1], model.variable("u"))
    below = _lip(np, lower[0], lower[1], model.variable("v"))
    return {"failure": failure, "solutions": solutions, "version": "5.4",
            "jump_n": [a[2] - b[2] for a, b in zip(above, below)],
            "jump_t": [a[1] - b[1] for a, b in zip(above, below)]}


def _with_loads_and_joint(model, np, job, upper, lower):
    model.add_initialized_data("weight", [0., 0.])
    model.add_source_term_brick(upper[2], "u", "weight")
    model.add_initialized_data("push", [0.])
    model.add_initialized_data("push_y", [0.])
    model.add_linear_term(upper[2], "-(push + push_y*X(2))*Test_u(1)", PUSHED)
    # Supports by elimination: all of the bottom, x on the sides.
    model.add_Dirichlet_condition_with_simplification("v", BOTTOM)
    model.add_initialized_data("x_only", [[1., 0.], [0., 0.]])
    model.add_initialized_data("zero", [0., 0.])
    model.add_generalized_Dirichlet_condition_with_multipliers(lower[2], "v", 1, SIDES, "zero", "x_only")
    # The contact pressure lives on the base of the block; small values at the start, so that it is not free at once.
    model.add_filtered_fem_variable("pressure", upper[1], BASE)
    size = len(model.variable("pressure"))
    model.set_variable("pressure", np.array([0., 1.] * (size // 2)))
    model.add_initialized_data("r", job["upper"][0] / 100.)
    model.add_initialized_data("f", job["f"])
    model.add_initialized_data("alpha", 1.)
    model.add_integral_contact_between_nonmatching_meshes_brick(
        upper[2], "u", "v", "pressure", "r", "f", BASE, BASE, 1, "alpha", "old_u", "old_v")
    return model


if __name__ == "__main__":
    with open(sys.argv[1]) as job_file:
        answer = solve(json.load(job_file))
    with open("result.json", "w") as result_file:
        json.dump(answer, result_file)

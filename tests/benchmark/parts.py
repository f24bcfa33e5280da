# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The parts of the benchmark: which tool runs which scene how."""
import dam_block
import fuga_runs
import precision
import scenes
import sweep
from peers import calculix, getfem_run
from process import Result
from rounds import Case


SIZES = (9, 33, 129, 513)         # contact elements of scene G that the peers solve, too
LARGE = (1025, 2049)              # and beyond
# Increments per stage by faces of the dam from heel to toe and kind of contact; all of them with --full.
CALCULIX_IN_SPACE = {(9, "nts"): (1, 10, 50), (9, "sts"): (1, 10), (13, "nts"): (1, 10), (13, "sts"): (1, 10),
                     (24, "nts"): (1,), (24, "sts"): ()}


def startup_cases(options):
    def only_start(seconds):
        return lambda: Result({"total": seconds()}, 0., 0, 0)
    return [Case("none", "fuga", "version", only_start(fuga_runs.start_seconds)),
            Case("none", "calculix", "version", only_start(calculix.start_seconds)),
            Case("none", "getfem", "import", only_start(getfem_run.start_seconds)),
            fuga_case(scenes.scene_g(9, 0.6), "f0.6")]


def fuga_case(scene, variant, fields="never", threads=1):
    return Case(scene.name, "fuga", variant + " n=%d" % scene.n,
                lambda: fuga_runs.run_scene(scene, variant, fields, threads))


def bonded_case(scene):
    """The same bodies grown together, with the fields of the end."""
    return fuga_case(scene.altered(bonded=True), "bonded", "end")


def stage_ends(scene):
    """The scene by one certified implicit step per stage: the setting to put beside peers with one increment."""
    return scene.altered(solver={"Follow": "stage ends"})


def scaling_cases(options):
    cases = []
    for n in (9, 17, 33) if options.quick else (9, 17, 33, 65, 129, 257):
        cases += [fuga_case(scenes.s0(n, variant), variant) for variant in ("linear", "law9", "rigid")]
        cases.append(bonded_case(scenes.s0(n)))
    for n in sizes_of_scene_g(options) + (() if options.quick else LARGE):
        cases += [fuga_case(scenes.scene_g(n, f), "f%.1f" % f) for f in (0.2, 0.6)]
        cases.append(bonded_case(scenes.scene_g(n, 0.6)))
    return cases


def sizes_of_scene_g(options):
    return SIZES[:2] if options.quick else SIZES


class References:
    """Jumps at the ends of the stages, made when first wanted; who computed them is noted in `sources`."""

    def __init__(self):
        self.known, self.sources = {}, {}

    def of(self, scene):
        key = "%s n=%d f=%g kn=%r" % (scene.name, scene.n, scene.joint["f"], scene.joint["kn"])
        if key not in self.known:
            self.known[key], self.sources[key] = fuga_runs.reference_of(scene)
        return self.known[key]


REFERENCES = References()


def calculix_case(scene, variant, kind, increments, limit):
    return Case(scene.name, "calculix", "%s %s x%d n=%d" % (variant, kind, increments, scene.n),
                lambda: calculix.run_scene(scene, kind, increments, None if scene.limit else REFERENCES.of(scene),
                                           limit))


def getfem_case(scene, variant, increments, limit):
    rigid = scene.altered(joint={**scene.joint, "kn": None})
    return Case(scene.name, "getfem", "%s x%d n=%d" % (variant, increments, scene.n),
                lambda: getfem_run.run_scene(rigid, increments, REFERENCES.of(rigid), limit))


def peer_cases(options):
    cases = []
    for n in sizes_of_scene_g(options):
        for f in (0.2, 0.6):
            scene, rigid, variant = scenes.scene_g(n, f), scenes.scene_g(n, f, None), "f%.1f" % f
            cases += [fuga_case(scene, variant), fuga_case(rigid, "rigid " + variant)]
            if fuga_runs.knows("stage ends"):
                cases.append(fuga_case(stage_ends(scene), variant + " stage ends"))
            cases += peer_runs(scene, variant, options.full or n < 513)
    if not options.quick:
        scene = scenes.s0(65)
        cases += [fuga_case(scene, "linear"), fuga_case(scenes.s0(65, "rigid"), "rigid")]
        cases += peer_runs(scene, "linear", options.full)
    return cases


def peer_runs(scene, variant, all_with_ten):
    """With one increment per stage and with ten; of the large ones with ten only the fastest, a minute each."""
    cases = []
    for increments in (10, 1):
        every = increments == 1 or all_with_ten
        cases += [calculix_case(scene, variant, kind, increments, 900) for kind in ("nts", "sts")[:1 + every]]
        cases += [getfem_case(scene, variant, increments, 900)] if every else []
    return cases


def stiffness_cases(options):
    cases = []
    for kn in (1e6, 1e8, 1e10, 1e12, None):
        variant = "rigid f0.6" if kn is None else "kn%.0e f0.6" % kn
        for n in (33,) if options.quick else (33, 129):
            cases.append(fuga_case(scenes.scene_g(n, 0.6, kn), variant))
        if kn not in (None, 1e6):
            # surface to surface takes a minute to fail at 1e10
            kinds = ("nts", "sts") if kn != 1e10 or options.full else ("nts",)
            cases += [calculix_case(scenes.scene_g(33, 0.6, kn), variant, kind, 10, 120) for kind in kinds]
    return cases


def reversal_cases(options):
    cases = []
    for n in (33,) if options.quick else (33, 129):
        scene = scenes.scene_g(n, 0.6, reversal=True)
        cases.append(fuga_case(scene, "f0.6"))
        for increments in (1, 10) if options.quick else (1, 10, 50, 200, 800):
            if options.full or increments <= (200 if n == 33 else 50):
                both = increments <= 50 if options.full else n == 33 and increments <= 10
                kinds = ("nts", "sts")[:1 + both]
                cases += [calculix_case(scene, "f0.6", kind, increments, 3600) for kind in kinds]
    return cases


def space_cases(options):
    """The block of a dam, and to its sliding limit."""
    cases = []
    for faces in (9,) if options.quick else (9, 13, 24):
        scene, limit = dam_block.dam_block(faces), dam_block.to_the_limit(faces)
        cases += [fuga_case(scene, "linear"), bonded_case(scene), fuga_case(stage_ends(scene), "linear stage ends"),
                  fuga_case(limit, "linear")]
        for kind in ("nts", "sts"):
            increments = (1, 10, 50) if options.full else CALCULIX_IN_SPACE[faces, kind]
            cases += [calculix_case(scene, "linear", kind, k, 3600) for k in increments if k <= 10 or not options.quick]
            if options.full or (faces, kind) == (9, "nts") and not options.quick:
                cases.append(calculix_case(limit, "linear", kind, 10, 900))
    return cases


def threads_cases(options):
    n = (33, 33, 9) if options.quick else (513, 257, 24)
    scenes_and_variants = ((scenes.scene_g(n[0], 0.6), "f0.6"), (scenes.s0(n[1]), "linear"),
                           (dam_block.dam_block(n[2]), "linear"))
    return [fuga_case(scene, "%s threads %d" % (variant, threads), threads=threads)
            for scene, variant in scenes_and_variants for threads in (1, 2)]


def precision_cases(options):
    cases = []
    for problem in (make() for make in precision.PROBLEMS):
        if problem.finest:
            result, directory = precision.run(problem, *problem.finest)
            if result.failure:
                raise RuntimeError("%s: the finest run failed: %s" % (problem.name, result.failure))
            problem.prepare(directory)
            REFERENCES.sources[problem.name] = "finest run %s; %s" % ((problem.finest,), problem.domain)
        for level, kind, degree in problem.runs(options.quick):
            def run(problem=problem, level=level, kind=kind, degree=degree):
                result, directory = precision.run(problem, level, kind, degree)
                if not result.failure:
                    result.error = problem.error(directory)
                return result
            cases.append(Case(problem.name, "fuga", "%s Q%d level=%d" % (kind, degree, level), run))
    return cases


def sweep_cases(options):
    if not sweep.available():
        return []
    n = 33 if options.quick else 129
    scene = scenes.scene_g(n, 0.6)
    return [fuga_case(scene, "f0.6")] + [
        Case("scene_g", "fuga", "sweep of %d n=%d" % (count, n), lambda count=count: sweep.run(scene, count))
        for count in sweep.COUNTS]


MAKERS = {"startup": startup_cases, "scaling": scaling_cases, "peers": peer_cases, "stiffness": stiffness_cases,
          "reversal": reversal_cases, "space": space_cases, "threads": threads_cases, "precision": precision_cases,
          "sweep": sweep_cases}


def all_cases(names, options):
    """Each case once, in the first part that asks for it."""
    cases = {}
    for part in names:
        for case in MAKERS[part](options):
            case.part = part
            cases.setdefault(case.key, case)
    return list(cases.values())

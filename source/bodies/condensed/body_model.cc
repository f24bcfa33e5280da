// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fuga/base/errors.h>
#include <fuga/bodies/condensed/body_model.h>
#include <fuga/bodies/elasticity/boundary_conditions.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/joints/joint_corners.h>
#include <fuga/bodies/loads/imposed_gap.h>
#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/loads/uplift_assembly.h>
#include <fuga/bodies/point_text.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  template <int dim>
  BodyModel<dim>::BodyModel(const JointedMesh &jointed,
                            const ModelDefinition &model_definition,
                            const std::vector<bool> &frictionless,
                            const unsigned int stage)
    : mesh(jointed), model(model_definition), floats(releases_supports(model, stage))
  {
    check_names(mesh, model);
    space = std::make_unique<Discretization<dim>>(mesh, model, stage);
    check_outer_faces(*space);
    if (floats)
      check_absorbing_faces(*space, mesh, model);
    timer.finish("mesh and degrees of freedom");
    find_coordinates(frictionless);
    timer.finish("joints and supports");
    list_joint_faces();
  }


  template <int dim>
  BodyModel<dim>::~BodyModel() = default;


  template <int dim>
  void
  BodyModel<dim>::find_coordinates(const std::vector<bool> &frictionless)
  {
    fixed = find_fixed_dofs(
      *space, mesh, model, floats ? model.dynamics.absorbing.names : std::vector<std::string>());
    pieces   = std::make_unique<RigidPieces<dim>>(*space, mesh, fixed);
    geometry = std::make_unique<JointGeometry<dim>>(*space, mesh);
    bars     = std::make_unique<ContactBars<dim>>(*geometry, mesh, fixed, frictionless);
    if (std::find(frictionless.begin(), frictionless.end(), true) != frictionless.end() &&
        !pieces->are_held_by(*bars))
      {
        lines.push_back("the normal bars alone do not hold the structure: frictionless joints keep "
                        "their tangential bars");
        bars = std::make_unique<ContactBars<dim>>(
          *geometry, mesh, fixed, std::vector<bool>(mesh.joints.size(), false));
      }
    if (!floats)
      pieces->require_held_by(*bars);
    if (space->is_axisymmetric())
      lines.push_back("axisymmetric: areas and forces of the full circle; the axis is held in x");
    for (const auto &more : {corner_report(geometry->pairs(), mesh), bars->report()})
      lines.insert(lines.end(), more.begin(), more.end());
    bodies = std::make_unique<ElasticBodies<dim>>(*space, mesh, model);
    coordinates =
      std::make_unique<InterfaceCoordinates<dim>>(*space, *bars, fixed, bodies->node_moduli());
  }


  template <int dim>
  void
  BodyModel<dim>::list_joint_faces()
  {
    for (const auto &face : geometry->faces())
      {
        JointFace result;
        result.joint     = face.joint;
        result.area      = face.area;
        result.cell      = face.boundary.cell;
        result.number    = face.boundary.number;
        result.backwards = face.backwards;
        for (const unsigned int pair : face.pairs)
          {
            result.shares.push_back(bars->shares_of_pair(pair));
            result.positions.emplace_back();
            for (unsigned int c = 0; c < dim; ++c)
              result.positions.back()[c] = geometry->pairs()[pair].position[c];
          }
        faces.push_back(std::move(result));
      }
  }


  template <int dim>
  const std::vector<ContactElement> &
  BodyModel<dim>::elements() const
  {
    return bars->elements();
  }


  template <int dim>
  std::array<double, 3>
  BodyModel<dim>::normal(const std::size_t element) const
  {
    std::array<double, 3> result{};
    for (unsigned int c = 0; c < dim; ++c)
      result[c] = bars->pair_of_element(element).normal[c];
    return result;
  }


  template <int dim>
  std::array<std::array<double, 3>, 2>
  BodyModel<dim>::tangents(const std::size_t element) const
  {
    std::array<std::array<double, 3>, 2> result{};
    for (unsigned int k = 0; k + 1 < dim; ++k)
      for (unsigned int c = 0; c < dim; ++c)
        result[k][c] = bars->tangents_of_element(element)[k][c];
    return result;
  }


  template <int dim>
  std::vector<ElementIdentity>
  BodyModel<dim>::identities() const
  {
    std::vector<ElementIdentity> result;
    for (std::size_t k = 0; k < elements().size(); ++k)
      {
        const auto &pair = bars->pair_of_element(k);
        result.push_back(
          {{pair.joint,
            space->dof(pair.plus_node, 0),
            pair.minus_node == Discretization<dim>::no_node ? static_cast<std::size_t>(-1)
                                                            : space->dof(pair.minus_node, 0),
            pair.part}});
      }
    return result;
  }


  template <int dim>
  LoadPattern
  BodyModel<dim>::assemble_load(const std::size_t number, const double t) const
  {
    timer.restart();
    const LoadDefinition &load = model.loads.at(number);
    LoadPattern pattern        = load.kind == LoadKind::uplift
                                   ? uplift(number).assemble(levels_of_water(load, model.constants, t))
                                   : LoadAssembly<dim>(*space, mesh, model, fixed).assemble(load, t);
    pattern.number_of_load     = number;
    if (load.kind == LoadKind::imposed_gap)
      pattern.jumps = imposed_gap<dim>(load, model.constants, t, mesh, *bars);
    timer.finish("loads");
    return pattern;
  }


  template <int dim>
  const UpliftAssembly<dim> &
  BodyModel<dim>::uplift(const std::size_t number) const
  {
    uplifts.resize(model.loads.size());
    if (!uplifts[number])
      uplifts[number] =
        std::make_unique<UpliftAssembly<dim>>(model.loads[number], *space, *geometry, *bars, mesh);
    return *uplifts[number];
  }


  template <int dim>
  void
  BodyModel<dim>::check_settlement(const Vector &prescribed) const
  {
    double largest = 0.;
    for (const double value : prescribed)
      largest = std::max(largest, std::abs(value));
    for (const auto &pair : bars->held_pairs())
      {
        const bool obstacle = pair.minus_node == Discretization<dim>::no_node;
        const double jump   = prescribed[pair.plus_node * dim + pair.component] -
                            (obstacle ? 0. : prescribed[pair.minus_node * dim + pair.component]);
        if (std::abs(jump) > 1e-9 * largest)
          throw InputError(
            fmt::format("A settlement tears the two sides of a joint apart at {}, where supports "
                        "hold both of them in {}. Hold one side only, or move both alike.",
                        text_of(space->position(pair.plus_node)),
                        "xyz"[pair.component]));
      }
  }


  template <int dim>
  void
  BodyModel<dim>::check_load_patterns(const std::vector<LoadPattern> &loads) const
  {
    for (const LoadPattern &pattern : loads)
      if (!pattern.prescribed.empty())
        check_settlement(pattern.prescribed);
  }


  template <int dim>
  Vector
  BodyModel<dim>::bar_forces(const Vector &p) const
  {
    Vector forces(space->n_dofs(), 0.);
    bars->add_forces(1., p, forces);
    return forces;
  }


  template <int dim>
  dealii::Vector<double>
  BodyModel<dim>::by_degrees_of_freedom(const Vector &u) const
  {
    dealii::Vector<double> result(space->n_dofs_of_all_bodies());
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      for (unsigned int c = 0; c < dim; ++c)
        result[space->dof(node, c)] = u[node * dim + c];
    return result;
  }


  template <int dim>
  Vector
  BodyModel<dim>::out_of_balance(const Vector &loads, const Vector &u) const
  {
    Vector residual = bodies->forces(u);
    for (std::size_t i = 0; i < residual.size(); ++i)
      residual[i] = loads[i] - residual[i];
    return coordinates->gather(residual);
  }


  template <int dim>
  EquilibriumError
  BodyModel<dim>::equilibrium_error_under(const Vector &loads,
                                          const dealii::Vector<double> &u,
                                          const Vector &p,
                                          const dealii::Vector<double> &motion) const
  {
    timer.restart();
    Vector terms;
    const Vector by_nodes = space->by_nodes(u), elastic = bodies->forces(by_nodes, by_nodes, terms);
    // The rounding error of a jump moves both lips against each other. It is that of a sum over all
    // bars, and proportional to the size of the motion.
    if (motion.size() > 0)
      {
        const double sum_length = 0.25 * static_cast<double>(bars->bars().size());
        const Vector far        = space->by_nodes(motion);
        Vector far_terms;
        bodies->forces(far, far, far_terms);
        for (const auto &bar : bars->bars())
          for (const unsigned int node : {bar.plus_node, bar.minus_node})
            for (unsigned int c = 0; c < dim && node != Discretization<dim>::no_node; ++c)
              terms[node * dim + c] =
                std::max(terms[node * dim + c], sum_length * far_terms[node * dim + c]);
      }
    return equilibrium_error_of(elastic, std::move(terms), p, loads, {});
  }


  template <int dim>
  EquilibriumError
  BodyModel<dim>::equilibrium_error_in_motion(const Vector &loads,
                                              const Vector &u,
                                              const Vector &deformation,
                                              const Vector &p,
                                              const Vector &acting) const
  {
    timer.restart();
    Vector terms;
    const Vector elastic = bodies->forces(deformation, u, terms);
    return equilibrium_error_of(elastic, std::move(terms), p, loads, acting);
  }


  template <int dim>
  EquilibriumError
  BodyModel<dim>::equilibrium_error_of(
    Vector elastic, Vector terms, const Vector &p, Vector loads, const Vector &acting) const
  {
    for (const auto &bar : bars->bars())
      if (bar.minus_node != Discretization<dim>::no_node)
        for (unsigned int c = 0; c < dim; ++c)
          {
            double &plus = terms[bar.plus_node * dim + c], &minus = terms[bar.minus_node * dim + c];
            plus = minus = std::max(plus, minus);
          }
    // Rounding knows no axes: its effect along one axis appears across it as well, by the balance
    // of moments.
    for (std::size_t node = 0; node < space->n_nodes(); ++node)
      {
        double *const of_node = terms.data() + node * dim;
        std::fill(of_node, of_node + dim, *std::max_element(of_node, of_node + dim));
      }
    loads.resize(space->n_dofs(), 0.);
    for (Vector *forces : {&elastic, &terms, &loads})
      space->hanging_nodes().move_to_masters(*forces);

    const EquilibriumError error =
      equilibrium_error(elastic, terms, bar_forces(p), loads, acting, fixed, *pieces);
    timer.finish("equilibrium check");
    return error;
  }


  template <int dim>
  Vector
  BodyModel<dim>::jumps(const dealii::Vector<double> &u) const
  {
    return bars->jumps(space->by_nodes(u));
  }


  template <int dim>
  Vector
  BodyModel<dim>::cell_energies(const Vector &u) const
  {
    return bodies->cell_energies(u);
  }


  template class BodyModel<2>;
  template class BodyModel<3>;
} // namespace fuga

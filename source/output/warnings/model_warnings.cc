// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed/model_sizes.h>
#include <fuga/bodies/dynamics/ground_motion.h>
#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/model_names.h>
#include <fuga/output/warnings/dynamic_data.h>
#include <fuga/output/warnings/implausible_data.h>
#include <fuga/output/warnings/implausible_loads.h>
#include <fuga/output/warnings/model_warnings.h>

#include <deal.II/fe/fe.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Size of all results above which the user is asked about a run [bytes]. */
    constexpr double large_output = 5e9;

    /** Sizes measured on the shipped dams [bytes per level]: a row of joint_history.csv, a row of
     * resultants.csv; in the fields a contact element, and a node with its share of cells. */
    constexpr double history_row = 250., resultants_row = 450., field_element = 300.,
                     field_node_in_plane = 100., field_node_in_space = 220.;

    template <int dim>
    void
    warn_of_size(const Parameters &parameters,
                 const CondensedSystem<dim> &system,
                 std::vector<std::string> &warnings)
    {
      double n_levels = 0.;
      for (const StageDefinition &stage : parameters.model.stages)
        n_levels += stage.purpose == StagePurpose::loading ? stage.levels : 0.;
      const double n_elements = static_cast<double>(system.elements().size());
      const double n_nodes    = static_cast<double>(system.discretization().n_nodes());
      const double tables =
        n_levels *
        (history_row * n_elements + resultants_row * static_cast<double>(parameters.joints.size()));
      const double fields =
        parameters.output.fields != FieldOutput::levels
          ? 0.
          : n_levels * (field_element * n_elements +
                        (dim == 2 ? field_node_in_plane : field_node_in_space) * n_nodes);
      if (tables + fields > large_output)
        warnings.push_back(
          fmt::format("{:.0f} load levels will write about {:.2g} GB of tables and {:.2g} GB of "
                      "fields. Take fewer Levels in the stages; events are found exactly between "
                      "any two of them. Fields are left out by Output/Fields = end or never.",
                      n_levels,
                      tables / 1e9,
                      fields / 1e9));
    }

    /** Return for each body the largest distance between nodes that a wave from below passes one
     * after the other. */
    template <int dim>
    Vector
    steps_upwards(const Discretization<dim> &space, const std::size_t n_bodies)
    {
      const ReferenceElement<dim> &element = space.reference_element();
      Vector result(n_bodies, 0.);
      for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
        {
          const unsigned int *nodes = space.cell_nodes(cell);
          double low = space.position(nodes[0])[dim - 1], high = low;
          for (std::size_t i = 1; i < element.n_corners(); ++i)
            {
              low  = std::min(low, space.position(nodes[i])[dim - 1]);
              high = std::max(high, space.position(nodes[i])[dim - 1]);
            }
          double &largest = result[space.cell_body(cell)];
          largest         = std::max(largest, (high - low) / element.scalar_element().degree);
        }
      return result;
    }

    /** Warn of cells that are high for the waves of a record (R. L. Kuhlemeyer, J. Lysmer, Finite
     * element method accuracy for wave propagation problems, J. Soil Mech. Found. Div. ASCE 99,
     * 1973). */
    template <int dim>
    void
    warn_of_waves(const Parameters &parameters,
                  const CondensedSystem<dim> &system,
                  std::vector<std::string> &warnings)
    {
      const DynamicsDefinition &dynamics = parameters.model.dynamics;
      double period                      = std::numeric_limits<double>::infinity();
      for (const GroundMotion &motion : dynamics.ground)
        if (!motion.accelerations.empty())
          period = std::min(period, mean_period(motion));
      if (dynamics.absorbing.names.empty() || !std::isfinite(period))
        return;
      const JointedMesh &mesh = system.jointed_mesh();
      const Vector density    = mass_densities(mesh, parameters.model);
      const Vector steps      = steps_upwards(system.discretization(), density.size());
      constexpr double part   = 0.1;
      for (const Material &material : parameters.model.materials)
        {
          const unsigned int body = index_of(mesh.body_names, material.body);
          if (density[body] == 0.)
            continue;
          const double speed =
            std::sqrt(lame_constants(material, parameters.model.assumption).mu / density[body]);
          const std::string &unit = parameters.output.units.length;
          if (steps[body] > part * speed * period)
            warnings.push_back(fmt::format(
              "Bodies/{}: nodes are up to {:.3g} {} apart in height, which is unusual for waves of "
              "the mean period of the record, {:.3g} s, at {:.4g} {}/s; usual is at most {:g} of "
              "their length, {:.3g} {}. Refine the mesh, or raise the polynomial degree.",
              material.body,
              steps[body],
              unit,
              period,
              speed,
              unit,
              part,
              part * speed * period,
              unit));
        }
    }

    /** Warn of thin cells: multigrid that joins neighbours alike in all directions smooths badly
     * along them. */
    template <int dim>
    void
    warn_of_stretched_cells(const Parameters &parameters,
                            const CondensedSystem<dim> &system,
                            std::vector<std::string> &warnings)
    {
      constexpr double usual  = 10.;
      const BodySolver solver = parameters.model.body_solver;
      if (solver == BodySolver::automatic || is_direct(solver))
        return;
      double stretch = 1.;
      for (const auto &cell : system.discretization().triangulation().active_cell_iterators())
        stretch = std::max(stretch, cell->diameter() / cell->minimum_vertex_distance());
      if (stretch > usual)
        warnings.push_back(fmt::format(
          "Solver/Bodies = {}: cells are up to {:.3g} times as long as wide, usual is at most "
          "{:g}. "
          "Conjugate gradients with multigrid need the more iterations the longer cells are; "
          "direct does not care.",
          name_of(solver),
          stretch,
          usual));
    }
  } // namespace


  template <int dim>
  std::vector<std::string>
  model_warnings(const Parameters &parameters,
                 const CondensedSystem<dim> &system,
                 const LoadHistory &load_factors,
                 const unsigned int first_stage,
                 const unsigned int end_stage)
  {
    std::vector<std::string> warnings;
    if (first_stage == 0)
      {
        const auto [low, high] = extent_of(system.discretization());
        double extent          = 0.;
        for (unsigned int c = 0; c < dim; ++c)
          extent = std::max(extent, high[c] - low[c]);
        warnings = implausible_data(parameters, extent);
        for (const std::string &text : implausible_dynamics(parameters))
          warnings.push_back(text);
        warn_of_waves(parameters, system, warnings);
        warn_of_size(parameters, system, warnings);
        warn_of_stretched_cells(parameters, system, warnings);
      }
    ImplausibleLoads<dim> loads(parameters, system, load_factors);
    for (unsigned int stage = first_stage; stage < end_stage; ++stage)
      if (parameters.model.stages[stage].purpose == StagePurpose::loading)
        loads.review(stage);
    warnings.insert(warnings.end(), loads.warnings().begin(), loads.warnings().end());
    return warnings;
  }

  template std::vector<std::string>
  model_warnings(const Parameters &,
                 const CondensedSystem<2> &,
                 const LoadHistory &,
                 const unsigned int,
                 const unsigned int);
  template std::vector<std::string>
  model_warnings(const Parameters &,
                 const CondensedSystem<3> &,
                 const LoadHistory &,
                 const unsigned int,
                 const unsigned int);
} // namespace fuga

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/bodies/program/refinement_indicator.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/output/files/output_files.h>
#include <fuga/run/simulation/simulation.h>
#include <fuga/study/adaptive_run.h>
#include <fuga/study/dual_fields.h>

#include <deal.II/lac/vector.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Share of the energy of the difference: the cells that contain this share of it are
     * refined. */
    constexpr double marked_share = 0.6;

    /** Approximate factor by which the number of unknowns grows if the mesh is refined
     * everywhere. */
    template <int dim>
    constexpr std::size_t growth = 1u << dim;

    template <int dim>
    bool
    is_refined_locally(const Discretization<dim> &space)
    {
      return space.reference_element().n_corners() == 1u << dim;
    }

    double
    seconds_since(const std::chrono::steady_clock::time_point begin)
    {
      return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
  } // namespace


  template <int dim>
  AdaptiveRun<dim>::AdaptiveRun(std::unique_ptr<const Model<dim>> first_model)
    : model(std::move(first_model))
  {
    const AccuracyTarget &target = model->parameters.accuracy;
    report.quantity              = entries_of<AccuracyEntries>().quantity.word_of(target.quantity);
    report.target                = target.relative_error;
  }


  template <int dim>
  ExitCode
  AdaptiveRun<dim>::run()
  {
    const std::string directory = model->parameters.output.directory;
    const bool quiet            = model->parameters.output.log == LogDetail::quiet;
    const auto begin            = std::chrono::steady_clock::now();
    const double of_first_model = model->timer.sum();
    begin_output();
    for (bool going_on = true; going_on;)
      {
        ModelDefinition next = model->parameters.model;
        try
          {
            going_on = do_round(next);
          }
        catch (const Interrupted &)
          {
            throw Interrupted(fmt::format("Interrupted in round {} of the search for the mesh.",
                                          report.rounds.size() + 1));
          }
        write_refinement_table(directory, report);
        if (!quiet)
          fmt::print("{}\n", report.description(report.rounds.size() - 1));
        std::fflush(stdout);
        if (going_on)
          replace_model(next);
      }
    model->timer.restart();
    // The last model has recorded how it was made.
    model->timer.book("finding the mesh",
                      of_first_model + seconds_since(begin) - model->timer.sum());
    return Simulation<dim>(*model, report).run();
  }


  // From here on nothing of an earlier run is left, and the summary states that this one is not
  // finished.
  template <int dim>
  void
  AdaptiveRun<dim>::begin_output() const
  {
    const Parameters &parameters = model->parameters;
    begin_results(parameters.output.directory, [&parameters]() {
      Summary unfinished;
      unfinished.verdict = "unfinished";
      write_complete_file(parameters.output.directory + "/summary.json",
                          summary_json(unfinished, parameters));
    });
  }


  template <int dim>
  bool
  AdaptiveRun<dim>::do_round(ModelDefinition &next)
  {
    const auto begin                 = std::chrono::steady_clock::now();
    const AccuracyTarget &target     = model->parameters.accuracy;
    const Discretization<dim> &space = model->bodies.discretization();
    AccuracyReport::Round round;
    round.cells            = space.n_cells();
    round.unknowns         = space.n_dofs();
    round.contact_elements = model->bodies.elements().size();
    round.estimate         = std::numeric_limits<double>::quiet_NaN();
    report.end.clear();
    if (is_too_large(space.n_dofs()))
      report.end = "largest number of unknowns";
    else
      try
        {
          compare(round, next);
          report.reached = round.estimate <= target.relative_error;
          if (report.reached)
            report.end = "reached";
          else if (std::isnan(round.estimate))
            report.end = "the quantity is zero";
          else if (next.refinements == model->parameters.model.refinements &&
                   next.local_refinements.back().empty())
            report.end = "no cell contributes to the estimate";
          else if (report.rounds.size() + 1 >= target.max_rounds)
            report.end = "largest number of rounds";
          else if (is_too_large(Discretization<dim>(model->mesh, next).n_dofs()))
            report.end = "largest number of unknowns";
        }
      catch (const NumericalFailure &failure)
        {
          report.end = fmt::format("numerical failure: {}", failure.what());
        }
    round.seconds = seconds_since(begin);
    report.rounds.push_back(round);
    return report.end.empty();
  }


  template <int dim>
  bool
  AdaptiveRun<dim>::is_too_large(const std::size_t n_unknowns) const
  {
    return static_cast<double>(growth<dim> * n_unknowns) > model->parameters.accuracy.max_unknowns;
  }


  template <int dim>
  void
  AdaptiveRun<dim>::compare(AccuracyReport::Round &round, ModelDefinition &next) const
  {
    const TrialRun<dim> coarse(*model);
    Parameters parameters              = model->parameters;
    parameters.model.refined_once_more = true;
    const Model<dim> refined(parameters);
    round.unknowns_compared = refined.bodies.discretization().n_dofs();
    const TrialRun<dim> fine(refined);
    round.estimate = AccuracyEstimate<dim>(coarse, fine).relative_error();
    if (is_refined_locally(model->bodies.discretization()))
      mark(coarse, fine, next);
    else
      ++next.refinements;
  }


  // The cells are marked where stages end and at the end; in between the fields are mixtures of
  // these.
  template <int dim>
  void
  AdaptiveRun<dim>::mark(const TrialRun<dim> &coarse,
                         const TrialRun<dim> &fine,
                         ModelDefinition &next) const
  {
    Vector indicator(model->bodies.discretization().n_cells(), 0.);
    const auto levels = common_levels(coarse, fine);
    for (const auto &[here, there] : levels)
      if (here->t == std::floor(here->t) || here == levels.back().first)
        {
          const auto energies = [&](const dealii::Vector<double> &u_coarse,
                                    const dealii::Vector<double> &u_fine) {
            return refinement_indicator(model->bodies, u_coarse, fine.model().bodies, u_fine);
          };
          const Vector of_u     = energies(coarse.deformation(*here), fine.deformation(*there));
          const auto dual_here  = dual_fields(coarse, *here);
          const auto dual_there = dual_fields(fine, *there);
          for (std::size_t i = 0; i < dual_here.size(); ++i)
            {
              const Vector of_dual = energies(dual_here[i], dual_there[i]);
              for (std::size_t cell = 0; cell < indicator.size(); ++cell)
                indicator[cell] += std::sqrt(of_u[cell] * of_dual[cell]);
            }
        }
    next.local_refinements.push_back(mark_cells(model->bodies, indicator, marked_share));
  }


  template <int dim>
  void
  AdaptiveRun<dim>::replace_model(const ModelDefinition &definition)
  {
    Parameters parameters = model->parameters;
    parameters.model      = definition;
    model.reset(); // two factorisations at once would take twice the memory
    model = std::make_unique<const Model<dim>>(parameters);
  }


  template class AdaptiveRun<2>;
  template class AdaptiveRun<3>;
} // namespace fuga

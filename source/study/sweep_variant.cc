// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/output/warnings/dynamic_data.h>
#include <fuga/output/warnings/model_range.h>
#include <fuga/study/sweep.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <optional>

namespace fuga
{
  namespace
  {
    ExitCode
    code_of(const PathResult &result)
    {
      return result.verdict == Verdict::done ? ExitCode::done : ExitCode::loss_of_equilibrium;
    }
  } // namespace

  /** Collects the data that the table needs, and has every event and level judged. */
  template <int dim>
  class VariantObserver : public PathObserver
  {
  public:
    /** Begin a phase, which must live as long as this observer receives its reports. */
    void
    begin(PhaseRun<dim> &next)
    {
      phase = &next;
      range.emplace(phase->joint.elements, phase->model.joint_names.size(), excesses);
      openings.resize(phase->model.joint_names.size(), 0.);
    }

    bool
    wants_cuts() const override
    {
      return phase->safety_search.is_wanted();
    }

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override
    {
      phase->judge.follow(from, to, length);
      range->watch(to.state);
      last_state = to.state;
    }

    void
    jumped(const JointState &to) override
    {
      phase->judge.lose_track();
      range->watch(to);
      last_state = to;
    }

    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override
    {
      last_state = state;
      worst.absorb(phase->judge.judge(state));
      for (const ContactEvent &event : events)
        {
          if (event.to == ContactState::open && !searching && !(first_opening <= event.t))
            first_opening = event.t;
          if (is_slipping(event.to) && !searching && !(first_slip <= event.t))
            first_slip = event.t;
        }
    }

    void
    reached(const std::size_t index, const JointState &state) override
    {
      levels = index + 1;
      worst.absorb(phase->judge.judge(state));
    }

    void
    began_step(const ContactSystem &system, const LoadHistory &history) override
    {
      phase->began_step(system, history);
    }

    void
    ended_step(const JointState &state) override
    {
      last_state         = state;
      energies_of_motion = phase->dynamic_path().energies();
      const auto results = phase->results(state);
      for (std::size_t k = 0; k < results.size(); ++k)
        {
          double &opening = openings[phase->joint.elements[k].joint];
          opening         = std::max(opening, results[k].gap);
        }
      phase->ended_step(state);
    }

    /** True while a search for safety is under way. */
    bool searching = false;
    JointState last_state;
    Certificate worst;
    double first_opening = std::numeric_limits<double>::quiet_NaN();
    double first_slip    = std::numeric_limits<double>::quiet_NaN();
    std::size_t levels   = 0;
    Vector openings;
    MotionLedger energies_of_motion;
    ModelRange::Record excesses;

  private:
    PhaseRun<dim> *phase = nullptr;
    std::optional<ModelRange> range;
  };

  template <int dim>
  class Sweep<dim>::VariantRun
  {
  public:
    VariantRun(Sweep &of, const Variant &variant);

    SweepRow
    result();

  private:
    PathResult
    follow_phases();
    void
    take(PathResult found);
    void
    find_safety();
    void
    take_end();

    Sweep &sweep;
    const Parameters parameters;
    SweepRow row;
    VariantObserver<dim> observer;
    /** A nullptr in the first phase, whose model is that of all variants. */
    std::unique_ptr<const Model<dim>> later;
    std::unique_ptr<PhaseRun<dim>> phase;
  };

  Parameters
  parameters_of(const Variant &variant, const Parameters &condensation)
  {
    Parameters parameters            = condensation;
    parameters.joints                = variant.joints;
    parameters.model.dynamics.ground = variant.ground;
    return parameters;
  }

  template <int dim>
  Sweep<dim>::VariantRun::VariantRun(Sweep &of, const Variant &variant)
    : sweep(of)
    , parameters(parameters_of(variant, sweep.model->parameters))
    , phase(std::make_unique<PhaseRun<dim>>(*sweep.model, parameters, sweep.layered, sweep.steps))
  {
    row.settings = variant.settings;
    row.safety   = phase->safety_search.announced();
    for (const std::string &text : implausible_dynamics(parameters))
      if (sweep.said.insert(text).second)
        row.warnings.push_back(text);
  }

  template <int dim>
  PathResult
  Sweep<dim>::VariantRun::follow_phases()
  {
    observer.begin(*phase);
    PathResult found = phase->path->run(phase->model.loads.levels, observer);
    while (found.verdict == Verdict::done && !phase->model.is_last_phase())
      {
        sweep.count(*phase);
        const PhaseEnd end = phase->leave(observer.last_state, found, observer.levels);
        phase.reset();
        later = std::make_unique<const Model<dim>>(parameters, end, sweep.later_bodies);
        sweep.later_bodies = later->shared_bodies;
        phase = std::make_unique<PhaseRun<dim>>(*later, parameters, nullptr, sweep.steps);
        const Checkpoint start = phase->enter(end);
        observer.begin(*phase);
        found = phase->path->go_on(start.cut, later->loads.levels, observer);
      }
    return found;
  }

  template <int dim>
  void
  Sweep<dim>::VariantRun::take(PathResult found)
  {
    const bool is_level = observer.levels > 0 &&
                          phase->model.loads.levels[observer.levels - 1] == observer.last_state.t;
    if (!observer.last_state.states.empty() && !is_level)
      observer.worst.absorb(phase->judge.judge(observer.last_state));
    prove_limit(phase->judge, phase->joint.elements, phase->layered, observer.last_state, found);
    row.path      = found;
    row.verdict   = verdict_name(found.verdict);
    row.exit_code = code_of(found);
    if (phase->safety_search.is_wanted() && found.verdict == Verdict::done)
      find_safety();
    if (!(observer.worst.worst() <= parameters.solver.certificate_bound))
      row.exit_code = ExitCode::certificate_violated;
  }

  template <int dim>
  void
  Sweep<dim>::VariantRun::find_safety()
  {
    const JointState end   = observer.last_state;
    JointState &last_state = observer.last_state;
    observer.searching     = true;
    row.safety             = phase->safety_search.run(
      phase->path->last_cut(),
      phase->judge,
      observer,
      [&last_state](const JointState &start) { last_state = start; },
      [this]() { observer.worst.absorb(phase->judge.judge(observer.last_state)); });
    last_state = end;
  }

  template <int dim>
  void
  Sweep<dim>::VariantRun::take_end()
  {
    const JointState &end   = observer.last_state;
    const Model<dim> &model = phase->model;
    if (!end.states.empty())
      {
        row.resultants = model.resultants(phase->results(end), phase->judge.dissipation());
        for (const Monitor &monitor : model.monitors)
          row.displacements.push_back(
            monitor.displacement(phase->monitored(end), model.loads.history.factors(end.t)));
      }
    row.motion       = model.motion(phase->joint.elements, row.path);
    row.n_iterations = phase->path->iterations().n_iterations;
    for (const std::string &text :
         range_warnings<dim>(observer.excesses, model.joint_names, parameters.output.units))
      row.warnings.push_back(text);
    sweep.count(*phase);
  }

  template <int dim>
  SweepRow
  Sweep<dim>::VariantRun::result()
  {
    const auto begin = std::chrono::steady_clock::now();
    try
      {
        take(follow_phases());
      }
    catch (const NumericalFailure &failure)
      {
        row.verdict   = "numerical failure";
        row.exit_code = ExitCode::numerical_failure;
        row.message   = failure.what();
        row.path.t    = observer.last_state.t;
      }
    if (phase)
      take_end();
    row.resultants.resize(parameters.joints.size());
    row.displacements.resize(parameters.model.monitors.size());
    row.drive =
      sweep.driving->at(row.path.t, stage_of(row.path.t, parameters.model.stages.size()).first);
    row.first_opening    = observer.first_opening;
    row.first_slip       = observer.first_slip;
    row.largest_openings = observer.openings;
    row.motion_energies  = observer.energies_of_motion;
    row.certificate      = observer.worst.worst();
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
  }

  template <int dim>
  SweepRow
  Sweep<dim>::run_variant(const Variant &variant)
  {
    const SweepRow row = VariantRun(*this, variant).result();
    count(row);
    return row;
  }

  template SweepRow
  Sweep<2>::run_variant(const Variant &);
  template SweepRow
  Sweep<3>::run_variant(const Variant &);
} // namespace fuga

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/judge/certificate.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/run/model/safety_search.h>
#include <fuga/run/simulation/table_range.h>
#include <fuga/study/sweep.h>

#include <chrono>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Notes what the table needs and has every event and level judged. */
    class VariantObserver : public PathObserver
    {
    public:
      VariantObserver(Judge &judge_of_variant,
                      const std::vector<ContactElement> &elements,
                      const bool looks_for_safety)
        : judge(judge_of_variant), tables(elements), keeps_cuts(looks_for_safety)
      {
      }

      bool
      wants_cuts() const override
      {
        return keeps_cuts;
      }

      void
      advanced(const PathPoint &from, const PathPoint &to, const double length) override
      {
        judge.follow(from, to, length);
        tables.watch(to.state);
        last_state = to.state;
      }

      void
      jumped(const JointState &to) override
      {
        judge.lose_track();
        last_state = to;
      }

      void
      changed(const std::vector<ContactEvent> &events, const JointState &state) override
      {
        last_state = state;
        worst.absorb(judge.judge(state));
        for (const ContactEvent &event : events)
          {
            if (event.to == ContactState::open && !searching && !(first_opening <= event.t))
              first_opening = event.t;
            if (is_slipping(event.to) && !searching && !(first_slip <= event.t))
              first_slip = event.t;
          }
      }

      void
      reached(const std::size_t, const JointState &state) override
      {
        worst.absorb(judge.judge(state));
      }

      Judge &judge;
      TableRange tables;
      const bool keeps_cuts;
      /** A search for safety is under way. */
      bool searching = false;
      JointState last_state;
      Certificate worst;
      double first_opening = std::numeric_limits<double>::quiet_NaN();
      double first_slip    = std::numeric_limits<double>::quiet_NaN();
    };

    ExitCode
    code_of(const PathResult &result)
    {
      return result.verdict == Verdict::done ? ExitCode::done : ExitCode::loss_of_equilibrium;
    }
  } // namespace

  template <int dim>
  SweepRow
  Sweep<dim>::run_variant(const Variant &variant)
  {
    const auto begin = std::chrono::steady_clock::now();
    const JointModel joint =
      make_joint_model<dim>(model->bodies, variant.joints, model->parameters.model.constants);
    const LayeredSystem &system = layered_system_of(joint);
    const SafetySearch<dim> search(*model, variant.joints, joint, system);
    const LoadHistory &history = model->loads.history;
    const LoadHistory loading  = history.until(model->loads.end_of_loading);
    Judge judge(model->bodies, joint.elements, history, model->loads.end_of_loading);
    VariantObserver observer(judge, joint.elements, search.is_wanted());
    const auto path =
      std::make_unique<EventPath>(joint.elements, system, loading, model->path_options());

    SweepRow row;
    row.settings = variant.settings;
    row.safety   = search.announced();
    try
      {
        PathResult found     = path->run(model->loads.levels, observer);
        const JointState end = observer.last_state;
        if (!end.states.empty())
          observer.worst.absorb(judge.judge(end));
        prove_limit(judge, joint.elements, system, end, found);
        row.path      = found;
        row.verdict   = verdict_name(found.verdict);
        row.exit_code = code_of(found);
        if (search.is_wanted() && row.path.verdict == Verdict::done)
          {
            JointState &last_state = observer.last_state;
            Certificate &worst     = observer.worst;
            observer.searching     = true;
            row.safety             = search.run(
              path->last_cut(),
              judge,
              observer,
              [&last_state](const JointState &start) { last_state = start; },
              [&worst, &judge, &last_state]() { worst.absorb(judge.judge(last_state)); });
            last_state = end;
          }
        if (!(observer.worst.worst() <= model->parameters.solver.certificate_bound))
          row.exit_code = ExitCode::certificate_violated;
      }
    catch (const NumericalFailure &failure)
      {
        row.verdict   = "numerical failure";
        row.exit_code = ExitCode::numerical_failure;
        row.message   = failure.what();
        row.path.t    = observer.last_state.t;
      }
    if (const JointState &end = observer.last_state; !end.states.empty())
      {
        const Vector jumps = system.jumps(end.dislocations, end.forces);
        const Vector x = judge.coordinates(jumps, end.t), a = history.factors(end.t);
        const DenseMatrix &water = model->bodies.closed_water();
        const auto results       = element_results(
          joint.elements, end, jumps, water.empty() ? Vector() : multiply(water, a));
        row.resultants = model->resultants(results, judge.dissipation());
        for (const Monitor &monitor : model->monitors)
          row.displacements.push_back(monitor.displacement(x, a));
      }
    row.resultants.resize(variant.joints.size());
    row.displacements.resize(model->monitors.size());
    row.drive  = driving->at(row.path.t, stage_of(row.path.t, model->stage_names.size()).first);
    row.motion = model->motion(joint.elements, row.path);
    row.first_opening = observer.first_opening;
    row.first_slip    = observer.first_slip;
    row.certificate   = observer.worst.worst();
    for (const std::string &text : observer.tables.template warnings<dim>(
           model->joint_names, parameters.output.units.stress()))
      row.warnings.push_back(text);
    count(row, *path);
    row.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return row;
  }

  template SweepRow
  Sweep<2>::run_variant(const Variant &);
  template SweepRow
  Sweep<3>::run_variant(const Variant &);
} // namespace fuga

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/dynamics/dynamic_path.h>
#include <fuga/contact/dynamics/rest_watch.h>
#include <fuga/contact/path/verdict_name.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Return the options for the paths of steps. Lips without mass may have no continuous way on
     * where friction is large: they jump to where they are in equilibrium again. The way through a
     * step only serves to reach its end, and the motion has the error of the step: the way needs to
     * be no more exact than what is certified of it, and other ways tell nothing about the motion.
     * The energies that all steps lose add up. */
    PathOptions
    of_steps(const double largest_number, PathOptions options)
    {
      constexpr double rounding = 1e-14;
      options.follow_jumps      = true;
      options.looks_for_others  = false;
      options.curve_tolerance   = 1e-9;
      options.least_energy_loss = std::clamp(
        PathOptions::largest_energy_loss / largest_number, rounding, options.least_energy_loss);
      return options;
    }
  } // namespace

  /** The bodies in steps of one length, and the path through these steps; its schemes are kept from
   * step to step. */
  struct DynamicPath::Rung
  {
    Rung(const unsigned int number, DynamicPath &of)
      : system(
          of.bodies.condensed_stiffness(number), number, of.bodies.jump_operator(), of.elements)
      , path(of.elements,
             system.layered(),
             of.history_of_step,
             of_steps(of.grid.n_steps * std::ldexp(1., static_cast<int>(number)), of.options))
    {
    }

    StepSystem system;
    EventPath path;
  };

  DynamicPath::DynamicPath(const std::vector<ContactElement> &contact_elements,
                           const LayeredSystem &layered_system,
                           const LoadHistory &load_history,
                           MovingBodies &moving_bodies,
                           const TimeGrid &time_grid,
                           const PathOptions &path_options)
    : ContactPath(contact_elements, layered_system, load_history)
    , bodies(moving_bodies)
    , grid(time_grid)
    , options(path_options)
    , rungs(grid.halvings + 1)
    , history_of_step(StepSystem::history())
  {
    steps_of_rung.assign(grid.halvings + 1, 0);
  }

  DynamicPath::~DynamicPath() = default;

  SchemeWork
  DynamicPath::work() const
  {
    SchemeWork sum;
    for (const std::unique_ptr<Rung> &one : rungs)
      if (one)
        {
          const SchemeWork work = one->path.work();
          sum.n_factorisations += work.n_factorisations;
          sum.n_updates += work.n_updates;
          sum.n_bars_ever_active = std::max(sum.n_bars_ever_active, work.n_bars_ever_active);
        }
    return sum;
  }

  IterationCount
  DynamicPath::iterations() const
  {
    IterationCount sum = iteration_count; // before the motion
    for (const std::unique_ptr<Rung> &one : rungs)
      if (one)
        {
          const IterationCount count = one->path.iterations();
          sum.n_solutions += count.n_solutions;
          sum.n_iterations += count.n_iterations;
          sum.max_in_one = std::max(sum.max_in_one, count.max_in_one);
        }
    return sum;
  }

  PathResult
  DynamicPath::follow(const std::vector<double> &levels, ReportCounter &observer)
  {
    JointState state  = cut.state;
    PathResult result = cut.result;
    if (restart)
      restore_motion(*restart);
    else
      begin(state);
    restart.reset();
    const auto cut_here = [&]() {
      make_cut(state, result, observer);
      if (observer.wants_cuts())
        motion_cut = motion_memory();
    };
    RestWatch watch;
    const std::vector<double> reported = grid.until_rest ? std::vector<double>() : levels;
    for (std::size_t step = tick >> grid.halvings;
         step < grid.n_steps && !watch.has_come_to_rest() && observer.wants_more();
         ++step)
      {
        cut_here();
        if (step == 0)
          observer.began_motion();
        advance(0, reported, state, result, observer);
        if (grid.until_rest)
          watch.note(ledger.kinetic);
      }
    if (grid.until_rest && !watch.has_come_to_rest() && observer.wants_more())
      result.verdict = Verdict::limit_load;
    cut_here();
    return result;
  }

  PathResult
  DynamicPath::resume_motion(const PathCut &from,
                             const MotionCut &motion,
                             const std::vector<double> &levels,
                             PathObserver &observer)
  {
    restart = motion;
    return resume(from, levels, observer);
  }

  void
  DynamicPath::begin(const JointState &state)
  {
    ledger = MotionLedger();
    tick   = 0;
    slip_rates.assign(elements.size(), TangentVector{});
    length_before = largest_rate = 0.;
    promising_rung               = 0;
    bodies.begin(state.forces, ledger);
    ledger.note_largest();
    ledger.rounding = rounding_of_work(state);
  }

  // The forces have as many digits as the largest one, and so do the jumps that they cause.
  double
  DynamicPath::rounding_of_work(const JointState &state) const
  {
    const double digits = 16. * std::numeric_limits<double>::epsilon();
    const double jump =
      std::max(max_abs(system.jumps(state.dislocations, state.forces)),
               max_abs(state.forces) / largest_diagonal(system.contact_system().stiffness()));
    double sum = 0.;
    for (const double force : state.forces)
      sum += std::abs(force);
    return digits * sum * jump;
  }

  MotionCut
  DynamicPath::motion_memory() const
  {
    MotionCut result = {*this, bodies.memory(), {}};
    for (unsigned int number = 0; number < rungs.size(); ++number)
      if (rungs[number])
        result.rungs.push_back({number, rungs[number]->path.memory()});
    return result;
  }

  void
  DynamicPath::restore_motion(const MotionCut &motion)
  {
    static_cast<MotionProgress &>(*this) = motion.progress;
    bodies.restore(motion.bodies);
    for (const auto &[number, memory] : motion.rungs)
      rung(number).path.restore(memory);
  }

  void
  DynamicPath::advance(const unsigned int number,
                       const std::vector<double> &levels,
                       JointState &state,
                       PathResult &result,
                       PathObserver &observer)
  {
    if (number >= promising_rung)
      {
        const IterationCount before = rung(number).path.iterations();
        const Attempt step          = attempt(number, state, result);
        if (const auto promising = promising_rung_after(step, number))
          {
            promising_rung = *promising;
            return accept(step, number, levels, state, result, observer);
          }
        rung(number).path.take_back_energies(before);
        if (number == grid.halvings)
          give_up(step, number, state.t);
      }
    advance(number + 1, levels, state, result, observer);
    advance(number + 1, levels, state, result, observer);
  }

  void
  DynamicPath::give_up(const Attempt &last, const unsigned int number, const double t) const
  {
    const std::string what = fmt::format(
      "No state of the joints was found at the end of a step of {:.3g} s at load time {:.12g}. "
      "Allow more halvings (Dynamics/Halvings) or shorter steps. What ended the last attempt, in "
      "the time of the step from 0 to 1: {}",
      grid.length_of(number),
      t,
      last.failure);
    if (last.exhausted)
      throw LawExhausted(what, *last.exhausted);
    throw NumericalFailure(what);
  }

  DynamicPath::Rung &
  DynamicPath::rung(const unsigned int number)
  {
    if (!rungs[number])
      rungs[number] = std::make_unique<Rung>(number, *this);
    return *rungs[number];
  }

  DynamicPath::Attempt
  DynamicPath::attempt(const unsigned int number, const JointState &state, const PathResult &result)
  {
    Rung &step                = rung(number);
    const std::size_t n_ticks = std::size_t(1) << (grid.halvings - number);
    step.system.begin(state, bodies.begin_step(number), ledger.largest);
    const double end = time_at(tick + n_ticks);
    JointState start = state;
    start.t          = 0.;
    take_water(JointState(), start);
    Attempt attempt{{}, StepRecord(state, end, elements, step.system.layered()), {}, {}};
    attempt.record.stop_if(
      [this, number](const StepRecord &record) { return is_hopeless(record, number); });
    try
      {
        attempt.result = step.path.follow_step(start, result, attempt.record);
        if (const Verdict verdict = attempt.result.verdict; verdict != Verdict::done)
          attempt.failure =
            attempt.result.tried.empty() ? verdict_name(verdict) : attempt.result.tried;
      }
    catch (const LawExhausted &limit)
      {
        attempt.failure      = limit.what();
        attempt.exhausted    = limit.state;
        attempt.exhausted->t = state.t + limit.state.t * (end - state.t);
      }
    catch (const NumericalFailure &failure)
      {
        attempt.failure = failure.what();
      }
    if (attempt.failure.empty() || number < grid.halvings)
      return attempt;
    // No shorter step will help. There may be an equilibrium at its end, whatever lies before it.
    Attempt jump{result, StepRecord(state, end, elements, step.system.layered()), {}, {}};
    return step.path.jump_over_course(start, jump.record, jump.result) ? std::move(jump)
                                                                       : std::move(attempt);
  }

  void
  DynamicPath::accept(const Attempt &attempt,
                      const unsigned int number,
                      const std::vector<double> &levels,
                      JointState &state,
                      PathResult &result,
                      PathObserver &observer)
  {
    StepSystem &of_step   = rung(number).system;
    const JointState &end = attempt.record.end();
    for (std::size_t k = 0; k < elements.size(); ++k)
      slip_rates[k] = mean_slip_rate(attempt.record, k, grid.length_of(number));
    length_before = grid.length_of(number);
    largest_rate  = std::max(largest_rate, attempt.record.largest_change() / length_before);
    tick += std::size_t(1) << (grid.halvings - number);
    ++steps_of_rung[number];

    bodies.finish_step(
      of_step.coordinates(of_step.layered().jumps(end.dislocations, end.forces), end.forces),
      end.forces,
      ledger);
    ledger.joints += attempt.record.joint_work();
    ledger.numerical += attempt.record.work_of_means() - attempt.record.joint_work();
    ledger.note_largest();

    observer.began_step(of_step, history_of_step);
    attempt.record.replay(observer);
    const bool has_jumped = attempt.result.n_followed_jumps > result.n_followed_jumps;
    state                 = attempt.record.end_of_motion();
    result                = attempt.result;
    if (has_jumped)
      result.jump.t = state.t; // the path only knows the time of the step
    result.t = state.t;
    reach_levels(levels, state, observer);
    observer.ended_step(state);
  }

  double
  DynamicPath::time_at(const std::size_t of_tick) const
  {
    const std::size_t per_step = std::size_t(1) << grid.halvings;
    const double part = static_cast<double>(of_tick) / static_cast<double>(per_step * grid.n_steps);
    return part < 1. ? grid.begin + part * (grid.end - grid.begin) : grid.end;
  }
} // namespace fuga

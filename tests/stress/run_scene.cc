// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/run_scene.h"

#include "stress/confirm.h"
#include "stress/confirm_in_space.h"
#include "stress/confirm_motion.h"

#include <fuga/base/errors.h>
#include <fuga/base/interruption.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/contact/segments/scheme_equilibrium.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/output/tables/summary.h>
#include <fuga/run/simulation/phases.h>
#include <fuga/run/simulation/threads.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <fmt/format.h>
#include <fstream>
#include <numeric>
#include <optional>

namespace fuga::stress
{
  const std::vector<std::string> &
  scene_columns()
  {
    static const std::vector<std::string> columns = {"scene",          "seed",
                                                     "dimension",      "verdict",
                                                     "confirmed_by",   "certificate",
                                                     "events",         "zero_steps",
                                                     "seconds",        "failure",
                                                     "worst_entry",    "t",
                                                     "stages",         "elements",
                                                     "bodies",         "joints",
                                                     "rho_min",        "rho_max",
                                                     "friction",       "cohesion",
                                                     "poisson",        "stiffness_ratio",
                                                     "aspect",         "size_ratio",
                                                     "offset",         "law",
                                                     "steps",          "single_switching",
                                                     "newton",         "search",
                                                     "checked_equal",  "checked_other",
                                                     "difference",     "features",
                                                     "energy_lacking", "not_accounted",
                                                     "message"};
    return columns;
  }

  namespace
  {
    /** Seconds spent on solving steps of one scene anew. */
    constexpr double confirmation_time = 4.;
    /** Seconds of a processor after which a motion is interrupted, as by Ctrl-C, and what it has
     * reached is examined. */
    constexpr int time_of_motion       = 20;
    constexpr std::size_t n_pieces     = 6;
    constexpr double certificate_bound = 1e-9;

    using Writer = std::function<void(const std::string &)>;

    template <typename Value>
    void
    tell(const Writer &write, const std::string &column, const Value &value)
    {
      std::string text = fmt::format("{}", value);
      for (char &c : text)
        if (c == '\n')
          c = ' ';
      write(column + '=' + text + '\n');
    }

    void
    tell_axes(const Writer &write, const SceneAxes &axes)
    {
      tell(write, "stages", axes.n_stages);
      tell(write, "bodies", axes.n_bodies);
      tell(write, "joints", axes.n_joints);
      tell(write, "rho_min", axes.rho_min);
      tell(write, "rho_max", axes.rho_max);
      tell(write, "friction", axes.friction);
      tell(write, "cohesion", axes.cohesion);
      tell(write, "poisson", axes.poisson_ratio);
      tell(write, "stiffness_ratio", axes.stiffness_ratio);
      tell(write, "aspect", axes.aspect);
      tell(write, "size_ratio", axes.size_ratio);
      tell(write, "offset", axes.offset);
      tell(write, "law", axes.law);
      tell(write, "features", fmt::format("{}", fmt::join(axes.features, "; ")));
    }

    // Every step but the shortest ones may lack the tolerance of the largest energy. What the
    // shortest ones lack the program tells its user. A spectral radius below one takes what it
    // likes. What no term accounts for is rounding, and has the bound of certificates.
    void
    tell_energies(const Writer &write, const nlohmann::json &motion, const double event_tolerance)
    {
      const double largest  = motion.at("largest_energy");
      const auto steps      = motion.at("steps_by_halvings").get<std::vector<double>>();
      const double n_steps  = std::accumulate(steps.begin(), steps.end(), 0.);
      const double rounding = motion.at("rounding");
      const auto share_of   = [&](const double energy) {
        return std::abs(energy) > rounding ? std::abs(energy) / largest : 0.;
      };
      const double missing       = motion.at("not_accounted_for");
      const double missing_share = share_of(missing);
      const double share         = share_of(missing + motion.at("numerical").get<double>());
      tell(write, "energy_lacking", share);
      tell(write, "not_accounted", missing_share);
      if (missing_share > certificate_bound)
        tell(write,
             "failure",
             fmt::format("{:.1e} of the energy is not accounted for", missing_share));
      if (steps.back() == 0. && share > 2. * event_tolerance * n_steps)
        tell(write, "failure", fmt::format("steps lack {:.1e} of the energy", share));
    }

    /** By how much the term `sudden` changes after the first step of the last motion, although
     * loads act all at once only there [MNm]. */
    double
    late_loss_of_sudden_loads(const std::string &directory)
    {
      std::ifstream file(directory + "/out/earthquake.csv");
      std::string line;
      std::getline(file, line);
      double stage = 0., in_first_step = 0., result = 0.;
      while (std::getline(file, line))
        {
          const double t      = std::stod(line);
          const double sudden = std::stod(line.substr(line.rfind(',') + 1));
          if (std::ceil(t) != stage)
            {
              stage         = std::ceil(t);
              in_first_step = sudden;
              result        = 0.;
            }
          result = std::max(result, std::abs(sudden - in_first_step));
        }
      return result;
    }

    /** What the program itself says, from the file that users read. */
    std::string
    tell_summary(const Writer &write, const std::string &directory, const double energy_tolerance)
    {
      std::ifstream file(directory + "/out/summary.json");
      const nlohmann::json summary = nlohmann::json::parse(file);
      const auto &events           = summary.at("events");
      const auto &certificate      = summary.at("certificate");
      const std::string verdict    = summary.at("verdict");
      tell(write, "verdict", verdict);
      std::string worst = "none";
      double largest    = 0.;
      for (const auto &[name, value] : certificate.at("entries").items())
        if (!value.is_number() || value.get<double>() > largest)
          {
            worst   = name;
            largest = value.is_number() ? value.get<double>() : 1e300;
          }
      tell(write, "certificate", largest);
      tell(write, "worst_entry", worst);
      tell(write, "events", events.at("total").get<std::size_t>());
      tell(write, "zero_steps", events.at("zero_length_steps").get<std::size_t>());
      tell(write, "steps", events.at("steps").get<std::size_t>());
      const auto &decided = events.at("decided_by");
      tell(write, "single_switching", decided.at("single switching").get<std::size_t>());
      tell(write, "newton", decided.at("Newton's method").get<std::size_t>());
      tell(write, "search", decided.at("search").get<std::size_t>());
      tell(write, "elements", summary.at("sizes").at("contact_elements").get<std::size_t>());
      tell(write, "t", summary.at("t").get<double>());
      if (summary.contains("message"))
        tell(write, "message", summary.at("message").get<std::string>());
      if (summary.contains("motion"))
        {
          constexpr double rounding  = 1e-8;
          const nlohmann::json &last = summary.at("motion");
          tell_energies(write, last, energy_tolerance);
          if (const double late = late_loss_of_sudden_loads(directory);
              late > last.at("rounding").get<double>() +
                       rounding * last.at("largest_energy").get<double>())
            tell(
              write, "failure", fmt::format("sudden loads lose {:.1e} after a first step", late));
        }
      if (largest > certificate_bound)
        tell(write, "failure", fmt::format("certificate {:.1e} ({})", largest, worst));
      return verdict;
    }

    /** What is needed to prove a limit load as a run does. */
    class JudgedSample : public PieceSample
    {
    public:
      explicit JudgedSample(const Judge &of_scene) : PieceSample(n_pieces), judge(of_scene)
      {
      }

      void
      changed(const std::vector<ContactEvent> &events, const JointState &state) override
      {
        PieceSample::changed(events, state);
        judge.judge(state);
      }

      void
      reached(const std::size_t index, const JointState &state) override
      {
        PieceSample::reached(index, state);
        judge.judge(state);
      }

      Judge judge;
    };

    void
    tell_confirmation(const Writer &write, const Confirmation &confirmation)
    {
      tell(write, "confirmed_by", confirmation.by);
      tell(write, "checked_equal", confirmation.n_equal);
      tell(write, "checked_other", confirmation.n_other);
      tell(write, "difference", confirmation.difference);
      if (!confirmation.objection.empty())
        tell(write, "failure", confirmation.objection);
    }

    /** The same path again, watched by the independent solvers. */
    template <int dim>
    void
    ask_judges(const Writer &write,
               const Model<dim> &model,
               const SceneData &scene,
               const std::string &verdict,
               const std::string &directory)
    {
      const JointModel joint = make_joint_model<dim>(
        model.bodies, model.parameters.joints, model.parameters.model.constants);
      const LayeredSystem layered(model.bodies, joint.elements);
      const auto path = std::make_unique<EventPath>(
        joint.elements, layered, model.loads.history, model.path_options());
      JudgedSample sample(Judge(model.bodies, joint.elements, model.loads.history));
      std::optional<PathResult> end;
      try
        {
          PathResult result = path->run(model.loads.levels, sample);
          if (!sample.end.states.empty())
            sample.judge.judge(sample.end);
          prove_limit(sample.judge, joint.elements, layered, sample.end, result);
          end = std::move(result);
        }
      catch (const LawExhausted &limit)
        {
          sample.end = limit.state;
        }
      catch (const NumericalFailure &)
        {
        }
      if ((end ? verdict_name(end->verdict) : "numerical failure") != verdict)
        {
          tell(write, "failure", "the verdict is another one when the path is run again");
          return;
        }
      if (!end && law_is_exhausted(joint.elements, sample.end))
        {
          tell(write, "confirmed_by", "limit of the law");
          return;
        }
      if (!end)
        {
          std::string failure = "numerical failure";
          if constexpr (dim == 3)
            failure += what_others_find(scene, model, joint, sample, directory);
          tell(write, "failure", failure);
          return;
        }
      const PathResult &result = *end;
      if constexpr (dim == 2)
        tell_confirmation(write, confirm(model, joint, result, sample, confirmation_time));
      else
        tell_confirmation(
          write,
          confirm_in_space(scene, model, joint, result, sample, directory, confirmation_time));
    }

    /** Interrupts what is done while it lives. */
    class Interrupter
    {
    public:
      explicit Interrupter(const int seconds)
      {
        interruption::listen();
        sigevent event{};
        event.sigev_notify = SIGEV_SIGNAL;
        event.sigev_signo  = SIGTERM; // SIGINT may be ignored, as behind a shell in the background
        itimerspec time{};
        time.it_value.tv_sec = seconds;
        if (timer_create(CLOCK_PROCESS_CPUTIME_ID, &event, &timer) != 0 ||
            timer_settime(timer, 0, &time, nullptr) != 0)
          throw std::runtime_error("no timer");
      }

      ~Interrupter()
      {
        timer_delete(timer);
        interruption::listen();
      }

    private:
      timer_t timer;
    };

    template <int dim>
    void
    run(const SceneData &scene, const std::string &directory, const Writer &write)
    {
      tell(write, "dimension", dim);
      tell_axes(write, axes_of(scene));
      const std::string file      = write_scene(scene, directory, "scene");
      const auto start            = std::chrono::steady_clock::now();
      Parameters parameters       = read_parameters(file);
      parameters.output.directory = directory + "/out";
      auto model                  = std::make_unique<const Model<dim>>(parameters);
      if (scene.is_in_motion())
        {
          const Interrupter interrupter(time_of_motion);
          try
            {
              run_all_phases(std::move(model));
            }
          catch (const Interrupted &)
            {
              // Its files say so.
            }
        }
      else
        Simulation<dim>(*model).run();
      tell(write,
           "seconds",
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      const DynamicsDefinition &dynamics = parameters.model.dynamics;
      const std::string verdict =
        tell_summary(write,
                     directory,
                     dynamics.spectral_radius < 1. ? std::numeric_limits<double>::infinity()
                                                   : dynamics.event_tolerance);
      if (scene.is_in_motion())
        {
          const Interrupter interrupter(time_of_motion); // one step may have thousands of events
          tell_confirmation(write, confirm_motion<dim>(parameters, verdict, confirmation_time));
        }
      else
        ask_judges(write, *model, scene, verdict, directory);
    }
  } // namespace

  std::string
  write_scene(const SceneData &scene, const std::string &directory, const std::string &name)
  {
    const std::string file = directory + '/' + name + ".prm";
    std::ofstream(directory + '/' + name + ".msh") << scene.mesh_text();
    std::ofstream(file) << scene.parameter_text(name + ".msh");
    return file;
  }

  void
  run_scene(const std::string &kind,
            const std::uint64_t seed,
            const std::string &directory,
            const Writer &write)
  {
    set_threads(1);
    const auto scene = draw_scene(kind, seed);
    if (scene->dimension() == 3)
      run<3>(*scene, directory, write);
    else
      run<2>(*scene, directory, write);
  }
} // namespace fuga::stress

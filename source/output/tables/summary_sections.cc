// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/tables/summary_sections.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    void
    add_energies(const MotionLedger &energies, SummaryJson &json)
    {
      json["work"]              = energies.work;
      json["kinetic_energy"]    = energies.kinetic;
      json["energy_of_bodies"]  = energies.bodies;
      json["damping"]           = energies.damping;
      json["joint_work"]        = energies.joints;
      json["numerical"]         = energies.numerical;
      json["sudden"]            = energies.sudden;
      json["largest_energy"]    = energies.largest;
      json["not_accounted_for"] = energies.defect();
      json["rounding"]          = energies.rounding;
    }
  } // namespace

  SummaryJson
  safety_section(const std::vector<SafetyFactor> &factors)
  {
    SummaryJson json = SummaryJson::object();
    for (const SafetyFactor &safety : factors)
      {
        std::string key = safety.method;
        std::replace(key.begin(), key.end(), ' ', '_');
        SummaryJson &entry = json[key];
        entry = {{"factor", safety.found() ? SummaryJson(safety.factor) : SummaryJson()},
                 {"verdict", safety.verdict}};
        if (safety.verdict == SafetyFactor::largest_factor_reached)
          entry["factor_at_least"] = safety.factor;
        if (safety.mechanism != MechanismKind::none)
          {
            entry["mechanism"]        = mechanism_name(safety.mechanism);
            entry["mechanism_joints"] = safety.moving_joints;
            entry["motion"]           = safety.motion;
          }
        entry[safety.method == "load factor" ? "loads" : "joints"] = safety.acts_on;
        if (safety.verdict != SafetyFactor::not_computed)
          entry["t"] = safety.t;
      }
    return json;
  }

  SummaryJson
  accuracy_section(const AccuracyReport &accuracy)
  {
    SummaryJson rounds = SummaryJson::array();
    for (const AccuracyReport::Round &round : accuracy.rounds)
      rounds.push_back({{"cells", round.cells},
                        {"degrees_of_freedom", round.unknowns},
                        {"contact_elements", round.contact_elements},
                        {"estimated_error", round.estimate}});
    return {{"quantity", accuracy.quantity},
            {"target", accuracy.target},
            {"estimated_error", accuracy.rounds.back().estimate},
            {"reached", accuracy.reached},
            {"end", accuracy.end},
            {"rounds", rounds}};
  }

  SummaryJson
  motion_section(const MotionLedger &energies, const std::vector<std::size_t> &steps)
  {
    SummaryJson json = {{"steps_by_halvings", steps}};
    add_energies(energies, json);
    return json;
  }

  SummaryJson
  continuations_section(const std::vector<MotionBeyondLimit> &continuations)
  {
    SummaryJson json = SummaryJson::array();
    for (const MotionBeyondLimit &motion : continuations)
      {
        json.push_back({{"cause",
                         motion.loss.verdict == Verdict::done ? "dynamic stage"
                                                              : verdict_name(motion.loss.verdict)},
                        {"t", motion.loss.t},
                        {"t_of_loads", motion.t},
                        {"comes_to_rest", motion.rests},
                        {"seconds", motion.duration},
                        {"largest_velocity_at_end", motion.velocity},
                        {"largest_slip", motion.slip},
                        {"largest_opening", motion.opening},
                        {"friction_work", motion.friction}});
        add_energies(motion.energies, json.back());
      }
    return json;
  }
} // namespace fuga

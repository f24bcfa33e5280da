// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_judge_judge_memory_h
#define fuga_contact_judge_judge_memory_h

#include <fuga/base/fields.h>
#include <fuga/base/numerics/dense_matrix.h>

namespace fuga
{
  /** Energies since the start [MNm]. External work and the energy of the bodies do not include the
   * part that the loads would store in the fully bonded structure. */
  struct EnergyLedger
  {
    double external_work = 0.;
    double bodies        = 0.;
    double layer         = 0.;
    double dissipation   = 0.;
  };

  template <typename Ledger, typename Visitor, only_for<Ledger, EnergyLedger> = 0>
  void
  for_each_field(Ledger &ledger, Visitor &&visit)
  {
    auto &[external_work, bodies, layer, dissipation] = ledger;
    visit("external_work", external_work);
    visit("bodies", bodies);
    visit("layer", layer);
    visit("dissipation", dissipation);
  }

  /** The data that the judge remembers of the path that it followed. */
  struct JudgeMemory
  {
    EnergyLedger ledger;
    bool on_track = true;
    Vector element_dissipation;
    double largest_force   = 0.;
    double largest_jump    = 0.;
    double largest_energy  = 0.;
    double largest_load    = 0.;
    double wrong_slip_work = 0.;
    double wrong_rise      = 0.;
    /** Energy of the bodies from earlier phases of construction. */
    double energy_of_bodies_before = 0.;
    /** True while time steps are judged; at_rest are the energies when they began. */
    bool in_motion = false;
    EnergyLedger at_rest;
  };

  template <typename Memory, typename Visitor, only_for<Memory, JudgeMemory> = 0>
  void
  for_each_field(Memory &memory, Visitor &&visit)
  {
    auto &[ledger,
           on_track,
           element_dissipation,
           largest_force,
           largest_jump,
           largest_energy,
           largest_load,
           wrong_slip_work,
           wrong_rise,
           energy_of_bodies_before,
           in_motion,
           at_rest] = memory;
    visit("ledger", ledger);
    visit("on_track", on_track);
    visit("element_dissipation", element_dissipation);
    visit("largest_force", largest_force);
    visit("largest_jump", largest_jump);
    visit("largest_energy", largest_energy);
    visit("largest_load", largest_load);
    visit("wrong_slip_work", wrong_slip_work);
    visit("wrong_rise", wrong_rise);
    visit("energy_of_bodies_before", energy_of_bodies_before);
    visit("in_motion", in_motion);
    visit("at_rest", at_rest);
  }
} // namespace fuga

#endif

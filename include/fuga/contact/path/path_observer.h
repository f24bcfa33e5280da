// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_path_observer_h
#define fuga_contact_path_path_observer_h

#include <fuga/contact/load_history.h>
#include <fuga/contact/segments/path_segment.h>

#include <array>

namespace fuga
{
  /** A single change of the working scheme. */
  struct ContactEvent
  {
    double t            = 0.;
    std::size_t element = 0;
    ContactState from   = ContactState::stick;
    ContactState to     = ContactState::stick;
    /** Number of continuations known at this load: 1 unless friction is beyond critical. */
    std::size_t n_branches = 1;
    /** The origin of the water before and after this event, if the event is a connection of an open
     * element with reservoir or tailwater that appears or disappears; otherwise twice the same. */
    std::array<WaterAccess, 2> water = {{WaterAccess::seepage, WaterAccess::seepage}};

    /** Return the words for the state before and after the event, as used in all output. */
    std::array<std::string_view, 2>
    names() const
    {
      if (water[0] != water[1])
        return {{access_name(water[0]), access_name(water[1])}};
      return {{state_name(from), state_name(to)}};
    }
  };

  /** Receives the path as it is found. All calls are made in the order of the load time. */
  class PathObserver
  {
  public:
    virtual ~PathObserver() = default;

    /** Return whether EventPath::last_cut() is to be kept up to date. */
    virtual bool
    wants_cuts() const
    {
      return false;
    }

    /** Return whether the path is to go on after what it has reported. If not, its result is that
     * of the part which was followed. */
    virtual bool
    wants_more() const
    {
      return true;
    }

    /** The path went smoothly from @p from to @p to, which are @p length apart in τ. */
    virtual void
    advanced(const PathPoint &from, const PathPoint &to, const double length) = 0;

    /** The path went to @p to by an implicit step; what happened in between is not known. */
    virtual void
    jumped(const JointState &to) = 0;

    /** The path jumped within a step of bodies in motion, with work on the joints [MNm], see
     * StepRecord. */
    virtual void
    jumped_in_motion(const JointState &to, const double /*work*/)
    {
      jumped(to);
    }

    /** The scheme changed; @p state has the new states. */
    virtual void
    changed(const std::vector<ContactEvent> &events, const JointState &state) = 0;

    /** A requested load time was reached; @p index counts them. */
    virtual void
    reached(const std::size_t index, const JointState &state) = 0;

    /** The bodies begin to move with their inertia; time steps follow. */
    virtual void
    began_motion()
    {
    }

    /** A time step begins: from here on the bodies resist as @p system does, under the loads
     * @p history of the step. */
    virtual void
    began_step(const ContactSystem & /*system*/, const LoadHistory & /*history*/)
    {
    }

    /** The time step has ended in @p state, and everything else in it has been reported. */
    virtual void
    ended_step(const JointState & /*state*/)
    {
    }

    /** The path has reached a state beyond the limit load, after the largest jump has grown by
     * @p length. This is called at the limit, and at the end of every step; the load time may stay
     * constant or fall here. */
    virtual void
    went_beyond(const double /*length*/, const JointState & /*state*/)
    {
    }
  };

  /**
   * Report a segment whose end has been found, from station to station, with a stop at every
   * requested load time beginning with number @p next_level, which is incremented. Return the state
   * at the end.
   */
  JointState
  report_piecewise(PathSegment &segment,
                   const Course &course,
                   const std::vector<double> &levels,
                   std::size_t &next_level,
                   PathObserver &observer);
} // namespace fuga

#endif

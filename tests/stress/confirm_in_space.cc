// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/confirm_in_space.h"

#include "stress/cone_examiner.h"
#include "stress/run_scene.h"

#include <fuga/base/errors.h>
#include <fuga/contact/judge/judge.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/output/tables/summary.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga::stress
{
  namespace
  {
    /** Two paths this close are the same one. */
    constexpr double same_path = 1e-6;

    /** The plane path of an extruded scene. */
    struct SectionPath
    {
      SectionPath(const SceneData &section, const std::string &directory)
        : model(read_parameters(write_scene(section, directory, "section")))
        , joint(make_joint_model<2>(
            model.bodies, model.parameters.joints, model.parameters.model.constants))
        , layered(model.bodies, joint.elements)
        , sample(1)
        , result(std::make_unique<EventPath>(
                   joint.elements, layered, model.loads.history, model.path_options())
                   ->run(model.loads.levels, sample))
      {
      }

      const Model<2> model;
      const JointModel joint;
      const LayeredSystem layered;
      PieceSample sample;
      const PathResult result;
    };

    /** What an element carries and how far it has opened and slipped, whatever its frame is. */
    struct ElementState
    {
      double pressure = 0., shear = 0., opening = 0., slip = 0.;
    };

    ElementState
    state_of(const ContactElement &element, const JointState &state)
    {
      const auto shear_size = [&](const Vector &of_bars) {
        return std::hypot(
          element.has_tangential_bar() ? of_bars[element.tangential_bar] : 0.,
          element.has_second_tangential_bar() ? of_bars[element.second_tangential_bar] : 0.);
      };
      return {-state.forces[element.normal_bar] / element.area,
              shear_size(state.forces) / element.area,
              state.dislocations[element.normal_bar],
              shear_size(state.dislocations)};
    }

    /** The element of the section in the same joint that is nearest to one in space. */
    const ContactElement &
    counterpart(const ContactElement &element, const std::vector<ContactElement> &of_section)
    {
      const auto distance = [&](const ContactElement &other) {
        return other.joint == element.joint ? std::hypot(other.position[0] - element.position[0],
                                                         other.position[1] - element.position[2])
                                            : std::numeric_limits<double>::infinity();
      };
      return *std::min_element(
        of_section.begin(), of_section.end(), [&](const auto &a, const auto &b) {
          return distance(a) < distance(b);
        });
    }

    /** Largest sizes along a path: differences are measured by them. */
    struct Sizes
    {
      double stress = 0., length = 0.;
    };

    Sizes
    sizes_of(const SectionPath &section)
    {
      Sizes result;
      for (const JointState &state : section.sample.levels)
        {
          // What the closed joint would carry counts too: the open one carries only rounding.
          const Vector closed = section.layered.forces(section.model.loads.history.factors(state.t),
                                                       Vector(section.layered.n_bars(), 0.));
          for (const ContactElement &element : section.joint.elements)
            {
              const ElementState at = state_of(element, state);
              result.stress         = std::max({result.stress,
                                                std::abs(at.pressure),
                                                at.shear,
                                                std::abs(closed[element.normal_bar]) / element.area});
              result.length         = std::max({result.length, std::abs(at.opening), at.slip});
            }
        }
      return result;
    }

    double
    difference(const std::vector<ContactElement> &in_space,
               const JointState &state,
               const std::vector<ContactElement> &of_section,
               const JointState &state_of_section,
               const Sizes &sizes)
    {
      double stress = 0., length = 0.;
      for (const ContactElement &element : in_space)
        {
          const ElementState ours   = state_of(element, state);
          const ElementState theirs = state_of(counterpart(element, of_section), state_of_section);
          stress                    = std::max({stress,
                                                std::abs(ours.pressure - theirs.pressure),
                                                std::abs(ours.shear - theirs.shear)});
          length                    = std::max(
            {length, std::abs(ours.opening - theirs.opening), std::abs(ours.slip - theirs.slip)});
        }
      return std::max(share(stress, sizes.stress), share(length, sizes.length));
    }

    /** What differs; empty if nothing does. In space more than one continuation may exist where the
     * section has only one: its elements across the thickness need not move alike. */
    std::string
    compare_with_section(const SectionPath &section,
                         const JointModel &joint,
                         const PathResult &result,
                         const PieceSample &sample,
                         Confirmation &confirmation)
    {
      const bool several = result.verdict == Verdict::non_unique_continuation;
      if (several ? section.result.t < (1. - same_path) * result.t
                  : result.verdict != section.result.verdict ||
                      std::abs(result.t - section.result.t) > same_path * section.result.t)
        return fmt::format("the plane section ends at t = {:.9g}, {}, not {:.9g}",
                           section.result.t,
                           verdict_name(section.result.verdict),
                           result.t);
      const Sizes sizes = sizes_of(section);
      for (std::size_t l = 0; l < sample.levels.size(); ++l)
        {
          const double error = difference(joint.elements,
                                          sample.levels[l],
                                          section.joint.elements,
                                          section.sample.levels[l],
                                          sizes);
          if (error > same_path)
            return fmt::format(
              "at t = {:.9g} the plane section differs by {:.1e}", sample.levels[l].t, error);
          confirmation.difference = std::max(confirmation.difference, error);
          ++confirmation.n_equal;
        }
      return {};
    }

    void
    confirm_by_section(const SceneData &scene,
                       const JointModel &joint,
                       const PathResult &result,
                       const PieceSample &sample,
                       const std::string &directory,
                       Confirmation &confirmation)
    {
      const SectionPath section(*scene.plane_section(), directory);
      const std::string difference =
        compare_with_section(section, joint, result, sample, confirmation);
      // Beyond critical friction both may be right; and where rigid joints meet, elements get a
      // compliance from the cells around them, which are not those of the section.
      const bool may_differ = section.result.n_non_unique > 0 || !joint.report.empty();
      if (difference.empty())
        // That there are several continuations is not what the section shows.
        confirmation.by =
          result.verdict == Verdict::non_unique_continuation ? "certificate" : "plane section";
      else if (may_differ)
        confirmation.by = "certificate";
      else
        confirmation.objection = difference;
    }

    void
    confirm_end(const ConeExaminer &examiner,
                const PathResult &result,
                const JointState &end,
                Confirmation &confirmation)
    {
      // Where directions of slip still turn, the path ends up to 1e-6 before a limit load, and up
      // to 1e-9 before a maximum of the load, beyond which a longer step finds the end of a jump.
      const std::array<double, 2> parts = result.verdict == Verdict::no_continuation
                                            ? std::array<double, 2>{{1e-7, 1e-6}}
                                            : std::array<double, 2>{{1e-4, 1e-3}};
      const auto goes_on                = [&] {
        return std::any_of(parts.begin(), parts.end(), [&](const double part) {
          return examiner.finds_step_beyond(end, part);
        });
      };
      if (!examiner.can_solve(end))
        confirmation.by = "certificate"; // laws or strengths that ConeNewton does not know
      else if (!result.mechanism_jumps.empty() &&
               examiner.is_mechanism(end, result.mechanism_jumps))
        confirmation.by = "mechanism";
      else if (result.verdict == Verdict::non_unique_continuation)
        // That there is a way on is part of the verdict; whether there are others is not examined.
        confirmation.by = goes_on() ? "implicit step" : "certificate";
      else if (goes_on())
        confirmation.objection += "an implicit step goes on; ";
      else
        confirmation.by = "no implicit step";
    }

    void
    confirm_by_steps(const Model<3> &model,
                     const JointModel &joint,
                     const PathResult &result,
                     const PieceSample &sample,
                     const double seconds,
                     Confirmation &confirmation)
    {
      using Clock      = std::chrono::steady_clock;
      const auto start = Clock::now();
      const ConeExaminer examiner(model, joint);
      const auto check = [&](const PieceSample::Piece &piece) {
        if (examiner.can_solve(piece.from) &&
            std::chrono::duration<double>(Clock::now() - start).count() < seconds)
          count_piece(examiner.examine_step(piece.from, piece.to), piece.to.t, confirmation);
      };
      if (sample.last)
        check(*sample.last);
      for (const PieceSample::Piece &piece : sample.pieces)
        check(piece);
      if (result.verdict != Verdict::done)
        confirm_end(examiner, result, end_of(sample, joint), confirmation);
      else if (confirmation.objection.empty())
        confirmation.by = confirmation_by_pieces(confirmation);
    }
  } // namespace

  Confirmation
  confirm_in_space(const SceneData &scene,
                   const Model<3> &model,
                   const JointModel &joint,
                   const PathResult &result,
                   const PieceSample &sample,
                   const std::string &directory,
                   const double seconds)
  {
    Confirmation confirmation;
    if (scene.plane_section())
      confirm_by_section(scene, joint, result, sample, directory, confirmation);
    else
      confirm_by_steps(model, joint, result, sample, seconds, confirmation);
    return confirmation;
  }

  std::string
  what_others_find(const SceneData &scene,
                   const Model<3> &model,
                   const JointModel &joint,
                   const PieceSample &sample,
                   const std::string &directory)
  try
    {
      if (!scene.plane_section())
        {
          const ConeExaminer examiner(model, joint);
          const JointState end = end_of(sample, joint);
          return !examiner.can_solve(end) ? "; ConeNewton does not know its laws or strengths"
                 : examiner.finds_step_beyond(end, 1e-4) ? "; an implicit step goes on"
                                                         : "; no implicit step is found either";
        }
      const SectionPath section(*scene.plane_section(), directory);
      return fmt::format("; the plane section: {} at t = {:.9g}",
                         verdict_name(section.result.verdict),
                         section.result.t);
    }
  catch (const NumericalFailure &)
    {
      return "; the plane section: numerical failure";
    }
} // namespace fuga::stress

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_stress_confirm_h
#define fuga_tests_stress_confirm_h

#include "stress/step_report.h"

#include <fuga/contact/path/event_path.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/run/model/model.h>

#include <optional>
#include <string>

namespace fuga::stress
{
  /**
   * Keeps of a path what the independent solvers are asked about: the first and the last pieces
   * that have a length, and some between, chosen by their number alone.
   */
  class PieceSample : public PathObserver
  {
  public:
    explicit PieceSample(const std::size_t n_kept) : capacity(n_kept)
    {
    }

    struct Piece
    {
      JointState from, to;
    };

    std::vector<Piece> pieces;
    std::optional<Piece> last;
    JointState end;
    /** At the load levels that were reached. */
    std::vector<JointState> levels;

    void
    advanced(const PathPoint &from, const PathPoint &to, const double length) override;
    void
    jumped(const JointState &to) override;
    void
    changed(const std::vector<ContactEvent> &events, const JointState &state) override;
    void
    reached(const std::size_t index, const JointState &state) override;

  private:
    const std::size_t capacity;
    std::size_t n_seen = 0;
  };

  /** What independent solvers say about a path. */
  struct Confirmation
  {
    /** How the verdict was confirmed; empty if it was not. */
    std::string by;
    /** What contradicts the path, or why nothing could be said. */
    std::string objection;
    /** Pieces solved again with the same answer, and those where the answer of the path satisfies
     * all conditions but the other solver found another one or none. */
    std::size_t n_equal = 0, n_other = 0;
    /** Largest difference of the equal ones. */
    double difference = 0.;
  };

  /** Nothing loaded; closed but for initial gaps: a path may end where it begins. */
  JointState
  virgin_state(const JointModel &joint);

  /** Where a path has come to. */
  JointState
  end_of(const PieceSample &sample, const JointModel &joint);

  /** Whether a layer has closed as far as its law reaches, by the forces of @p state. */
  bool
  law_is_exhausted(const std::vector<ContactElement> &elements, const JointState &state);

  /** Counts a step to load time @p t. */
  void
  count_piece(const StepReport &report, const double t, Confirmation &confirmation);

  /** What the pieces of a path that was done say together. */
  std::string
  confirmation_by_pieces(const Confirmation &confirmation);

  /** @p seconds: time after which no further piece is looked at. */
  Confirmation
  confirm(const Model<2> &model,
          const JointModel &joint,
          const PathResult &result,
          const PieceSample &sample,
          const double seconds);
} // namespace fuga::stress

#endif

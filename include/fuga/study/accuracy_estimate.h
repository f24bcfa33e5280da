// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_study_accuracy_estimate_h
#define fuga_study_accuracy_estimate_h

#include <fuga/bodies/space/cell_coordinates.h>
#include <fuga/study/trial_run.h>

#include <map>

namespace fuga
{
  /**
   * Estimates the relative error of the quantity that Parameters::accuracy names, from runs on a
   * mesh and on the same mesh refined once more (doc/theory.md, section 14). Mean squares of the
   * pressure are computed over the area of the elements that count.
   */
  template <int dim>
  class AccuracyEstimate
  {
  public:
    /**
     * Compute the estimate. @throws InputError if no contact element lies where the pressure
     * counts.
     */
    AccuracyEstimate(const TrialRun<dim> &coarse, const TrialRun<dim> &fine);

    /**
     * Return the relative error of the whole run; not a number if the quantity is zero at all
     * levels.
     */
    double
    relative_error() const
    {
      return error;
    }

  private:
    /**
     * An element, and the elements of the fine system whose pressures determine the pressure at its
     * place.
     */
    struct Place
    {
      std::size_t element;
      std::vector<std::pair<unsigned int, double>> neighbours;
    };

    /** Difference and size of the quantity at one level, squared. */
    struct Squares
    {
      double difference = 0., size = 0.;
    };

    using Level = typename TrialRun<dim>::Level;
    /**
     * The fine faces into which a face of a joint was divided, by its cell and its number on this
     * cell.
     */
    using FineFaces =
      std::map<std::pair<unsigned int, unsigned int>, std::vector<const JointFace *>>;

    void
    find_places();
    FineFaces
    fine_faces() const;
    Place
    place_of(const std::size_t element,
             const std::array<double, 3> &position,
             const std::vector<const JointFace *> &faces) const;
    Squares
    compare_pressures(const Level &coarse_level, const Level &fine_level) const;
    Squares
    compare_numbers(const Level &coarse_level, const Level &fine_level) const;
    Vector
    numbers(const TrialRun<dim> &run, const Level &level) const;

    const TrialRun<dim> &coarse, &fine;
    const AccuracyTarget &target;
    std::vector<Place> places;
    double error;
  };
} // namespace fuga

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/accuracy_estimate.h>
#include <fuga/base/errors.h>
#include <fuga/dual_fields.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    using Quantity = AccuracyTarget::Quantity;

    /** Error of a mesh over the difference to the mesh refined once more, if it falls like the size
     * of the cells (pressures) or its square (single numbers). */
    double
    error_over_difference(const Quantity quantity)
    {
      return quantity == Quantity::pressure ? 2. : 4. / 3.;
    }

    double
    distance(const std::array<double, 3> &a, const std::array<double, 3> &b)
    {
      return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
  } // namespace


  template <int dim>
  AccuracyEstimate<dim>::AccuracyEstimate(const TrialRun<dim> &coarse_run,
                                          const TrialRun<dim> &fine_run)
    : coarse(coarse_run), fine(fine_run), target(coarse_run.model().parameters.accuracy)
  {
    if (target.quantity == Quantity::pressure)
      find_places();
    Squares largest;
    for (const auto &[at_coarse, at_fine] : common_levels(coarse, fine))
      {
        const Squares squares = target.quantity == Quantity::pressure
                                  ? compare_pressures(*at_coarse, *at_fine)
                                  : compare_numbers(*at_coarse, *at_fine);
        largest.difference    = std::max(largest.difference, squares.difference);
        largest.size          = std::max(largest.size, squares.size);
      }
    error = largest.size > 0. ? error_over_difference(target.quantity) *
                                  std::sqrt(largest.difference / largest.size)
                              : std::numeric_limits<double>::quiet_NaN();
  }


  // Every place is looked for in the fine faces that its own face was divided into. Between the
  // nodes of these the pressure is taken as linear; the nodes of the coarse mesh are among them for
  // degrees 1, 2.
  template <int dim>
  void
  AccuracyEstimate<dim>::find_places()
  {
    const Model<dim> &model  = coarse.model();
    std::vector<bool> counts = counting_elements(model);
    for (const JointFace &face : model.bodies.joint_faces())
      {
        const std::vector<Segment> segments = fine_segments(face);
        for (std::size_t i = 0; i < face.elements.size(); ++i)
          if (const unsigned int k = face.elements[i]; k != JointFace::no_element && counts[k])
            {
              places.push_back(place_of(k, face.positions[i], segments));
              counts[k] = false; // the next face need not
            }
      }
    if (places.empty())
      throw InputError(fmt::format(
        "{}: the mesh has no contact element where the pressure counts. Let 'Where' be 1 "
        "somewhere on the joints, or refine the mesh there.",
        target.origin));
  }


  template <int dim>
  std::vector<typename AccuracyEstimate<dim>::Segment>
  AccuracyEstimate<dim>::fine_segments(const JointFace &coarse_face) const
  {
    constexpr double tolerance = 1e-6; // of the length of a face
    std::vector<Segment> segments;
    const auto &begin = coarse_face.positions.front(), &end = coarse_face.positions.back();
    for (const JointFace &face : fine.model().bodies.joint_faces())
      {
        if (face.joint != coarse_face.joint)
          continue;
        std::array<double, 3> middle;
        for (unsigned int c = 0; c < 3; ++c)
          middle[c] = 0.5 * (face.positions.front()[c] + face.positions.back()[c]);
        if (distance(begin, middle) + distance(middle, end) <
            (1. + tolerance) * distance(begin, end))
          for (std::size_t i = 0; i + 1 < face.elements.size(); ++i)
            segments.push_back({&face, i});
      }
    return segments;
  }


  template <int dim>
  typename AccuracyEstimate<dim>::Place
  AccuracyEstimate<dim>::place_of(const std::size_t element,
                                  const std::array<double, 3> &position,
                                  const std::vector<Segment> &segments) const
  {
    double least = std::numeric_limits<double>::infinity();
    Place place{element, {}};
    for (const auto &[face, i] : segments)
      {
        const double to_first  = distance(position, face->positions[i]),
                     to_second = distance(position, face->positions[i + 1]),
                     detour =
                       to_first + to_second - distance(face->positions[i], face->positions[i + 1]);
        if (detour >= least)
          continue;
        least               = detour;
        const double second = to_first / (to_first + to_second);
        place.neighbours    = {{{face->elements[i], 1. - second}, {face->elements[i + 1], second}}};
      }
    return place;
  }


  template <int dim>
  typename AccuracyEstimate<dim>::Squares
  AccuracyEstimate<dim>::compare_pressures(const Level &coarse_level, const Level &fine_level) const
  {
    Squares result;
    for (const Place &place : places)
      {
        double there = 0.;
        for (const auto &[element, weight] : place.neighbours)
          if (weight > 0. && element != JointFace::no_element)
            there += weight * fine_level.results[element].pressure;
        const double area = coarse.model().bodies.elements()[place.element].area;
        result.difference +=
          area * std::pow(coarse_level.results[place.element].pressure - there, 2);
        result.size += area * there * there;
      }
    return result;
  }


  template <int dim>
  typename AccuracyEstimate<dim>::Squares
  AccuracyEstimate<dim>::compare_numbers(const Level &coarse_level, const Level &fine_level) const
  {
    const Vector here = numbers(coarse, coarse_level), there = numbers(fine, fine_level);
    Squares result;
    for (std::size_t i = 0; i < here.size(); ++i)
      {
        result.difference += std::pow(here[i] - there[i], 2);
        result.size += there[i] * there[i];
      }
    return result;
  }


  template <int dim>
  Vector
  AccuracyEstimate<dim>::numbers(const TrialRun<dim> &run, const Level &level) const
  {
    Vector result;
    for (const unsigned int item : target.items)
      {
        std::array<double, 3> values;
        if (target.quantity == Quantity::monitor)
          values = run.model().monitors[item].displacement(level.x, level.a);
        else
          {
            const JointResultant &r = level.resultants[item];
            values                  = {{r.N, r.T, r.M}};
          }
        for (const unsigned int component : target.components)
          result.push_back(values[component]);
      }
    return result;
  }


  template class AccuracyEstimate<2>;
} // namespace fuga

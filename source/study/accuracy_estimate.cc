// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/fe/fe.h>

#include <fuga/base/errors.h>
#include <fuga/study/accuracy_estimate.h>
#include <fuga/study/dual_fields.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    using Quantity = AccuracyTarget::Quantity;

    /** Return the ratio of the error of a mesh to its difference from the mesh refined once more,
     * if the error decreases like the size of the cells (pressures) or its square (single
     * numbers). */
    double
    error_over_difference(const Quantity quantity)
    {
      return quantity == Quantity::pressure ? 2. : 4. / 3.;
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


  // Every place is looked for in the fine faces into which its own face was divided, where the
  // pressure is interpolated from its nodes by the shape functions of the face. For degrees 1 and 2
  // the nodes of the coarse mesh are among them. A node that hangs on one other node is at its
  // place.
  template <int dim>
  void
  AccuracyEstimate<dim>::find_places()
  {
    const Model<dim> &model  = coarse.model();
    std::vector<bool> counts = counting_elements(model);
    const FineFaces children = fine_faces();
    for (const JointFace &face : model.bodies.joint_faces())
      for (std::size_t i = 0; i < face.shares.size(); ++i)
        if (const auto &shares = face.shares[i]; shares.size() == 1 && counts[shares[0].first] &&
                                                 std::abs(shares[0].second - 1.) < 1e-10)
          {
            places.push_back(
              place_of(shares[0].first, face.positions[i], children.at({face.cell, face.number})));
            counts[shares[0].first] = false; // the next face need not be searched for it
          }
    if (places.empty())
      throw InputError(fmt::format(
        "{}: the mesh has no contact element where the pressure counts. Let 'Where' be 1 "
        "somewhere on the joints, or refine the mesh there.",
        target.origin));
  }


  // Children follow each other in the tables, in the order of their parents; a child has the same
  // numbering of faces as its parent.
  template <int dim>
  auto
  AccuracyEstimate<dim>::fine_faces() const -> FineFaces
  {
    constexpr unsigned int n_children = 1u << dim;
    FineFaces result;
    for (const JointFace &face : fine.model().bodies.joint_faces())
      result[{face.cell / n_children, face.number}].push_back(&face);
    return result;
  }


  template <int dim>
  typename AccuracyEstimate<dim>::Place
  AccuracyEstimate<dim>::place_of(const std::size_t element,
                                  const std::array<double, 3> &position,
                                  const std::vector<const JointFace *> &faces) const
  {
    const Discretization<dim> &space = fine.model().bodies.discretization();
    dealii::Point<dim> point;
    for (unsigned int c = 0; c < dim; ++c)
      point[c] = position[c];
    Place place{element, {}};
    LoneCell<dim> alone(space);
    for (const JointFace *face : faces)
      {
        const auto inside = alone.coordinates(face->cell, point);
        if (!inside)
          continue;
        const auto &nodes = space.reference_element().face(face->number).nodes;
        for (std::size_t i = 0; i < nodes.size(); ++i)
          if (const double value =
                space.reference_element().scalar_element().shape_value(nodes[i], *inside);
              std::abs(value) > 10. * inside_tolerance)
            for (const auto &[k, weight] : face->shares[face->backwards ? nodes.size() - 1 - i : i])
              place.neighbours.emplace_back(k, value * weight);
        break;
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
        Vector values;
        if (target.quantity == Quantity::monitor)
          {
            const auto u = run.model().monitors[item].displacement(level.x, level.a);
            values.assign(u.begin(), u.end());
          }
        else
          {
            const JointResultant &r = level.resultants[item];
            values                  = {r.N, r.T, r.M, r.T2, r.M1, r.Mn};
          }
        for (const unsigned int component : target.components)
          result.push_back(values[component]);
      }
    return result;
  }


  template class AccuracyEstimate<2>;
  template class AccuracyEstimate<3>;
} // namespace fuga

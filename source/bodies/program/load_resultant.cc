// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/program/load_resultant.h>

#include <algorithm>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** Share of all the forces below which a sum is rounding. */
    constexpr double zero_share = 1e-11;
  } // namespace


  template <int dim>
  void
  LoadResultant<dim>::add(const dealii::Point<dim> &place, const dealii::Tensor<1, dim> &force)
  {
    sum += force;
    moments += outer_product(force, static_cast<const dealii::Tensor<1, dim> &>(place));
    size += force.norm();
    for (unsigned int c = 0; c < dim; ++c)
      reach = std::max(reach, std::abs(place[c]));
  }


  template <int dim>
  void
  LoadResultant<dim>::scale(const double factor)
  {
    sum *= factor;
    moments *= factor;
    size *= std::abs(factor);
  }


  template <int dim>
  void
  LoadResultant<dim>::add(const LoadResultant &other)
  {
    sum += other.sum;
    moments += other.moments;
    size += other.size;
    reach = std::max(reach, other.reach);
  }


  template <int dim>
  double
  LoadResultant<dim>::force(const unsigned int component) const
  {
    return std::abs(sum[component]) > zero_share * size ? sum[component] : 0.;
  }


  template <int dim>
  double
  LoadResultant<dim>::place(const unsigned int component, const unsigned int coordinate) const
  {
    const double moment = moments[component][coordinate];
    return std::abs(moment) > zero_share * size * reach ? moment / sum[component] : 0.;
  }


  template <int dim>
  std::array<double, 3>
  LoadResultant<dim>::couple() const
  {
    dealii::Tensor<2, dim> left;
    for (unsigned int c = 0; c < dim; ++c)
      if (force(c) == 0.)
        left[c] = moments[c];
    std::array<double, 3> result{};
    if constexpr (dim == 2)
      result[2] = left[1][0] - left[0][1];
    else
      for (unsigned int c = 0; c < 3; ++c)
        result[c] = left[(c + 2) % 3][(c + 1) % 3] - left[(c + 1) % 3][(c + 2) % 3];
    for (double &moment : result)
      if (std::abs(moment) <= zero_share * size * reach)
        moment = 0.;
    return result;
  }


  template <int dim>
  LoadResultant<dim>
  resultant_of(const Discretization<dim> &space, const Vector &forces)
  {
    LoadResultant<dim> result;
    for (std::size_t node = 0; node < space.n_nodes(); ++node)
      {
        dealii::Tensor<1, dim> force;
        for (unsigned int c = 0; c < dim; ++c)
          force[c] = forces[node * dim + c];
        if (force.norm_square() > 0.)
          result.add(space.position(node), force);
      }
    return result;
  }


  template <int dim>
  LoadResultant<dim>
  resultant_of_water(const CondensedSystem<dim> &system,
                     const unsigned int joint,
                     const Vector &water)
  {
    LoadResultant<dim> result;
    for (std::size_t k = 0; k < system.elements().size(); ++k)
      if (const ContactElement &element = system.elements()[k]; element.joint == joint)
        {
          dealii::Point<dim> place;
          dealii::Tensor<1, dim> force;
          for (unsigned int c = 0; c < dim; ++c)
            {
              place[c] = element.position[c];
              force[c] = water[element.normal_bar] * system.normal(k)[c];
            }
          result.add(place, force);
        }
    return result;
  }


  template class LoadResultant<2>;
  template class LoadResultant<3>;
  template LoadResultant<2>
  resultant_of(const Discretization<2> &, const Vector &);
  template LoadResultant<3>
  resultant_of(const Discretization<3> &, const Vector &);
  template LoadResultant<2>
  resultant_of_water(const CondensedSystem<2> &, const unsigned int, const Vector &);
  template LoadResultant<3>
  resultant_of_water(const CondensedSystem<3> &, const unsigned int, const Vector &);
} // namespace fuga

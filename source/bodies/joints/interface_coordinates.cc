// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/joints/interface_coordinates.h>

#include <algorithm>

namespace fuga
{
  template <int dim>
  InterfaceCoordinates<dim>::InterfaceCoordinates(const Discretization<dim> &discretization,
                                                  const ContactBars<dim> &bars,
                                                  const std::vector<bool> &fixed,
                                                  const Vector &stiffness)
    : n_dofs(discretization.n_dofs())
  {
    const InterfaceRows<dim> at_joints(bars, fixed, stiffness, constraints);
    hang_nodes(discretization.hanging_nodes(), fixed);
    constraints.close();
    number(fixed, at_joints.has_bar());
    B = at_joints.jump_operator();
  }


  // A held node that hangs takes only the displacements that supports prescribe for its masters.
  template <int dim>
  void
  InterfaceCoordinates<dim>::hang_nodes(const HangingNodes<dim> &hanging,
                                        const std::vector<bool> &fixed)
  {
    for (const auto &[node, masters] : hanging.masters())
      for (unsigned int c = 0; c < dim; ++c)
        {
          constraints.add_line(node * dim + c);
          for (const auto &[master, weight] : masters)
            if (!fixed[node * dim + c] || fixed[master * dim + c])
              constraints.add_entry(node * dim + c, master * dim + c, weight);
        }
  }


  // The numbers are those of degrees of freedom, slides, and interface coordinates, in this order.
  template <int dim>
  void
  InterfaceCoordinates<dim>::number(const std::vector<bool> &fixed,
                                    const std::vector<bool> &has_bar)
  {
    numbers.assign(n_dofs + has_bar.size(), -1);
    int count = 0;
    for (unsigned int dof = 0; dof < n_dofs; ++dof)
      if (!fixed[dof] && !constraints.is_constrained(dof))
        numbers[dof] = count++;
    for (const bool is_interface : {false, true})
      for (std::size_t jump = 0; jump < has_bar.size(); ++jump)
        if (has_bar[jump] == is_interface)
          numbers[n_dofs + jump] = count++;
    n_coordinates   = static_cast<unsigned int>(count);
    interface_count = static_cast<unsigned int>(std::count(has_bar.begin(), has_bar.end(), true));
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::terms_of(const std::size_t dof, std::vector<Term> &terms) const
  {
    terms.clear();
    if (numbers[dof] >= 0)
      terms.push_back({plain_coordinate(dof), 1.});
    else if (const auto *entries =
               constraints.get_constraint_entries(static_cast<unsigned int>(dof)))
      for (const auto &[unknown, factor] : *entries)
        if (numbers[unknown] >= 0)
          terms.push_back({plain_coordinate(unknown), factor});
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::distribute(const double *y, const Vector &u) const
  {
    const auto value = [&](const std::size_t unknown) {
      return numbers[unknown] < 0 ? 0. : y[numbers[unknown]];
    };
    Vector sum = u.empty() ? Vector(n_dofs, 0.) : u;
    for (std::size_t dof = 0; dof < n_dofs; ++dof)
      sum[dof] += value(dof);
    for (const auto &line : constraints.get_lines())
      for (const auto &[unknown, factor] : line.entries)
        sum[line.index] += factor * value(unknown);
    return sum;
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::gather(const Vector &forces) const
  {
    Vector result(n_coordinates, 0.);
    for (std::size_t dof = 0; dof < n_dofs; ++dof)
      if (numbers[dof] >= 0)
        result[plain_coordinate(dof)] += forces[dof];
    for (const auto &line : constraints.get_lines())
      for (const auto &[unknown, factor] : line.entries)
        if (numbers[unknown] >= 0)
          result[plain_coordinate(unknown)] += factor * forces[line.index];
    return result;
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::extend_prescribed(Vector &prescribed) const
  {
    for (const auto &line : constraints.get_lines())
      {
        double sum = 0.;
        for (const auto &[unknown, factor] : line.entries)
          if (unknown < n_dofs && numbers[unknown] < 0)
            sum += factor * prescribed[unknown];
        prescribed[line.index] = sum;
      }
  }


  template class InterfaceCoordinates<2>;
  template class InterfaceCoordinates<3>;
} // namespace fuga

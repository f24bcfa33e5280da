// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/interface_coordinates.h>

#include <map>

namespace fuga
{
  template <int dim>
  InterfaceCoordinates<dim>::InterfaceCoordinates(const Discretization<dim> &discretization,
                                                  const ContactBars<dim> &bars,
                                                  const std::vector<bool> &fixed,
                                                  const Vector &stiffness)
    : rows(discretization.n_dofs(), InterfaceRows<dim>::unset)
    , hanging(discretization.hanging_nodes())
  {
    for (const auto &entry : hanging.masters())
      for (unsigned int c = 0; c < dim; ++c)
        rows[entry.first * dim + c] = -1; // until add_hanging_nodes()
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (fixed[dof])
        rows[dof] = -1;
    const InterfaceRows<dim> at_joints(bars, fixed, stiffness, rows);
    interface_count = at_joints.n_interface();
    hangs_on        = at_joints.hangs_on();
    number(at_joints);
    add_hanging_nodes(fixed);
    B = at_joints.jump_operator();
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::number(const InterfaceRows<dim> &at_joints)
  {
    unsigned int count = 0;
    for (int &row : rows)
      if (row == InterfaceRows<dim>::unset)
        row = static_cast<int>(count++);
    const unsigned int first_slide = count, first_interface = count + at_joints.n_slides();
    n_coordinates = first_interface + interface_count;

    special.resize(at_joints.special().size());
    for (std::size_t i = 0; i < special.size(); ++i)
      for (const auto &term : at_joints.special()[i])
        {
          unsigned int coordinate = static_cast<unsigned int>(term.index);
          if (term.kind == InterfaceRows<dim>::Kind::interface)
            coordinate += first_interface;
          else if (term.kind == InterfaceRows<dim>::Kind::slide)
            coordinate += first_slide;
          else
            coordinate = plain_coordinate(term.index);
          special[i].push_back({coordinate, term.factor});
        }
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::add_hanging_nodes(const std::vector<bool> &fixed)
  {
    std::vector<Term> of_master;
    for (const auto &[node, masters] : hanging.masters())
      for (unsigned int c = 0; c < dim; ++c)
        {
          if (fixed[node * dim + c])
            continue;
          std::map<unsigned int, double> sum;
          for (const auto &[master, weight] : masters)
            {
              terms_of(master * dim + c, of_master);
              for (const Term &term : of_master)
                sum[term.coordinate] += weight * term.factor;
            }
          rows[node * dim + c] = -1 - static_cast<int>(special.size());
          special.emplace_back();
          for (const auto &[coordinate, factor] : sum)
            special.back().push_back({coordinate, factor});
        }
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::terms_of(const std::size_t dof, std::vector<Term> &terms) const
  {
    terms.clear();
    if (rows[dof] >= 0)
      terms.push_back({plain_coordinate(dof), 1.});
    else
      terms = special[static_cast<std::size_t>(-1 - rows[dof])];
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::distribute(const double *y, const Vector &prescribed) const
  {
    Vector u = prescribed.empty() ? Vector(rows.size(), 0.) : prescribed;
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (rows[dof] >= 0)
        u[dof] += y[rows[dof]];
      else
        for (const Term &term : special[static_cast<std::size_t>(-1 - rows[dof])])
          u[dof] += term.factor * y[term.coordinate];
    return u;
  }


  template <int dim>
  Vector
  InterfaceCoordinates<dim>::gather(const Vector &forces) const
  {
    Vector result(n_coordinates, 0.);
    for (std::size_t dof = 0; dof < rows.size(); ++dof)
      if (rows[dof] >= 0)
        result[plain_coordinate(dof)] += forces[dof];
      else
        for (const Term &term : special[static_cast<std::size_t>(-1 - rows[dof])])
          result[term.coordinate] += term.factor * forces[dof];
    return result;
  }


  template <int dim>
  void
  InterfaceCoordinates<dim>::extend_prescribed(Vector &prescribed) const
  {
    for (const auto &[dof, support] : hangs_on)
      prescribed[dof] = prescribed[support];
    hanging.follow_masters(prescribed);
  }


  template class InterfaceCoordinates<2>;
  template class InterfaceCoordinates<3>;
} // namespace fuga

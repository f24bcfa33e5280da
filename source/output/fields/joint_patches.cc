// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/output/fields/joint_patches.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace fuga
{
  namespace
  {
    /** Distance by which a lip is moved in the exploded view, as a share of the extent of all
     * joints. */
    constexpr double explosion = 0.03;
    /** State of a node without contact element. */
    constexpr double bonded = 3.;
    /** Columns of quantities that belong to an element as a whole: state, area, dissipation,
     * number. */
    constexpr unsigned int first_of_element = 8, last_of_element = 11;

    std::vector<std::string>
    names(const unsigned int dim, const bool has_water)
    {
      std::vector<std::string> result = {"gap",
                                         "closure",
                                         "slip",
                                         "shear_jump",
                                         "normal_jump",
                                         "pressure",
                                         "shear",
                                         "utilisation",
                                         "state",
                                         "area",
                                         "dissipation",
                                         "element"};
      if (has_water)
        result.emplace_back("water_pressure");
      if (dim == 3)
        {
          for (const char *name : {"slip2", "shear_jump2", "shear2"})
            result.emplace_back(name);
          for (const char *name : {"slip_vector", "shear_vector"})
            result.insert(result.end(), 3, name);
        }
      return result;
    }

    /** Return the node numbers of the cells by which a face with @p n nodes is drawn: p lines, p²
     * squares, or a triangle. */
    std::vector<std::vector<unsigned int>>
    cells_of_face(const unsigned int dim, const unsigned int n)
    {
      std::vector<std::vector<unsigned int>> cells;
      if (dim == 2)
        for (unsigned int i = 0; i + 1 < n; ++i)
          cells.push_back({i, i + 1});
      else if (n == 3)
        cells.push_back({0, 1, 2});
      else
        {
          const auto row = static_cast<unsigned int>(std::lround(std::sqrt(n)));
          for (unsigned int j = 0; j + 1 < row; ++j)
            for (unsigned int i = 0; i + 1 < row; ++i)
              cells.push_back(
                {j * row + i, j * row + i + 1, (j + 1) * row + i, (j + 1) * row + i + 1});
        }
      return cells;
    }

    double
    extent(const std::vector<JointFace> &faces)
    {
      double low[3] = {1e300, 1e300, 1e300}, high[3] = {-1e300, -1e300, -1e300};
      for (const JointFace &face : faces)
        for (const auto &position : face.positions)
          for (std::size_t d = 0; d < 3; ++d)
            {
              low[d]  = std::min(low[d], position[d]);
              high[d] = std::max(high[d], position[d]);
            }
      return faces.empty() ? 0. : std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]);
    }
  } // namespace

  template <int dim>
  JointPatches<dim>::JointPatches(const CondensedSystem<dim> &condensed_system,
                                  const std::vector<ContactElement> &contact_elements,
                                  const std::vector<ElementResult> &element_results,
                                  const Vector &element_dissipation,
                                  const JointView view)
    : system(condensed_system)
    , elements(contact_elements)
    , results(element_results)
    , dissipation(element_dissipation)
  {
    const double offset = explosion * extent(system.joint_faces());
    for (const JointFace &face : system.joint_faces())
      if (view == JointView::in_place)
        add_face(face, 0.);
      else
        {
          add_face(face, offset);
          add_face(face, -offset);
        }
  }

  template <int dim>
  void
  JointPatches<dim>::add_face(const JointFace &face, const double offset)
  {
    std::array<double, 3> normal{};
    for (const auto &shares : face.shares)
      if (!shares.empty())
        normal = system.normal(shares.front().first);
    for (const auto &nodes : cells_of_face(dim, static_cast<unsigned int>(face.positions.size())))
      {
        Patch patch;
        patch.reference_cell = dealii::ReferenceCells::get_hypercube<dim - 1>();
        if (dim == 3 && nodes.size() == 3)
          patch.reference_cell = dealii::ReferenceCells::Triangle;
        patch.patch_index          = static_cast<unsigned int>(patches.size());
        patch.n_subdivisions       = 1;
        patch.points_are_available = false;
        for (unsigned int v = 0; v < nodes.size(); ++v)
          {
            for (unsigned int d = 0; d < dim; ++d)
              patch.vertices[v][d] = face.positions[nodes[v]][d] + offset * normal[d];
            const std::vector<double> values = values_at(face.shares[nodes[v]]);
            if (v == 0)
              patch.data.reinit(values.size(), nodes.size());
            for (unsigned int n = 0; n < values.size(); ++n)
              patch.data(n, v) = static_cast<float>(values[n]);
          }
        patches.push_back(std::move(patch));
      }
  }

  template <int dim>
  std::vector<double>
  JointPatches<dim>::values_at(const std::vector<std::pair<unsigned int, double>> &shares) const
  {
    if (shares.size() == 1 && shares.front().second == 1.)
      return values_of(shares.front().first);
    std::vector<double> sum(names(dim, system.closed_water().size() > 0).size(), 0.);
    sum[first_of_element] = bonded;
    sum[last_of_element]  = -1.;
    double largest        = 0.;
    for (const auto &[element, weight] : shares)
      {
        const std::vector<double> values = values_of(element);
        for (unsigned int n = 0; n < values.size(); ++n)
          if (n < first_of_element || n > last_of_element)
            sum[n] += weight * values[n];
          else if (weight > largest)
            sum[n] = values[n];
        largest = std::max(largest, weight);
      }
    return sum;
  }

  template <int dim>
  std::vector<double>
  JointPatches<dim>::values_of(const unsigned int element) const
  {
    const bool has_water       = system.closed_water().size() > 0;
    const ElementResult &r     = results[element];
    std::vector<double> values = {r.gap,
                                  r.closure,
                                  r.slip,
                                  r.jump_t,
                                  r.jump_n,
                                  r.pressure,
                                  r.shear,
                                  r.utilisation,
                                  static_cast<double>(state_code(r.state)),
                                  elements[element].area,
                                  dissipation[element],
                                  static_cast<double>(elements[element].number)};
    if (has_water)
      values.push_back(r.water_pressure);
    if (dim == 3)
      {
        values.insert(values.end(), {r.slip2, r.jump_t2, r.shear2});
        const auto t = system.tangents(element);
        for (const auto &[along1, along2] :
             {std::pair(r.slip, r.slip2), std::pair(r.shear, r.shear2)})
          for (unsigned int c = 0; c < 3; ++c)
            values.push_back(along1 * t[0][c] + along2 * t[1][c]);
      }
    return values;
  }

  template <int dim>
  const std::vector<typename JointPatches<dim>::Patch> &
  JointPatches<dim>::get_patches() const
  {
    return patches;
  }

  template <int dim>
  std::vector<std::string>
  JointPatches<dim>::get_dataset_names() const
  {
    return names(dim, system.closed_water().size() > 0);
  }

  template <int dim>
  std::vector<std::tuple<unsigned int,
                         unsigned int,
                         std::string,
                         dealii::DataComponentInterpretation::DataComponentInterpretation>>
  JointPatches<dim>::get_nonscalar_data_ranges() const
  {
    if (dim == 2)
      return {};
    const auto end    = static_cast<unsigned int>(get_dataset_names().size());
    const auto vector = dealii::DataComponentInterpretation::component_is_part_of_vector;
    return {{end - 6, end - 4, "slip_vector", vector}, {end - 3, end - 1, "shear_vector", vector}};
  }

  template class JointPatches<2>;
  template class JointPatches<3>;
} // namespace fuga

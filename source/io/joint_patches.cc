// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/io/joint_patches.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fuga
{
  namespace
  {
    /** How far a lip is moved in the exploded view, as share of the extent of all joints. */
    constexpr double explosion = 0.03;
    /** State of a node without contact element. */
    constexpr float bonded = 3.F;

    /** The last one only if a joint has water. */
    const std::array<const char *, 13> names = {{"gap",
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
                                                 "element",
                                                 "water_pressure"}};

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

  // A face of degree p is p line cells between its p + 1 nodes.
  template <int dim>
  void
  JointPatches<dim>::add_face(const JointFace &face, const double offset)
  {
    std::array<double, 3> normal{};
    for (const unsigned int k : face.elements)
      if (k != JointFace::no_element)
        normal = system.normal(k);
    for (std::size_t i = 0; i + 1 < face.positions.size(); ++i)
      {
        Patch patch;
        patch.reference_cell       = dealii::ReferenceCells::get_hypercube<dim - 1>();
        patch.patch_index          = static_cast<unsigned int>(patches.size());
        patch.n_subdivisions       = 1;
        patch.points_are_available = false;
        const auto n_names         = static_cast<unsigned int>(get_dataset_names().size());
        patch.data.reinit(n_names, 2);
        for (unsigned int v = 0; v < 2; ++v)
          {
            for (unsigned int d = 0; d < dim; ++d)
              patch.vertices[v][d] = face.positions[i + v][d] + offset * normal[d];
            const unsigned int k = face.elements[i + v];
            if (k == JointFace::no_element)
              {
                patch.data(8, v)  = bonded;
                patch.data(11, v) = -1.F;
                continue;
              }
            const ElementResult &r                        = results[k];
            const std::array<double, names.size()> values = {
              {r.gap,
               r.closure,
               r.slip,
               r.jump_t,
               r.jump_n,
               r.pressure,
               r.shear,
               r.utilisation,
               static_cast<double>(state_code(r.state)),
               elements[k].area,
               dissipation[k],
               static_cast<double>(elements[k].number),
               r.water_pressure}};
            for (unsigned int n = 0; n < n_names; ++n)
              patch.data(n, v) = static_cast<float>(values[n]);
          }
        patches.push_back(std::move(patch));
      }
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
    return {names.begin(), names.end() - (system.opening_water().empty() ? 1 : 0)};
  }

  template class JointPatches<2>;
} // namespace fuga

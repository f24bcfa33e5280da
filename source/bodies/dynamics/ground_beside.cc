// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>
#include <fuga/bodies/dynamics/ground_beside.h>
#include <fuga/bodies/elasticity/lame_constants.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/point_text.h>
#include <fuga/bodies/space/face_map.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <map>

namespace fuga
{
  namespace
  {
    /** Places on a side that differ by less than this, relative to the length of a face, are the
     * same. */
    constexpr double same_place = 1e-6;

    /** Density, λ and μ. */
    using Ground = std::array<double, 3>;

    /** Faces of the same kind of ground, one above the other. */
    struct Layer
    {
      Ground ground;
      Heights heights;
      std::vector<Heights> faces;
      /** One of the bodies that consist of this ground. */
      unsigned int body = 0;
    };

    template <int dim>
    std::vector<Ground>
    ground_of_bodies(const BodyModel<dim> &model)
    {
      const ModelDefinition &definition = model.definition();
      const JointedMesh &mesh           = model.jointed_mesh();
      const Vector density              = mass_densities(mesh, definition);
      std::vector<Ground> result(density.size());
      for (const Material &material : definition.materials)
        {
          const unsigned int body   = index_of(mesh.body_names, material.body);
          const LameConstants stiff = lame_constants(material, definition.assumption);
          result[body]              = {{density[body], stiff.lambda, stiff.mu}};
        }
      return result;
    }

    bool
    are_same(const double a, const double b, const Heights &face)
    {
      return std::abs(a - b) <= same_place * face.length();
    }

    template <int dim>
    Heights
    heights_of_face(const Discretization<dim> &space,
                    const typename Discretization<dim>::BoundaryFace &face)
    {
      const Vector corners         = FaceMap<dim>(space, face).heights();
      const auto [lowest, highest] = std::minmax_element(corners.begin(), corners.end());
      return {*lowest, *highest};
    }

    template <int dim>
    dealii::Tensor<1, dim>
    normal_of(const Discretization<dim> &space,
              const typename Discretization<dim>::BoundaryFace &face)
    {
      return FaceMap<dim>(space, face)
        .normal(space.reference_element().face(face.number).points.front());
    }

    /** Return the area of the faces divided by that of the rectangle around them, without the
     * extent across a plane. */
    template <int dim>
    double
    share_of_rectangle(const Discretization<dim> &space,
                       const SideOfGround<dim> &side,
                       const double height)
    {
      double area = 0.;
      for (const auto &face : side)
        {
          const auto &table = space.reference_element().face(face.number);
          const FaceMap<dim> map(space, face);
          for (std::size_t q = 0; q < table.points.size(); ++q)
            area +=
              table.weight[q] * (dim == 2 ? space.face_length(face) : map.density(table.points[q]));
        }
      if constexpr (dim == 2)
        return area / height;
      else
        {
          const auto normal             = normal_of(space, side.front());
          const dealii::Point<3> origin = space.face_center(side.front());
          std::array<double, 2> width   = {{0., 0.}};
          for (const auto &face : side)
            {
              const FaceMap<dim> map(space, face);
              for (const auto &corner : map.corners())
                {
                  const auto from_origin = corner - origin;
                  const double across    = from_origin[1] * normal[0] - from_origin[0] * normal[1];
                  width = {{std::min(width[0], across), std::max(width[1], across)}};
                }
            }
          return area / (height * (width[1] - width[0]));
        }
    }

    /** Return the layers from below; ground of one kind is one layer where its faces meet. */
    template <int dim>
    std::vector<Layer>
    layers_of(const BodyModel<dim> &model, const SideOfGround<dim> &side)
    {
      const Discretization<dim> &space = model.discretization();
      const std::vector<Ground> ground = ground_of_bodies(model);
      std::map<Ground, std::vector<std::pair<Heights, unsigned int>>> by_kind;
      for (const auto &face : side)
        {
          const unsigned int body = space.cell_body(face.cell);
          by_kind[ground[body]].emplace_back(heights_of_face(space, face), body);
        }
      std::vector<Layer> layers;
      for (auto &[kind, faces] : by_kind)
        {
          std::sort(faces.begin(), faces.end(), [](const auto &a, const auto &b) {
            return a.first.foot < b.first.foot;
          });
          bool begins = true;
          for (const auto &[heights, body] : faces)
            {
              if (begins ||
                  heights.foot > layers.back().heights.top + same_place * heights.length())
                layers.push_back({kind, heights, {}, body});
              begins = false;
              layers.back().faces.push_back(heights);
              layers.back().heights.top = std::max(layers.back().heights.top, heights.top);
            }
        }
      std::sort(layers.begin(), layers.end(), [](const Layer &a, const Layer &b) {
        return a.heights.foot < b.heights.foot;
      });
      return layers;
    }

    /** Return, from below, the rows in which the faces stand, or as many equal ones. */
    std::vector<Heights>
    rows_of(const Layer &layer)
    {
      std::vector<Heights> rows;
      bool are_rows = true;
      double sum    = 0.;
      for (const Heights &face : layer.faces)
        {
          sum += face.length();
          if (rows.empty() || are_same(face.foot, rows.back().top, face))
            rows.push_back(face);
          else
            are_rows = are_rows && are_same(face.foot, rows.back().foot, face) &&
                       are_same(face.top, rows.back().top, face);
        }
      if (are_rows)
        return rows;
      const double mean = sum / static_cast<double>(layer.faces.size());
      const auto n      = static_cast<std::size_t>(std::ceil(layer.heights.length() / mean));
      const double step = layer.heights.length() / static_cast<double>(n);
      rows.clear();
      for (std::size_t i = 0; i < n; ++i)
        rows.push_back({layer.heights.foot + static_cast<double>(i) * step,
                        layer.heights.foot + static_cast<double>(i + 1) * step});
      return rows;
    }
  } // namespace


  template <int dim>
  std::vector<SideOfGround<dim>>
  sides_of_ground(const BodyModel<dim> &model)
  {
    const Discretization<dim> &space = model.discretization();
    std::vector<SideOfGround<dim>> sides;
    for (const auto &face : space.boundary_faces(selection(
           model.jointed_mesh().label_names, model.definition().dynamics.free_field.names)))
      {
        const auto normal    = normal_of(space, face);
        const auto is_beside = [&](const SideOfGround<dim> &side) {
          const double distance =
            (space.face_center(face) - space.face_center(side.front())) * normal;
          return normal * normal_of(space, side.front()) > 1. - same_place &&
                 std::abs(distance) < same_place * space.face_length(face);
        };
        const auto found = std::find_if(sides.begin(), sides.end(), is_beside);
        if (found == sides.end())
          sides.push_back({face});
        else
          found->push_back(face);
      }
    return sides;
  }


  template <int dim>
  Heights
  heights_of(const BodyModel<dim> &model, const SideOfGround<dim> &side)
  {
    Heights result = heights_of_face(model.discretization(), side.front());
    for (const auto &face : side)
      {
        const Heights heights = heights_of_face(model.discretization(), face);
        result = {std::min(result.foot, heights.foot), std::max(result.top, heights.top)};
      }
    return result;
  }


  template <int dim>
  std::vector<typename FreeColumn<dim>::Cell>
  ground_beside(const BodyModel<dim> &model, const SideOfGround<dim> &side)
  {
    const ModelDefinition &definition = model.definition();
    const JointedMesh &mesh           = model.jointed_mesh();
    const std::string where           = text_of(model.discretization().face_center(side.front()));
    const double share =
      share_of_rectangle(model.discretization(), side, heights_of(model, side).length());
    if (!(std::abs(share - 1.) < same_place))
      throw InputError(fmt::format(
        "{}: a side beside a free field is of one piece from its foot to its top, and level there, "
        "but the faces beside {} cover {:.4g} of the rectangle around them. Name all boundaries of "
        "the side.",
        definition.dynamics.free_field.origin,
        where,
        share));
    std::vector<typename FreeColumn<dim>::Cell> cells;
    const std::vector<Layer> layers = layers_of(model, side);
    for (std::size_t i = 0; i < layers.size(); ++i)
      {
        const Layer &layer = layers[i];
        if (i > 0 && !are_same(layer.heights.foot, layers[i - 1].heights.top, layer.faces.front()))
          throw InputError(fmt::format(
            "{}: the ground beside the model is layered horizontally, but bodies '{}' and '{}', "
            "which differ, meet the side at {} at the same heights. Let layers end at horizontal "
            "planes, or name the side in Dynamics/Absorbing boundaries instead.",
            definition.dynamics.free_field.origin,
            mesh.body_names[layers[i - 1].body],
            mesh.body_names[layer.body],
            where));
        const auto &[density, lambda, mu] = layer.ground;
        for (const Heights &row : rows_of(layer))
          cells.push_back({row.foot, row.top, density, lambda, mu});
      }
    return cells;
  }


  template std::vector<SideOfGround<2>>
  sides_of_ground(const BodyModel<2> &);
  template std::vector<SideOfGround<3>>
  sides_of_ground(const BodyModel<3> &);
  template Heights
  heights_of(const BodyModel<2> &, const SideOfGround<2> &);
  template Heights
  heights_of(const BodyModel<3> &, const SideOfGround<3> &);
  template std::vector<FreeColumn<2>::Cell>
  ground_beside(const BodyModel<2> &, const SideOfGround<2> &);
  template std::vector<FreeColumn<3>::Cell>
  ground_beside(const BodyModel<3> &, const SideOfGround<3> &);
} // namespace fuga

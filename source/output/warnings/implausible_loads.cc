// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/bodies/condensed/model_sizes.h>
#include <fuga/bodies/loads/level_history.h>
#include <fuga/bodies/model_names.h>
#include <fuga/bodies/point_matcher.h>
#include <fuga/bodies/point_text.h>
#include <fuga/output/files/text_table.h>
#include <fuga/output/warnings/implausible_data.h>
#include <fuga/output/warnings/implausible_loads.h>

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** Distance, in units of the extent of the model, below which places are the same. */
    constexpr double same_place = 1e-9;

    /** Return what two loads have in common; an empty list means everything. */
    std::vector<std::string>
    common_targets(const LoadDefinition &a, const LoadDefinition &b)
    {
      if (a.targets.empty() || b.targets.empty())
        return a.has_coordinates || b.has_coordinates   ? std::vector<std::string>()
               : a.targets.empty() && b.targets.empty() ? std::vector<std::string>{"all bodies"}
                                                        : (a.targets.empty() ? b : a).targets;
      std::vector<std::string> common;
      for (const std::string &target : a.targets)
        if (index_of(b.targets, target) < b.targets.size())
          common.push_back(target);
      return common;
    }
  } // namespace


  template <int dim>
  ImplausibleLoads<dim>::ImplausibleLoads(const Parameters &run_parameters,
                                          const CondensedSystem<dim> &bodies,
                                          const LoadHistory &factors)
    : parameters(run_parameters), model(parameters.model), system(bodies), load_factors(factors)
  {
    const auto [low, high] = extent_of(system.discretization());
    extent                 = low.distance(high);
  }


  template <int dim>
  void
  ImplausibleLoads<dim>::review(const unsigned int stage)
  {
    find_loads_given_twice(stage);
    find_dry_faces(stage);
    find_dry_ends(stage);
  }


  template <int dim>
  void
  ImplausibleLoads<dim>::warn(const std::string &key, std::string text)
  {
    if (known.insert(key).second)
      texts.push_back(std::move(text));
  }


  // Different pressures, or earthquakes along different axes, may act on the same place; two
  // reservoirs on one face do not.
  template <int dim>
  bool
  ImplausibleLoads<dim>::do_the_same(const LoadDefinition &a, const LoadDefinition &b) const
  {
    if (a.kind != b.kind || type_of(parameters, a) != type_of(parameters, b))
      return false;
    return a.has_level() || (a.kind != LoadKind::displacement && a.kind != LoadKind::imposed_gap &&
                             a.expressions == b.expressions);
  }


  template <int dim>
  void
  ImplausibleLoads<dim>::find_loads_given_twice(const unsigned int stage)
  {
    const Vector factors = load_factors.factors(stage + 1.);
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      for (std::size_t j = i + 1; j < model.loads.size(); ++j)
        {
          const LoadDefinition &a = model.loads[i], &b = model.loads[j];
          if (!(factors[i] * factors[j] > 0.) || !do_the_same(a, b))
            continue;
          const std::vector<std::string> common = common_targets(a, b);
          if (!common.empty())
            warn(fmt::format("twice {} {}", i, j),
                 fmt::format("the loads '{}' and '{}', both of type {}, act together on {} at the "
                             "end of stage '{}', so that it counts twice there. Remove one, unless "
                             "this is meant.",
                             a.name,
                             b.name,
                             type_of(parameters, a),
                             fmt::join(common, ", "),
                             model.stages[stage].name));
        }
  }


  template <int dim>
  auto
  ImplausibleLoads<dim>::water_at(const double t) const -> std::vector<Water>
  {
    const Vector factors = load_factors.factors(t);
    std::vector<Water> result;
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (const LoadDefinition &load = model.loads[i]; factors[i] > 0. &&
                                                       load.kind == LoadKind::depth_pressure &&
                                                       type_of(parameters, load) == "hydrostatic")
        result.push_back({&load,
                          LevelHistory(load, model.constants)(t),
                          factors[i],
                          selection(system.jointed_mesh().label_names, load.targets)});
    return result;
  }


  template <int dim>
  std::vector<bool>
  ImplausibleLoads<dim>::dry_labels(const double t) const
  {
    const JointedMesh &mesh = system.jointed_mesh();
    const Vector factors    = load_factors.factors(t);
    std::vector<bool> dry(mesh.label_names.size(), true);
    const auto take_out = [&](const std::vector<std::string> &names) {
      for (const std::string &name : names)
        if (const unsigned int label = index_of(mesh.label_names, name); label < dry.size())
          dry[label] = false;
    };
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (factors[i] != 0.)
        take_out(model.loads[i].targets);
    for (const BoundaryCondition &condition : model.boundary_conditions)
      if (!condition.named_free)
        take_out({condition.boundary});
    for (const JointedMesh::Joint &joint : mesh.joints)
      for (const unsigned int label : {joint.plus_label, joint.minus_label})
        if (label != JointedMesh::no_label)
          dry[label] = false;
    return dry;
  }


  // The free face begins where the loaded one ends, at its upper rim, which is a node in the plane
  // and an edge in space (beside the rim a face may end at a joint between blocks that is not part
  // of the model).
  template <int dim>
  void
  ImplausibleLoads<dim>::find_dry_faces(const unsigned int stage)
  {
    const double t                   = stage + 1.;
    const Discretization<dim> &space = system.discretization();
    const std::vector<bool> dry      = dry_labels(t);
    const auto for_each_node         = [&](const BoundaryFace &face, const auto &action) {
      for (const unsigned int corner : space.reference_element().face(face.number).corners)
        action(space.face_node(face, corner));
    };
    for (const Water &water : water_at(t))
      {
        double top = std::numeric_limits<double>::lowest();
        std::set<unsigned int> rim;
        for (const BoundaryFace &face : space.boundary_faces())
          if (water.loaded[face.label])
            for_each_node(face, [&](const unsigned int node) {
              top = std::max(top, space.position(node)[dim - 1]);
              rim.insert(node);
            });
        if (rim.empty() || water.level <= top + same_place * extent)
          continue;
        for (const BoundaryFace &face : space.boundary_faces())
          {
            unsigned int n_shared = 0;
            for_each_node(face, [&](const unsigned int node) {
              if (rim.count(node) > 0 && space.position(node)[dim - 1] >= top - same_place * extent)
                ++n_shared;
            });
            if (!dry[face.label] || n_shared < dim - 1)
              continue;
            const std::string &name = system.jointed_mesh().label_names[face.label];
            warn(fmt::format("dry face {} {}", water.load->name, name),
                 fmt::format("load '{}': at the end of stage '{}' the level {:.6g} {} is above the "
                             "loaded boundary, which ends at {:.6g} {}; the boundary '{}' begins "
                             "there and carries no water. Load it too, or lower the level.",
                             water.load->name,
                             model.stages[stage].name,
                             water.level,
                             parameters.output.units.length,
                             top,
                             parameters.output.units.length,
                             name));
          }
      }
  }


  template <int dim>
  void
  ImplausibleLoads<dim>::find_dry_ends(const unsigned int stage)
  {
    const double t       = stage + 1.;
    const Vector factors = load_factors.factors(t);
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      if (model.loads[i].kind == LoadKind::uplift && factors[i] > 0.)
        compare_ends(model.loads[i], factors[i], t);
  }


  // Water in the joint, divided by the area of an element, is compared with that on the face which
  // the joint meets there. The pressure of an element is a mean over its area, also beyond a drain.
  template <int dim>
  void
  ImplausibleLoads<dim>::compare_ends(const LoadDefinition &uplift,
                                      const double factor,
                                      const double t)
  {
    constexpr double least_share     = 0.2;
    const Discretization<dim> &space = system.discretization();
    const JointedMesh &mesh          = system.jointed_mesh();
    const std::vector<Water> waters  = water_at(t);
    if (waters.empty())
      return;
    const Vector pressed =
      system.assemble_load(static_cast<std::size_t>(&uplift - model.loads.data()), t).closed_water;
    std::vector<dealii::Point<dim>> places;
    std::vector<const ContactElement *> elements;
    for (const ContactElement &element : system.elements())
      if (index_of(uplift.targets, mesh.joints[element.joint].name) < uplift.targets.size())
        {
          places.emplace_back();
          for (unsigned int c = 0; c < dim; ++c)
            places.back()[c] = element.position[c];
          elements.push_back(&element);
        }
    const PointMatcher<dim> matcher(places);
    const std::string &unit = parameters.output.units.stress();
    for (const Water &water : waters)
      for (const BoundaryFace &face : space.boundary_faces())
        if (water.loaded[face.label])
          for (const unsigned int corner : space.reference_element().face(face.number).corners)
            {
              const auto &place    = space.position(space.face_node(face, corner));
              const double outside = water.factor * water.load->depth.gradient *
                                     std::max(water.level - place[dim - 1], 0.);
              const unsigned int found = matcher.find(place, same_place * extent);
              if (found == PointMatcher<dim>::not_found || outside == 0.)
                continue;
              const ContactElement &element = *elements[found];
              const double inside           = factor * pressed[element.normal_bar] / element.area;
              const std::string &joint      = mesh.joints[element.joint].name;
              if (inside < least_share * outside)
                warn(fmt::format("dry end {} {}", uplift.name, joint),
                     fmt::format("load '{}': the joint '{}' meets the boundary '{}' at {}, where "
                                 "load '{}' has a pressure of {:.4g} {}, but the uplift is {} "
                                 "{}. Is the upstream end of the joint on the dry side, or its "
                                 "tailwater level forgotten?",
                                 uplift.name,
                                 joint,
                                 mesh.label_names[face.label],
                                 text_of(place),
                                 water.load->name,
                                 outside,
                                 unit,
                                 readable(inside, outside),
                                 unit));
            }
  }


  template class ImplausibleLoads<2>;
  template class ImplausibleLoads<3>;
} // namespace fuga

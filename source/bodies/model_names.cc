// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fuga/base/input_errors.h>
#include <fuga/base/similar_names.h>
#include <fuga/bodies/model_names.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    /** Return "file:line: " or nothing. */
    std::string
    where(const std::string &origin)
    {
      return origin.empty() ? "" : origin + ": ";
    }

    std::vector<std::string>
    point_names(const JointedMesh &mesh)
    {
      std::vector<std::string> names;
      for (const auto &point : mesh.points)
        names.push_back(point.name);
      std::sort(names.begin(), names.end());
      names.erase(std::unique(names.begin(), names.end()), names.end());
      return names;
    }

    std::string
    listed(const std::vector<std::string> &names)
    {
      return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
    }

    /** Append to a sentence all names, and the one that may be meant. */
    std::string
    with_hint(const std::string &sentence,
              const std::string &wrong,
              const std::vector<std::string> &names)
    {
      return sentence + did_you_mean(wrong, names, " ");
    }

    std::vector<std::string>
    boundaries_and_points(const JointedMesh &mesh)
    {
      std::vector<std::string> names        = mesh.label_names;
      const std::vector<std::string> points = point_names(mesh);
      names.insert(names.end(), points.begin(), points.end());
      return names;
    }

    bool
    is_boundary_or_point(const JointedMesh &mesh, const std::string &name)
    {
      return index_of(mesh.label_names, name) < mesh.label_names.size() ||
             !vertices_of_point(mesh, name).empty();
    }

    unsigned int
    check_material(const JointedMesh &mesh, const Material &material)
    {
      const unsigned int body = index_of(mesh.body_names, material.body);
      if (body == mesh.body_names.size())
        throw InputError(
          with_hint(fmt::format("Material of body '{}': the mesh has no such body. Bodies: {}.",
                                material.body,
                                listed(mesh.body_names)),
                    material.body,
                    mesh.body_names));
      if (!(material.young_modulus > 0.) || !(material.poisson_ratio > -1.) ||
          !(material.poisson_ratio < 0.5))
        throw InputError(fmt::format("Material of body '{}': Young's modulus {:g} must be "
                                     "positive and Poisson's ratio {:g} "
                                     "between -1 and 0.5.",
                                     material.body,
                                     material.young_modulus,
                                     material.poisson_ratio));
      return body;
    }

    // A body may be without material because its name is misspelt.
    void
    check_materials(const JointedMesh &mesh, const ModelDefinition &model, InputErrors &errors)
    {
      std::vector<unsigned int> count(mesh.body_names.size(), 0);
      bool all_known = true;
      for (const auto &material : model.materials)
        all_known &= errors.attempt([&]() { ++count[check_material(mesh, material)]; });
      for (std::size_t body = 0; all_known && body < count.size(); ++body)
        if (count[body] != 1)
          errors.add(fmt::format("Body '{}' has {} materials; give it exactly one.",
                                 mesh.body_names[body],
                                 count[body] == 0 ? "no" : std::to_string(count[body])));
    }

    /** Check one condition; @p number is its number in the model. */
    void
    check_condition(const JointedMesh &mesh, const ModelDefinition &model, const std::size_t number)
    {
      const BoundaryCondition &condition = model.boundary_conditions[number];
      const auto &fixed                  = condition.fixed;
      const bool held = std::find(fixed.begin(), fixed.end(), true) != fixed.end();
      if (!is_boundary_or_point(mesh, condition.boundary))
        throw InputError(
          with_hint(fmt::format("{}Boundary '{}' is not in the mesh. Boundaries: {}. Points: {}.",
                                where(condition.origin),
                                condition.boundary,
                                listed(mesh.label_names),
                                listed(point_names(mesh))),
                    condition.boundary,
                    boundaries_and_points(mesh)));
      if (held == condition.named_free)
        throw InputError(fmt::format(
          held ? "{}Boundary '{}' is both held and named free; remove one of the two."
               : "{}Boundary '{}' holds no component; name it free or remove the condition.",
          where(condition.origin),
          condition.boundary));
      for (std::size_t other = 0; other < number; ++other)
        if (const auto &earlier = model.boundary_conditions[other];
            earlier.boundary == condition.boundary)
          throw InputError(
            fmt::format("{}Boundary '{}' has a condition already{}; keep one of them.",
                        where(condition.origin),
                        condition.boundary,
                        earlier.origin.empty() ? "" : " (" + earlier.origin + ")"));
    }

    const BoundaryCondition *
    condition_of(const ModelDefinition &model, const std::string &boundary)
    {
      for (const auto &condition : model.boundary_conditions)
        if (condition.boundary == boundary)
          return &condition;
      return nullptr;
    }

    void
    check_load_target(const JointedMesh &mesh,
                      const ModelDefinition &model,
                      const LoadDefinition &load,
                      const std::string &target)
    {
      const std::string start = fmt::format("{}Load '{}': ", where(load.origin), load.name);
      if (load.kind == LoadKind::weight || load.kind == LoadKind::temperature)
        {
          if (index_of(mesh.body_names, target) == mesh.body_names.size())
            throw InputError(with_hint(
              fmt::format(
                "{}there is no body '{}'. Bodies: {}.", start, target, listed(mesh.body_names)),
              target,
              mesh.body_names));
          return;
        }
      if (load.kind == LoadKind::uplift || load.kind == LoadKind::imposed_gap)
        {
          std::vector<std::string> joints;
          for (const auto &joint : mesh.joints)
            joints.push_back(joint.name);
          if (index_of(joints, target) == joints.size())
            throw InputError(
              fmt::format("{}there is no joint '{}'. Joints: {}.", start, target, listed(joints)));
          return;
        }
      if (load.kind == LoadKind::point_force)
        {
          if (vertices_of_point(mesh, target).empty())
            throw InputError(with_hint(
              fmt::format(
                "{}there is no point '{}'. Points: {}.", start, target, listed(point_names(mesh))),
              target,
              point_names(mesh)));
          return;
        }
      const bool points_too = load.kind == LoadKind::displacement;
      if (index_of(mesh.label_names, target) == mesh.label_names.size() &&
          !(points_too && !vertices_of_point(mesh, target).empty()))
        throw InputError(with_hint(fmt::format("{}there is no boundary '{}'. Boundaries: {}.",
                                               start,
                                               target,
                                               listed(mesh.label_names)),
                                   target,
                                   mesh.label_names));
      const BoundaryCondition *condition = condition_of(model, target);
      if (condition && condition->named_free)
        throw InputError(
          fmt::format("{}boundary '{}' is named free; remove one of the two.", start, target));
      if (load.kind == LoadKind::displacement)
        for (std::size_t c = 0; c < load.expressions.size(); ++c)
          if (!load.expressions[c].empty() && !(condition && condition->fixed[c]))
            throw InputError(fmt::format(
              "{}it moves '{}' in {}, but that component is not held. Only held components can be "
              "moved: hold it, or leave its expression empty.",
              start,
              target,
              "xyz"[c]));
    }

    /** Check the boundaries that only dynamic stages use. */
    void
    check_boundaries(const JointedMesh &mesh, const NamedBoundaries &boundaries)
    {
      for (const std::string &boundary : boundaries.names)
        {
          const unsigned int label = index_of(mesh.label_names, boundary);
          if (label == mesh.label_names.size())
            throw InputError(with_hint(fmt::format("{}there is no boundary '{}'. Boundaries: {}.",
                                                   where(boundaries.origin),
                                                   boundary,
                                                   listed(mesh.label_names)),
                                       boundary,
                                       mesh.label_names));
          for (const auto &joint : mesh.joints)
            if (joint.plus_label == label || joint.minus_label == label)
              throw InputError(
                fmt::format("{}boundary '{}' is a lip of joint '{}'. Name outer boundaries only.",
                            where(boundaries.origin),
                            boundary,
                            joint.name));
        }
    }

    void
    check_every_label_is_used(const JointedMesh &mesh,
                              const ModelDefinition &model,
                              InputErrors &errors)
    {
      std::vector<bool> used(mesh.label_names.size(), false);
      for (const auto &joint : mesh.joints)
        {
          used[joint.plus_label] = true;
          if (joint.minus_label != JointedMesh::no_label)
            used[joint.minus_label] = true;
        }
      for (unsigned int label = 0; label < used.size(); ++label)
        {
          const std::string &name            = mesh.label_names[label];
          const BoundaryCondition *condition = condition_of(model, name);
          if (used[label] && condition && !condition->named_free)
            errors.add(fmt::format(
              "{}Boundary '{}' is a lip of a joint and cannot be held. Hold other boundaries, or "
              "take the joint away.",
              where(condition->origin),
              name));
          used[label] =
            used[label] || condition ||
            index_of(model.dynamics.absorbing.names, name) < model.dynamics.absorbing.names.size();
          for (const auto &load : model.loads)
            if (load.kind == LoadKind::pressure || load.kind == LoadKind::depth_pressure ||
                load.kind == LoadKind::traction)
              used[label] = used[label] || index_of(load.targets, name) < load.targets.size();
          if (!used[label])
            errors.add(fmt::format(
              "Boundary '{}' of the mesh has no condition. Hold it, load it, use it in a joint, or "
              "name it free.",
              name));
        }
    }
  } // namespace


  unsigned int
  index_of(const std::vector<std::string> &names, const std::string &name)
  {
    return static_cast<unsigned int>(std::find(names.begin(), names.end(), name) - names.begin());
  }


  std::vector<bool>
  selection(const std::vector<std::string> &names, const std::vector<std::string> &targets)
  {
    std::vector<bool> selected(names.size(), false);
    for (const auto &target : targets)
      if (const unsigned int i = index_of(names, target); i < names.size())
        selected[i] = true;
    return selected;
  }


  Vector
  mass_densities(const JointedMesh &mesh, const ModelDefinition &model)
  {
    const DynamicsDefinition &dynamics = model.dynamics;
    Vector density(mesh.body_names.size(), 0.);
    for (const Material &material : model.materials)
      if (!dynamics.is_massless(material.body))
        density[index_of(mesh.body_names, material.body)] =
          material.weight_density / dynamics.gravity;
    return density;
  }


  std::vector<unsigned int>
  vertices_of_point(const JointedMesh &mesh, const std::string &name)
  {
    std::vector<unsigned int> vertices;
    for (const auto &point : mesh.points)
      if (point.name == name)
        vertices.push_back(point.vertex);
    return vertices;
  }


  void
  check_names(const JointedMesh &mesh, const ModelDefinition &model)
  {
    InputErrors errors;
    check_materials(mesh, model, errors);
    for (std::size_t i = 0; i < model.boundary_conditions.size(); ++i)
      errors.attempt([&]() { check_condition(mesh, model, i); });
    for (const auto &load : model.loads)
      for (const auto &target : load.targets)
        errors.attempt([&]() { check_load_target(mesh, model, load, target); });
    const DynamicsDefinition &dynamics = model.dynamics;
    for (const AddedMass &water : dynamics.added_masses)
      errors.attempt([&]() { check_boundaries(mesh, {water.boundaries, water.origin}); });
    for (const NamedBoundaries *boundaries :
         {&dynamics.compliant_base, &dynamics.free_field, &dynamics.absorbing})
      errors.attempt([&]() { check_boundaries(mesh, *boundaries); });
    // A boundary may seem unused because its name is misspelt.
    if (!errors.any())
      check_every_label_is_used(mesh, model, errors);
    errors.throw_if_any();
  }
} // namespace fuga

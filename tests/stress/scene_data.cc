// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/scene_data.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace fuga::stress
{
  namespace
  {
    bool
    has_compliance_entry(const std::string &law)
    {
      return law == "linear" || law == "hyperbolic" || law.rfind("cubic root", 0) == 0;
    }
  } // namespace

  void
  SceneData::join_all(const std::function<Layer()> &make_layer)
  {
    for (const auto &[name, unused] : faces())
      {
        const auto hyphen = name.find('-');
        if (hyphen != name.npos)
          joints.push_back({name, name.substr(hyphen + 1), name.substr(0, hyphen), make_layer()});
      }
  }

  // Outer boundaries without support, load or obstacle; the program wants them named.
  std::vector<std::string>
  SceneData::free_boundaries() const
  {
    std::vector<std::string> result;
    for (const auto &[name, unused] : faces())
      if (name.find('-') == name.npos && supports.count(name) == 0 &&
          std::none_of(
            loads.begin(), loads.end(), [&](const Load &load) { return load.target == name; }) &&
          std::none_of(
            joints.begin(), joints.end(), [&](const Joint &joint) { return joint.plus == name; }))
        result.push_back(name);
    return result;
  }

  std::string
  SceneData::name_of_joint(const std::size_t a, const std::size_t b) const
  {
    return bodies[std::min(a, b)].name + '-' + bodies[std::max(a, b)].name;
  }

  MeshText
  SceneData::mesh_of_faces() const
  {
    constexpr std::size_t first_tag = 100;
    MeshText mesh;
    for (std::size_t b = 0; b < bodies.size(); ++b)
      mesh.add_name(dimension(), tag_of_body(b), bodies[b].name);
    std::size_t tag = first_tag;
    for (const auto &[name, group] : faces())
      {
        mesh.add_name(dimension() - 1, ++tag, name);
        // Gmsh's numbers of lines, triangles and quadrilaterals.
        for (const std::vector<std::size_t> &face : group)
          mesh.add_element(static_cast<unsigned int>(face.size()) - 1, tag, face);
      }
    return mesh;
  }

  std::string
  SceneData::joint_text() const
  {
    std::string text = "subsection Joints\n";
    for (std::size_t k = 0; k < joints.size(); ++k)
      {
        const Joint &joint = joints[k];
        const Layer &layer = joint.layer;
        text += fmt::format("subsection joint_{}\n", k);
        if (joint.line.empty())
          text += fmt::format("set Plus lip = {}\nset Minus lip = rigid\n", joint.plus);
        else
          text += fmt::format("set Line = {}\nset Plus body = {}\nset Minus body = {}\n",
                              joint.line,
                              joint.plus,
                              joint.minus);
        for (const auto &[direction, law, compliance] :
             {std::make_tuple("Normal", layer.normal_law, layer.normal_compliance),
              std::make_tuple("Shear", layer.shear_law, layer.shear_compliance)})
          {
            text += fmt::format("set {} law = {}\n", direction, law);
            if (has_compliance_entry(law))
              text += fmt::format("set {} compliance = {}\n", direction, compliance);
          }
        if (layer.thickness > 0.)
          text += fmt::format("set Thickness = {}\n", layer.thickness);
        text += fmt::format(
          "set Friction coefficient = {}\nset Cohesion = {}\n", layer.friction, layer.cohesion);
        if (!layer.initial_gap.empty())
          text += "set Initial gap = " + layer.initial_gap + '\n';
        for (const auto &[entry, value] : layer.more)
          text += fmt::format("set {} = {}\n", entry, value);
        text += "end\n";
      }
    return text + "end\n";
  }

  std::string
  SceneData::load_text() const
  {
    std::string text = "subsection Loads\n";
    for (std::size_t l = 0; l < loads.size(); ++l)
      text += fmt::format("subsection load_{}\nset Type = {}\nset {} = {}\n{}end\n",
                          l,
                          loads[l].type,
                          loads[l].type == "weight" ? "Bodies" : "Boundaries",
                          loads[l].target,
                          loads[l].value.empty() ? "" : "set Value = " + loads[l].value + '\n');
    text += "end\nsubsection Stages\n";
    Vector before(loads.size(), 0.);
    for (std::size_t s = 0; s < stages.size(); ++s)
      {
        const Course course = is_in_motion() ? courses[s] : Course();
        std::string histories;
        for (std::size_t l = 0; l < loads.size(); ++l)
          if (stages[s][l] != before[l] || (histories.empty() && l + 1 == loads.size()))
            histories += fmt::format("{}load_{}: {}*(1-{share}) + {}*{share}",
                                     histories.empty() ? "" : "; ",
                                     l,
                                     before[l],
                                     stages[s][l],
                                     fmt::arg("share", course.share));
        text += fmt::format(
          "subsection stage_{}\nset Loads = {}\nset Levels = {}\n", s, histories, load_levels);
        if (course.duration > 0.)
          text += fmt::format("set Duration = {}\n", course.duration);
        text += "end\n";
        before = stages[s];
      }
    return text + "end\n";
  }

  std::string
  SceneData::parameter_text(const std::string &mesh_file) const
  {
    std::string text = fmt::format("set Dimension = {}\nsubsection Mesh\nset File = {}\n"
                                   "set Polynomial degree = {}\n{}end\nsubsection Bodies\n",
                                   dimension(),
                                   mesh_file,
                                   degree,
                                   mesh_entries());
    for (const Body &b : bodies)
      {
        text += fmt::format("subsection {}\nset Young modulus = {}\nset Poisson ratio = {}\n"
                            "set Weight density = {}\n",
                            b.name,
                            b.young_modulus,
                            b.poisson_ratio,
                            b.weight);
        if (const auto velocity = initial_velocities.find(b.name);
            velocity != initial_velocities.end())
          text += fmt::format("set Initial velocity = {}\n", velocity->second);
        text += "end\n";
      }
    text += "end\n" + joint_text() + "subsection Boundaries\n";
    for (const auto &[boundary, components] : supports)
      text += fmt::format("subsection {}\nset Fixed = {}\nend\n", boundary, components);
    for (const std::string &boundary : free_boundaries())
      text += fmt::format("subsection {}\nset Fixed = free\nend\n", boundary);
    text += "end\n" + load_text();
    if (is_in_motion())
      {
        text += "subsection Dynamics\n";
        for (const auto &[entry, value] : dynamics)
          text += fmt::format("set {} = {}\n", entry, value);
        text += "end\n";
      }
    return text + fmt::format("subsection Solver\nset Certificate bound = {}\n{}{}end\n"
                              "subsection Output\nset Fields = end\nset Log = quiet\nend\n",
                              certificate_bound,
                              dimension() == 2 ? "set Non-unique = first\n" : "",
                              follows_jumps ? "set No continuation = jump\n" : "");
  }

  void
  MeshText::add_name(const unsigned int dimension, const std::size_t tag, const std::string &name)
  {
    names += fmt::format("{} {} \"{}\"\n", dimension, tag, name);
    ++n_names;
  }

  void
  MeshText::add_element(const unsigned int type,
                        const std::size_t tag,
                        const std::vector<std::size_t> &element)
  {
    elements +=
      fmt::format("{} {} 2 {} {} {}\n", ++n_elements, type, tag, tag, fmt::join(element, " "));
  }

  void
  MeshText::add_vertex(const std::size_t number, const double x, const double y, const double z)
  {
    vertices += fmt::format("{} {} {} {}\n", number, x, y, z);
    ++n_vertices;
  }

  std::string
  MeshText::text() const
  {
    return fmt::format(
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n{}"
      "$EndPhysicalNames\n$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
      n_names,
      names,
      n_vertices,
      vertices,
      n_elements,
      elements);
  }

  Vector
  grid_lines(const Vector &breaks, const std::vector<unsigned int> &counts, const Vector &growth)
  {
    Vector lines = {breaks[0]};
    for (std::size_t i = 0; i < counts.size(); ++i)
      {
        const double total = growth.empty() ? 1. : growth[i];
        const double ratio = counts[i] > 1 ? std::pow(total, 1. / (counts[i] - 1.)) : 1.;
        Vector sizes(counts[i], 1.);
        double sum = 1.;
        for (std::size_t k = 1; k < counts[i]; ++k)
          sum += sizes[k] = sizes[k - 1] * ratio;
        double at = 0.;
        for (std::size_t k = 0; k + 1 < counts[i]; ++k)
          {
            at += sizes[k];
            lines.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * (at / sum));
          }
        lines.push_back(breaks[i + 1]);
      }
    return lines;
  }

  double
  aspect_of(const std::vector<double> &sides)
  {
    const auto [shortest, longest] = std::minmax_element(sides.begin(), sides.end());
    return *longest / *shortest;
  }

  double
  size_ratio_of(const std::vector<Vector> &lines)
  {
    double result = 1.;
    for (const Vector &along : lines)
      {
        Vector sides;
        for (std::size_t i = 0; i + 1 < along.size(); ++i)
          sides.push_back(along[i + 1] - along[i]);
        result = std::max(result, aspect_of(sides));
      }
    return result;
  }
} // namespace fuga::stress

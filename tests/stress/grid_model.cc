// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/grid_model.h"

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

  int
  GridModel::body(const std::size_t i, const std::size_t j) const
  {
    // Indices left of and below the grid have wrapped around.
    return i < x.size() - 1 && j < y.size() - 1 ? body_of_cell(i, j) : none;
  }

  std::map<std::string, std::vector<std::array<std::size_t, 2>>>
  GridModel::faces() const
  {
    std::map<std::string, std::vector<std::array<std::size_t, 2>>> result;
    const auto vertex = [&](const std::size_t i, const std::size_t j) { return i + x.size() * j; };
    const auto add    = [&](const int before,
                         const int behind,
                         const char *const side_of_before,
                         const char *const side_of_behind,
                         const std::array<std::size_t, 2> &face) {
      if (before == behind)
        return;
      if (before == none || behind == none)
        result[bodies[static_cast<std::size_t>(std::max(before, behind))].name + '_' +
               (before == none ? side_of_behind : side_of_before)]
          .push_back(face);
      else
        result[bodies[static_cast<std::size_t>(std::min(before, behind))].name + '-' +
               bodies[static_cast<std::size_t>(std::max(before, behind))].name]
          .push_back(face);
    };
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i)
        {
          if (i + 1 < x.size())
            add(body(i, j - 1), body(i, j), "top", "bottom", {{vertex(i, j), vertex(i + 1, j)}});
          if (j + 1 < y.size())
            add(body(i - 1, j), body(i, j), "right", "left", {{vertex(i, j), vertex(i, j + 1)}});
        }
    return result;
  }

  void
  GridModel::join_all(const std::function<Layer()> &make_layer)
  {
    for (const auto &[name, unused] : faces())
      {
        const auto hyphen = name.find('-');
        if (hyphen != name.npos)
          joints.push_back({name, name.substr(hyphen + 1), name.substr(0, hyphen), make_layer()});
      }
  }

  std::string
  GridModel::mesh_text() const
  {
    const auto all_faces = faces();
    std::string names, elements;
    std::size_t n_names = 0, n_elements = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b, ++n_names)
      names += fmt::format("2 {} \"{}\"\n", b + 1, bodies[b].name);
    std::size_t tag = 100;
    for (const auto &[name, lines] : all_faces)
      {
        names += fmt::format("1 {} \"{}\"\n", ++tag, name);
        ++n_names;
        for (const auto &line : lines)
          elements +=
            fmt::format("{} 1 2 {} {} {} {}\n", ++n_elements, tag, tag, line[0] + 1, line[1] + 1);
      }
    for (const auto &[name, place] : points)
      {
        names += fmt::format("0 {} \"{}\"\n", ++tag, name);
        ++n_names;
        elements += fmt::format(
          "{} 15 2 {} {} {}\n", ++n_elements, tag, tag, place[0] + x.size() * place[1] + 1);
      }
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (const int b = body_of_cell(i, j); b != none)
          {
            const std::size_t a = i + x.size() * j + 1, d = a + x.size();
            const auto add = [&](const int type, const std::vector<std::size_t> &vertices) {
              elements += fmt::format(
                "{} {} 2 {} {} {}\n", ++n_elements, type, b + 1, b + 1, fmt::join(vertices, " "));
            };
            if (!triangles)
              add(3, {a, a + 1, d + 1, d});
            else
              {
                add(2, {a, a + 1, d + 1});
                add(2, {a, d + 1, d});
              }
          }

    // Only vertices that a cell uses: others would belong to no body.
    std::string vertices;
    std::size_t n_vertices = 0;
    for (std::size_t j = 0; j < y.size(); ++j)
      for (std::size_t i = 0; i < x.size(); ++i)
        if (body(i, j) != none || body(i - 1, j) != none || body(i, j - 1) != none ||
            body(i - 1, j - 1) != none)
          {
            const std::array<double, 2> at =
              map ? map(x[i], y[j]) : std::array<double, 2>{{x[i], y[j]}};
            vertices += fmt::format("{} {} {} 0\n", i + x.size() * j + 1, at[0], at[1]);
            ++n_vertices;
          }
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

  // Outer boundaries without support, load or obstacle; the program wants them named.
  std::set<std::string>
  GridModel::free_boundaries() const
  {
    std::set<std::string> result;
    for (const auto &[name, unused] : faces())
      if (name.find('-') == name.npos && supports.count(name) == 0)
        result.insert(name);
    for (const Load &load : loads)
      result.erase(load.target);
    for (const Joint &joint : joints)
      result.erase(joint.plus);
    return result;
  }

  std::string
  GridModel::joint_text() const
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
  GridModel::load_text() const
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
        std::string histories;
        for (std::size_t l = 0; l < loads.size(); ++l)
          if (stages[s][l] != before[l] || (histories.empty() && l + 1 == loads.size()))
            histories += fmt::format("{}load_{}: {}*(1-t) + {}*t",
                                     histories.empty() ? "" : "; ",
                                     l,
                                     before[l],
                                     stages[s][l]);
        text += fmt::format(
          "subsection stage_{}\nset Loads = {}\nset Levels = {}\nend\n", s, histories, load_levels);
        before = stages[s];
      }
    return text + "end\n";
  }

  std::string
  GridModel::parameter_text(const std::string &mesh_file) const
  {
    std::string text = fmt::format("subsection Mesh\nset File = {}\nset Polynomial degree = {}\n"
                                   "set Assumption = {}\nend\nsubsection Bodies\n",
                                   mesh_file,
                                   degree,
                                   plane_stress ? "plane stress" : "plane strain");
    for (const Body &b : bodies)
      text += fmt::format("subsection {}\nset Young modulus = {}\nset Poisson ratio = {}\n"
                          "set Weight density = {}\nend\n",
                          b.name,
                          b.young_modulus,
                          b.poisson_ratio,
                          b.weight);
    text += "end\n" + joint_text() + "subsection Boundaries\n";
    for (const auto &[boundary, components] : supports)
      text += fmt::format("subsection {}\nset Fixed = {}\nend\n", boundary, components);
    for (const std::string &boundary : free_boundaries())
      text += fmt::format("subsection {}\nset Fixed = free\nend\n", boundary);
    text += "end\n" + load_text();
    return text + fmt::format(
                    "subsection Solver\nset Certificate bound = {}\nset Non-unique = first\nend\n"
                    "subsection Output\nset Fields = end\nset Log = quiet\nend\n",
                    certificate_bound);
  }

  double
  GridModel::largest_aspect() const
  {
    double result = 1.;
    for (std::size_t j = 0; j + 1 < y.size(); ++j)
      for (std::size_t i = 0; i + 1 < x.size(); ++i)
        if (body_of_cell(i, j) != none)
          {
            const double dx = x[i + 1] - x[i], dy = y[j + 1] - y[j];
            result = std::max({result, dx / dy, dy / dx});
          }
    return result;
  }

  double
  GridModel::size_ratio() const
  {
    double result = 1.;
    for (const Vector &lines : {x, y})
      {
        double shortest = lines[1] - lines[0], longest = shortest;
        for (std::size_t i = 0; i + 1 < lines.size(); ++i)
          {
            shortest = std::min(shortest, lines[i + 1] - lines[i]);
            longest  = std::max(longest, lines[i + 1] - lines[i]);
          }
        result = std::max(result, longest / shortest);
      }
    return result;
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
} // namespace fuga::stress

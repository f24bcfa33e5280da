// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_mesh_mesh_builder_h
#define fuga_tests_mesh_mesh_builder_h

#include <fuga/base/errors.h>
#include <fuga/mesh/joint_splitter.h>

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace fuga_tests
{
  /** The sentence of the InputError that @p action throws; fails if it throws none. */
  template <typename Action>
  std::string
  complaint(const Action &action)
  {
    try
      {
        action();
      }
    catch (const fuga::InputError &error)
      {
        return error.what();
      }
    ADD_FAILURE() << "no InputError was thrown";
    return "";
  }

  inline void
  expect_parts(const std::string &sentence, const std::vector<std::string> &parts)
  {
    for (const std::string &part : parts)
      EXPECT_NE(sentence.find(part), std::string::npos)
        << "'" << part << "' is not in: " << sentence;
  }

  /** Joint along a line of a conforming mesh. */
  inline fuga::JointDefinition
  line_joint(const std::string &line, const std::string &plus_body, const std::string &minus_body)
  {
    fuga::JointDefinition joint;
    joint.name       = line;
    joint.line       = line;
    joint.plus_body  = plus_body;
    joint.minus_body = minus_body;
    return joint;
  }

  /** Joint of a mesh that is open; without minus lip against a rigid obstacle. */
  inline fuga::JointDefinition
  lip_joint(const std::string &name, const std::string &plus_lip, const std::string &minus_lip)
  {
    fuga::JointDefinition joint;
    joint.name          = name;
    joint.plus_lip      = plus_lip;
    joint.minus_lip     = minus_lip;
    joint.against_rigid = minus_lip.empty();
    return joint;
  }

  /** Builds small plane meshes by hand. */
  class MeshBuilder
  {
  public:
    MeshBuilder()
    {
      mesh.file_name = "hand.msh";
      mesh.dimension = 2;
    }

    /** nx x ny unit squares with the lower left corner at the origin, all in body 1. */
    static MeshBuilder
    grid(const unsigned int nx, const unsigned int ny)
    {
      MeshBuilder builder;
      builder.mesh.physical_names[{2, 1}] = "plate";
      for (unsigned int j = 0; j <= ny; ++j)
        for (unsigned int i = 0; i <= nx; ++i)
          builder.mesh.vertices.push_back({{double(i), double(j), 0.}});
      for (unsigned int j = 0; j < ny; ++j)
        for (unsigned int i = 0; i < nx; ++i)
          {
            const unsigned int v = j * (nx + 1) + i;
            builder.cell(fuga::CellShape::quadrilateral, {v, v + 1, v + nx + 2, v + nx + 1}, 1);
          }
      return builder;
    }

    void
    cell(const fuga::CellShape shape, const std::vector<unsigned int> &vertices, const int body)
    {
      mesh.cells.push_back(entity(shape, vertices, body));
    }

    /** A chain of lines in the named group. */
    void
    chain(const std::string &name, const int tag, const std::vector<unsigned int> &vertices)
    {
      mesh.physical_names[{1, tag}] = name;
      for (std::size_t i = 1; i < vertices.size(); ++i)
        mesh.faces.push_back(entity(fuga::CellShape::line, {vertices[i - 1], vertices[i]}, tag));
    }

    void
    point(const std::string &name, const int tag, const unsigned int vertex)
    {
      mesh.physical_names[{0, tag}] = name;
      mesh.points.push_back(entity(fuga::CellShape::point, {vertex}, tag));
    }

    static fuga::MeshEntity
    entity(const fuga::CellShape shape, const std::vector<unsigned int> &vertices, const int tag)
    {
      fuga::MeshEntity result;
      result.shape        = shape;
      result.physical_tag = tag;
      for (std::size_t i = 0; i < vertices.size(); ++i)
        result.vertices[i] = vertices[i];
      return result;
    }

    fuga::GmshMesh mesh;
  };

  inline unsigned int
  n_faces_labelled(const fuga::JointedMesh &mesh, const std::string &name)
  {
    unsigned int n = 0;
    for (const auto &face : mesh.faces)
      n += mesh.label_names[face.label] == name;
    return n;
  }

  /** nx x ny unit squares: the lowest row is body "lower" (1), all above is "upper" (2). */
  inline MeshBuilder
  two_rows(const unsigned int nx, const unsigned int ny)
  {
    MeshBuilder builder                 = MeshBuilder::grid(nx, ny);
    builder.mesh.physical_names[{2, 1}] = "lower";
    builder.mesh.physical_names[{2, 2}] = "upper";
    for (std::size_t c = nx; c < builder.mesh.cells.size(); ++c)
      builder.mesh.cells[c].physical_tag = 2;
    return builder;
  }

  /** 2 x 2 unit squares: bodies a b below, c d above; vertex 4 is the centre. */
  inline MeshBuilder
  four_blocks()
  {
    MeshBuilder builder = MeshBuilder::grid(2, 2);
    for (int i = 0; i < 4; ++i)
      {
        builder.mesh.cells[static_cast<std::size_t>(i)].physical_tag = i + 1;
        builder.mesh.physical_names[{2, i + 1}] = std::string(1, static_cast<char>('a' + i));
      }
    return builder;
  }

  /** Two unit squares, "lower" and "upper", that do not share their vertices 2, 3 and 4, 5. */
  inline MeshBuilder
  open_pair(const double width)
  {
    MeshBuilder builder;
    builder.mesh.vertices = {{{0, 0, 0}},
                             {{1, 0, 0}},
                             {{1, 1, 0}},
                             {{0, 1, 0}},
                             {{0, 1, 0}},
                             {{width, 1, 0}},
                             {{width, 2, 0}},
                             {{0, 2, 0}}};
    builder.cell(fuga::CellShape::quadrilateral, {0, 1, 2, 3}, 1);
    builder.cell(fuga::CellShape::quadrilateral, {4, 5, 6, 7}, 2);
    builder.mesh.physical_names[{2, 1}] = "lower";
    builder.mesh.physical_names[{2, 2}] = "upper";
    builder.chain("top", 11, {3, 2});
    builder.chain("base", 12, {4, 5});
    return builder;
  }

  /** Splits and expects an InputError with these parts. */
  inline void
  expect_joint_complaint(const MeshBuilder &builder,
                         const std::vector<fuga::JointDefinition> &joints,
                         const std::vector<std::string> &parts)
  {
    expect_parts(complaint([&] { fuga::split_joints(builder.mesh, joints); }), parts);
  }
} // namespace fuga_tests

#endif

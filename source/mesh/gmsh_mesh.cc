// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/mesh/gmsh_mesh.h>
#include <fuga/mesh/gmsh_reader.h>
#include <fuga/mesh/text_scanner.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace fuga
{
  namespace
  {
    /** Read the whole file at once; the string grows with what is really there. */
    std::string
    read_file(const std::string &file_name)
    {
      std::error_code ignored;
      if (std::filesystem::is_directory(file_name, ignored))
        throw InputError(fmt::format(
          "{}: this is a directory; a Gmsh mesh file (.msh, version 2.2 or 4.1, ASCII) is "
          "needed; give the name of the file in it",
          file_name));
      const std::unique_ptr<std::FILE, int (*)(std::FILE *)> file(
        std::fopen(file_name.c_str(), "rb"), &std::fclose);
      if (file == nullptr)
        throw InputError(
          fmt::format("{}: the mesh file cannot be opened ({}); check the name and the "
                      "rights (names are relative to the parameter file)",
                      file_name,
                      std::strerror(errno)));
      std::string text;
      std::size_t size = 0;
      do
        {
          text.resize(size + (size < 1000000 ? 1000000 : size));
          size += std::fread(&text[size], 1, text.size() - size, file.get());
        }
      while (size == text.size());
      if (std::ferror(file.get()) != 0)
        throw InputError(fmt::format("{}: the mesh file cannot be read ({}); check the disk",
                                     file_name,
                                     std::strerror(errno)));
      text.resize(size);
      return text;
    }

    struct Shape
    {
      unsigned int dimension, n_vertices, n_faces;
      CellShape face;
    };

    const Shape &
    shape_of(const CellShape shape)
    {
      using Type = CellShape;
      // The entries are in the order of CellShape.
      static constexpr std::array<Shape, 6> shapes = {{{0, 1, 0, Type::point},
                                                       {1, 2, 2, Type::point},
                                                       {2, 3, 3, Type::line},
                                                       {2, 4, 4, Type::line},
                                                       {3, 4, 4, Type::triangle},
                                                       {3, 8, 6, Type::quadrilateral}}};
      return shapes[static_cast<std::size_t>(shape)];
    }
  } // namespace


  unsigned int
  n_vertices(const CellShape shape)
  {
    return shape_of(shape).n_vertices;
  }


  unsigned int
  dimension(const CellShape shape)
  {
    return shape_of(shape).dimension;
  }


  unsigned int
  n_faces(const CellShape shape)
  {
    return shape_of(shape).n_faces;
  }


  CellShape
  face_shape(const CellShape shape)
  {
    return shape_of(shape).face;
  }


  GmshMesh
  parse_gmsh_mesh(const std::string_view text, const std::string &file_name)
  {
    TextScanner scanner(file_name, text);
    const GmshContents contents = GmshReader(scanner).read();
    return assemble_gmsh_mesh(contents, scanner, file_name);
  }


  GmshMesh
  read_gmsh_mesh(const std::string &file_name)
  {
    return parse_gmsh_mesh(read_file(file_name), file_name);
  }
} // namespace fuga

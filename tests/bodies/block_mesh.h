// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_bodies_block_mesh_h
#define fuga_tests_bodies_block_mesh_h

#include <fuga/bodies/condensed/condensed_system.h>

#include <algorithm>
#include <functional>

namespace fuga::test
{
  using Map = std::function<std::array<double, 2>(double, double)>;

  /** Open meshes of mapped unit squares, put together by hand. */
  class BlockMesh
  {
  public:
    JointedMesh mesh;

    explicit BlockMesh(const bool use_triangles = false) : triangles(use_triangles)
    {
      mesh.dimension = 2;
    }

    unsigned int
    label(const std::string &name)
    {
      const auto at = std::find(mesh.label_names.begin(), mesh.label_names.end(), name);
      if (at != mesh.label_names.end())
        return static_cast<unsigned int>(at - mesh.label_names.begin());
      mesh.label_names.push_back(name);
      return static_cast<unsigned int>(mesh.label_names.size() - 1);
    }

    /** The image of nx x ny cells under @p map; an empty label leaves the side without group. */
    void
    add_block(const std::string &body,
              const unsigned int nx,
              const unsigned int ny,
              const Map &map,
              const std::array<std::string, 4> &bottom_right_top_left)
    {
      const unsigned int first = static_cast<unsigned int>(mesh.vertices.size());
      const auto id            = [&](const unsigned int i, const unsigned int j) {
        return first + i + j * (nx + 1);
      };
      for (unsigned int j = 0; j <= ny; ++j)
        for (unsigned int i = 0; i <= nx; ++i)
          {
            const auto at = map(static_cast<double>(i) / nx, static_cast<double>(j) / ny);
            mesh.vertices.push_back({{at[0], at[1], 0.}});
          }
      const unsigned int number = static_cast<unsigned int>(mesh.body_names.size());
      mesh.body_names.push_back(body);
      for (unsigned int j = 0; j < ny; ++j)
        for (unsigned int i = 0; i < nx; ++i)
          if (triangles)
            {
              add_cell(number, {id(i, j), id(i + 1, j), id(i + 1, j + 1)});
              add_cell(number, {id(i, j), id(i + 1, j + 1), id(i, j + 1)});
            }
          else
            add_cell(number, {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)});
      for (unsigned int i = 0; i < nx; ++i)
        {
          add_face(id(i, 0), id(i + 1, 0), bottom_right_top_left[0]);
          add_face(id(i, ny), id(i + 1, ny), bottom_right_top_left[2]);
        }
      for (unsigned int j = 0; j < ny; ++j)
        {
          add_face(id(nx, j), id(nx, j + 1), bottom_right_top_left[1]);
          add_face(id(0, j), id(0, j + 1), bottom_right_top_left[3]);
        }
    }

    /** An empty name of the minus lip stands for the rigid obstacle. */
    void
    add_joint(const std::string &name, const std::string &plus, const std::string &minus)
    {
      mesh.joints.push_back(
        {name, label(plus), minus.empty() ? JointedMesh::no_label : label(minus)});
    }

    /** Names the vertex at a place (the last one of several). */
    void
    name_point(const std::string &name, const double x, const double y)
    {
      for (unsigned int i = static_cast<unsigned int>(mesh.vertices.size()); i-- > 0;)
        if (std::abs(mesh.vertices[i][0] - x) + std::abs(mesh.vertices[i][1] - y) < 1e-12)
          {
            mesh.points.push_back({i, name});
            return;
          }
    }

  private:
    void
    add_cell(const unsigned int body, const std::vector<unsigned int> &vertices)
    {
      JointedMesh::Cell cell;
      cell.shape = vertices.size() == 3 ? CellShape::triangle : CellShape::quadrilateral;
      std::copy(vertices.begin(), vertices.end(), cell.vertices.begin());
      cell.body = body;
      mesh.cells.push_back(cell);
    }

    void
    add_face(const unsigned int a, const unsigned int b, const std::string &name)
    {
      if (name.empty())
        return;
      JointedMesh::Face face;
      face.vertices = {{a, b, 0, 0}};
      face.label    = label(name);
      mesh.faces.push_back(face);
    }

    bool triangles;
  };

  inline Map
  rectangle(const double x0, const double x1, const double y0, const double y1)
  {
    return [=](const double s, const double r) {
      return std::array<double, 2>{{x0 + (x1 - x0) * s, y0 + (y1 - y0) * r}};
    };
  }

  inline void
  add_material(ModelDefinition &model,
               const std::string &body,
               const double young_modulus,
               const double poisson_ratio,
               const double weight = 0.)
  {
    model.materials.push_back({body, young_modulus, poisson_ratio, weight});
  }

  /** @p held: components, e.g. "xz"; empty: named free. */
  inline void
  hold(ModelDefinition &model, const std::string &boundary, const std::string &held)
  {
    BoundaryCondition condition;
    condition.boundary = boundary;
    condition.fixed    = {
         {held.find('x') != held.npos, held.find('y') != held.npos, held.find('z') != held.npos}};
    condition.named_free = held.empty();
    model.boundary_conditions.push_back(condition);
  }

  inline void
  add_load(ModelDefinition &model,
           const LoadKind kind,
           const std::vector<std::string> &targets,
           const std::vector<std::string> &expressions)
  {
    LoadDefinition load;
    load.name        = "L" + std::to_string(model.loads.size());
    load.kind        = kind;
    load.targets     = targets;
    load.expressions = expressions;
    model.loads.push_back(load);
  }

  /** Takes all loads of the model at time 0 as patterns. */
  template <int dim>
  void
  set_all_loads(CondensedSystem<dim> &system, const ModelDefinition &model)
  {
    std::vector<LoadPattern> patterns;
    for (std::size_t i = 0; i < model.loads.size(); ++i)
      patterns.push_back(system.assemble_load(i, 0.));
    system.set_load_patterns(std::move(patterns));
  }

  /** Of all bodies. */
  double
  strain_energy(const CondensedSystem<2> &system, const dealii::Vector<double> &u);

  /** The elements of a parametrised test. */
  struct Kind
  {
    bool triangles;
    unsigned int degree;
  };

  inline std::ostream &
  operator<<(std::ostream &out, const Kind &kind)
  {
    return out << (kind.triangles ? "P" : "Q") << kind.degree;
  }

  struct Solution
  {
    Vector x, jumps, p;
  };

  /** All loads at factor one, all joints closed and linear: (S + Bᵀ C B) x = F a, p = C B x. */
  Solution
  solve_linear(const CondensedSystem<2> &system, const double rho_n, const double rho_t);

  /** B x. */
  Vector
  apply_jump_operator(const CondensedSystem<2> &system, const Vector &x);

  /** Four blocks a, b below and c, d above round a crossing, n x n cells of the size 1/n each, with
   *  joints of the length 1: first ah and bh, which are level, then av and cv, upright. */
  BlockMesh
  blocks_round_a_crossing(const unsigned int n);

  /** A block 3 x 2 on a foundation 3 x 1, held at its base and sides. */
  BlockMesh
  two_blocks();

  ModelDefinition
  two_block_model();

  /** What the constructor of the system complains about. */
  std::string
  message_of(const JointedMesh &mesh, const ModelDefinition &model);

  void
  expect_message(const std::string &message, const std::vector<std::string> &parts);
} // namespace fuga::test

#endif

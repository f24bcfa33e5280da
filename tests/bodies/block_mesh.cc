// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <gtest/gtest.h>

#include <numeric>

namespace fuga::test
{
  double
  strain_energy(const CondensedSystem<2> &system, const dealii::Vector<double> &u)
  {
    const Vector of_cells = system.cell_energies(system.discretization().by_nodes(u));
    return std::accumulate(of_cells.begin(), of_cells.end(), 0.);
  }


  Vector
  apply_jump_operator(const CondensedSystem<2> &system, const Vector &x)
  {
    return multiply(system.jump_operator(), x);
  }


  Solution
  solve_linear(const CondensedSystem<2> &system, const double rho_n, const double rho_t)
  {
    DenseMatrix K       = system.stiffness();
    const std::size_t m = K.rows();
    Vector C(system.rigid_motions().rows());
    for (const auto &element : system.elements())
      {
        C[element.normal_bar] = element.area / rho_n;
        if (element.has_tangential_bar())
          C[element.tangential_bar] = element.area / rho_t;
      }
    add_congruent(system.jump_operator(), C, K);
    DenseMatrix x(m, 1);
    for (std::size_t i = 0; i < m; ++i)
      for (Eigen::Index j = 0; j < system.load_patterns().cols(); ++j)
        x(i, 0) += system.load_patterns()(i, j);
    if (!solve_positive_definite(K, x))
      throw std::runtime_error("not positive definite");
    Solution solution;
    solution.x.assign(x.data(), x.data() + m);
    solution.jumps = apply_jump_operator(system, solution.x);
    for (std::size_t k = 0; k < C.size(); ++k)
      solution.p.push_back(C[k] * solution.jumps[k]);
    return solution;
  }


  BlockMesh
  blocks_round_a_crossing(const unsigned int n)
  {
    BlockMesh mesh;
    mesh.add_block("a", n, n, rectangle(-1., 0., -1., 0.), {{"b", "av-", "ah-", "l"}});
    mesh.add_block("b", n, n, rectangle(0., 1., -1., 0.), {{"b", "r", "bh-", "av+"}});
    mesh.add_block("c", n, n, rectangle(-1., 0., 0., 1.), {{"ah+", "cv-", "t", "l"}});
    mesh.add_block("d", n, n, rectangle(0., 1., 0., 1.), {{"bh+", "r", "t", "cv+"}});
    for (const char *joint : {"ah", "bh", "av", "cv"})
      mesh.add_joint(joint, std::string(joint) + "+", std::string(joint) + "-");
    return mesh;
  }

  BlockMesh
  two_blocks()
  {
    BlockMesh mesh;
    mesh.add_block("lower", 6, 2, rectangle(-1., 2., -1., 0.), {{"base", "side", "J-", "side"}});
    mesh.add_block("upper", 6, 3, rectangle(-1., 2., 0., 2.), {{"J+", "free", "top", "free"}});
    mesh.add_joint("J", "J+", "J-");
    return mesh;
  }

  ModelDefinition
  two_block_model()
  {
    ModelDefinition model;
    add_material(model, "lower", 30000., 0.25);
    add_material(model, "upper", 3000., 0.2, 0.024);
    hold(model, "base", "xy");
    hold(model, "side", "x");
    hold(model, "free", "");
    add_load(model, LoadKind::weight, {"upper"}, {});
    add_load(model, LoadKind::traction, {"top"}, {"0.01*x", "-0.02*(x+2)"});
    return model;
  }

  std::string
  message_of(const JointedMesh &mesh, const ModelDefinition &model)
  {
    try
      {
        const CondensedSystem<2> system(mesh, model, std::vector<bool>(mesh.joints.size(), false));
      }
    catch (const std::runtime_error &error)
      {
        return error.what();
      }
    return "";
  }

  void
  expect_message(const std::string &message, const std::vector<std::string> &parts)
  {
    for (const auto &part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << part << " is not in: " << message;
  }
} // namespace fuga::test

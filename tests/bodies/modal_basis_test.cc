// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "block_mesh.h"

#include <fuga/base/numerics/eigenpairs.h>
#include <fuga/bodies/elasticity/rigid_pieces.h>
#include <fuga/bodies/motion/modal_basis.h>
#include <fuga/bodies/space/discretization.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace fuga::test
{
  namespace
  {
    const double pi = std::acos(-1.);

    // Second differences of n numbers between zeros: 2 - 2 cos(kπ/(n + 1)), k = n … 1.
    TEST(Eigenpairs, OfSecondDifferences)
    {
      constexpr std::size_t n = 200;
      const auto product      = [](const Vector &x) {
        Vector y(x.size());
        for (std::size_t i = 0; i < n; ++i)
          y[i] = 2. * x[i] - (i > 0 ? x[i - 1] : 0.) - (i + 1 < n ? x[i + 1] : 0.);
        return y;
      };
      const Eigenpairs some = largest_eigenpairs(n, 10, product);
      DenseMatrix A(n, n);
      for (std::size_t j = 0; j < n; ++j)
        {
          Vector unit(n, 0.);
          unit[j]            = 1.;
          const Vector image = product(unit);
          A.col(j)           = view(image);
        }
      const Eigenpairs all = eigenpairs(A);
      ASSERT_EQ(some.values.size(), 10U);
      ASSERT_EQ(all.values.size(), n);
      for (std::size_t k = 0; k < n; ++k)
        {
          const double known = 2. - 2. * std::cos(static_cast<double>(n - k) * pi / (n + 1.));
          EXPECT_NEAR(all.values[k], known, 1e-13);
        }
      for (std::size_t k = 0; k < 10; ++k)
        {
          EXPECT_NEAR(some.values[k], all.values[k], 1e-13);
          const Vector x(some.vectors.col(k).data(), some.vectors.col(k).data() + n);
          Vector rest = product(x);
          add_multiple(-some.values[k], x, rest);
          EXPECT_LT(max_abs(rest), 1e-12);
          EXPECT_NEAR(dot(x, x), 1., 1e-13);
        }
    }

    /** Two bars of n cells, each between a joint and its free end: all modes with the joints bonded
     * are double, of which one Lanczos iteration may see one only. */
    struct Bars
    {
      static constexpr double young = 900., length = 10., mass_per_length = 1.;
      BlockMesh mesh;
      ModelDefinition model;
      Vector mass;

      explicit Bars(const unsigned int n)
      {
        for (const double x : {0., 2.})
          {
            const std::string name = x == 0. ? "one" : "other";
            mesh.add_block(name,
                           1,
                           n,
                           rectangle(x, x + 1., 0., length),
                           {{name + " foot", "right", "top", "left"}});
            mesh.add_joint("under " + name, name + " foot", "");
            add_material(model, name, young, 0., 10.);
          }
        hold(model, "left", "x");
        hold(model, "right", "x");
        hold(model, "top", "");
      }

      /** That of a cell in quarters at its nodes. */
      void
      put_mass(const CondensedSystem<2> &system)
      {
        const Discretization<2> &space = system.discretization();
        mass.assign(space.n_dofs(), 0.);
        for (std::size_t cell = 0; cell < space.n_cells(); ++cell)
          for (std::size_t i = 0; i < 4; ++i)
            mass[space.cell_nodes(cell)[i] * 2 + 1] +=
              0.5 * mass_per_length * length / static_cast<double>(space.n_cells());
        for (std::size_t dof = 0; dof < mass.size(); ++dof)
          if (system.fixed_dofs()[dof])
            mass[dof] = 0.;
      }
    };

    // A chain of n masses: ω = 2 (c/h) sin((2k - 1)π/(4n)), c = √(E/ρ). Shear between the two
    // columns of nodes of a bar makes other modes.
    void
    expect_chain(const unsigned int n, const double highest, const std::size_t at_least)
    {
      Bars bar(n);
      const CondensedSystem<2> system(bar.mesh.mesh, bar.model, {false, false});
      bar.put_mass(system);
      const ModalBasis basis = make_modal_basis(system, bar.mass, highest);
      const double rate  = 2. * std::sqrt(Bars::young / Bars::mass_per_length) * n / Bars::length;
      const double limit = std::pow(2. * pi * highest, 2);
      std::size_t found  = 0;
      for (unsigned int k = 1; k <= n; ++k)
        {
          const double square = std::pow(rate * std::sin((2. * k - 1.) * pi / (4. * n)), 2);
          if (square > limit)
            break;
          EXPECT_EQ(std::count_if(
                      basis.squares.begin(),
                      basis.squares.end(),
                      [&](const double value) { return std::abs(value / square - 1.) < 1e-10; }),
                    2)
            << "mode " << k;
          ++found;
        }
      EXPECT_GE(found, at_least);
      for (const double value : basis.squares)
        EXPECT_LT(value, limit);
      // A motion of a joint moves the bar as a rigid body, the mass of which is in L and R.
      const Vector x(system.rigid_coordinates().col(0).data(),
                     system.rigid_coordinates().col(0).data() + system.n_coordinates());
      const Vector momenta = multiply(basis.coupling, x);
      const double sum     = dot(momenta, momenta) + dot(x, multiply(basis.residual_mass, x));
      double expected      = 0.;
      const Vector field   = system.rigid_pieces().free_motion(0);
      for (std::size_t dof = 0; dof < field.size(); ++dof)
        expected += bar.mass[dof] * field[dof] * field[dof];
      EXPECT_NEAR(sum, expected, 1e-11 * expected);
    }

    TEST(ModalBasis, FrequenciesOfABarByLapack)
    {
      expect_chain(20, 1e3, 20);
    }

    TEST(ModalBasis, FrequenciesOfABarByLanczos)
    {
      expect_chain(400, 40., 25);
    }
  } // namespace
} // namespace fuga::test

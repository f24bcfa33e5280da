// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Waves along a column that goes on for ever: through its base, from its surface, across a joint.

#include "known_answer.h"
#include "scenes/grid_mesh.h"
#include "scenes/incoming_wave.h"

#include <gtest/gtest.h>

#include <cmath>

namespace fuga::tests
{
  namespace
  {
    using Json = nlohmann::ordered_json;

    constexpr double pi = 3.14159265358979323846;

    /**
     * A column, one cell wide and cut by the line `joint` at y = 0, which is between the bodies
     * `lower` and `upper`; `bottom`, `top`; its sides are `sides`, but `lips` in the cells at the
     * joint.
     */
    GmshMesh
    cut_column(const double width, const Axis &ys)
    {
      GmshMesh mesh;
      mesh.dimension      = 2;
      mesh.physical_names = {{{2, 1}, "lower"},
                             {{2, 2}, "upper"},
                             {{1, 3}, "joint"},
                             {{1, 4}, "bottom"},
                             {{1, 5}, "top"},
                             {{1, 6}, "sides"},
                             {{1, 7}, "lips"}};
      const auto line     = [&mesh](const int group, const std::size_t a, const std::size_t b) {
        MeshEntity entity;
        entity.shape        = CellShape::line;
        entity.physical_tag = group;
        entity.vertices[0]  = static_cast<unsigned int>(a);
        entity.vertices[1]  = static_cast<unsigned int>(b);
        mesh.faces.push_back(entity);
      };
      for (const double y : ys)
        for (const double x : {0., width})
          mesh.vertices.push_back({{x, y, 0.}});
      for (std::size_t i = 0; i < ys.size(); ++i)
        if (i == 0 || i + 1 == ys.size() || ys[i] == 0.)
          line(i == 0 ? 4 : ys[i] == 0. ? 3 : 5, 2 * i, 2 * i + 1);
      for (std::size_t i = 0; i + 1 < ys.size(); ++i)
        {
          MeshEntity cell;
          cell.shape        = CellShape::quadrilateral;
          cell.physical_tag = ys[i] < 0. ? 1 : 2;
          std::size_t k     = 0;
          for (const std::size_t vertex : {2 * i, 2 * i + 1, 2 * i + 3, 2 * i + 2})
            cell.vertices[k++] = static_cast<unsigned int>(vertex);
          mesh.cells.push_back(cell);
          const int group = ys[i] == 0. || ys[i + 1] == 0. ? 7 : 6;
          line(group, 2 * i, 2 * i + 2);
          line(group, 2 * i + 1, 2 * i + 3);
        }
      return mesh;
    }

    /** What of the energy of a harmonic shear wave that comes up goes through a joint, and what is
     * thrown back, in the last period. */
    struct Shares
    {
      double through = 0., back = 0.;
    };

    constexpr double frequency = 5., amplitude = 0.01; // Hz, m/s

    // Nearly rigid layers, whose lips have mass: (ωZ/2k)² = 1e-7.
    // The sides of a column that is much wider than its cells are high hold it like the
    // ground beside it; the lips are free across the joint, and a thousandth of their shear at most
    // goes into turning them.
    Shares
    shares_of_wave(const Json &joint)
    {
      constexpr double period = 1. / frequency, length = shear_speed * period, duration = 1.,
                       step  = 0.001;
      constexpr double omega = 2. * pi * frequency;
      Json scene;
      scene["Bodies"]["lower"] = scene["Bodies"]["upper"] = rock();
      scene["Joints"]["fault"]                            = joint;
      scene["Joints"]["fault"]["Line"]                    = "joint";
      scene["Joints"]["fault"]["Plus body"]               = "upper";
      scene["Joints"]["fault"]["Minus body"]              = "lower";
      scene["Joints"]["fault"]["Normal stiffness"]        = 1e4;
      scene["Joints"]["fault"]["Tensile strength"]        = 1.;
      scene["Boundaries"]["sides"]["Fixed"]               = "y";
      scene["Boundaries"]["lips"]["Fixed"]                = "free";
      scene["Mesh"]["Polynomial degree"]                  = 3;
      scene["Loads"]["none"]                              = {{"Type", "weight"}};
      scene["Stages"]["quake"] = {{"Loads", "none: 0"}, {"Duration", duration}};
      scene["Dynamics"] = {{"Time step", step}, {"Gravity", 10.}, {"Absorbing boundaries", "top"}};
      scene["Earthquake"] = {
        {"Record x",
         write_record([](const double t) { return amplitude * omega * std::cos(omega * t); },
                      step / 4.,
                      duration)},
        {"Record unit", "length/s^2"},
        {"Baseline", "keep"},
        {"Record motion", "upward wave"},
        {"Compliant base", "bottom"}};
      scene["Monitors"]["bottom"]["Point"] = fmt::format("0, {}", -length);
      scene["Monitors"]["top"]["Point"]    = fmt::format("0, {}", length);
      const SceneRun run                   = run_scene(
        write_scene(cut_column(100. * length / 20., both_sides(uniform(0., length, 20))), scene));
      EXPECT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      Shares shares;
      const double of_wave = amplitude * amplitude * period / 2.;
      const auto add       = [&](const char *monitor, const bool comes_up, double &share) {
        const auto u = steps_of_monitor(run, monitor, "ux", duration);
        for (std::size_t i = 1; i < u.size(); ++i)
          {
            const double h = u[i][0] - u[i - 1][0];
            if (u[i][0] <= duration - period + 0.5 * step)
              continue;
            const double wave =
              amplitude / omega * (std::cos(omega * u[i - 1][0]) - std::cos(omega * u[i][0])) / h;
            const double v = (u[i][1] - u[i - 1][1]) / h - (comes_up ? wave : 0.);
            share += v * v * h / of_wave;
          }
      };
      add("top", false, shares.through);
      add("bottom", true, shares.back);
      return shares;
    }

  } // namespace

  // A wave u(t) comes up through the base of a column of height H: its free surface has 2 u(t -
  // H/c), and the base u(t) + u(t - 2 H/c). What reaches the base then leaves. The mesh delays the
  // wave by (kh)²/24 of its way, which shifts, but hardly changes, the peak.
  TEST(Waves, CompliantBase)
  {
    constexpr double height = 40., h = 1., frequency = 5., middle = 0.3, duration = 1.6;
    for (const bool shear : {true, false})
      {
        const double c = shear_speed * (shear ? 1. : std::sqrt(3.));
        Json scene;
        scene["Bodies"]["block"]               = rock();
        scene["Mesh"]["Polynomial degree"]     = 2;
        scene["Loads"]["none"]                 = {{"Type", "weight"}};
        scene["Boundaries"]["left"]["Fixed"]   = shear ? "y" : "x";
        scene["Boundaries"]["right"]["Fixed"]  = shear ? "y" : "x";
        scene["Boundaries"]["top"]["Fixed"]    = "free";
        scene["Boundaries"]["corner"]["Fixed"] = "free";
        scene["Stages"]["quake"]               = {{"Loads", "none: 0"}, {"Duration", duration}};
        scene["Dynamics"]                      = {{"Time step", 0.001}, {"Gravity", 10.}};
        scene["Earthquake"]                    = {
                             {shear ? "Record x" : "Record y",
                              write_record(
             [](const double t) { return 2. * ricker_acceleration(t, frequency, middle); },
             0.001,
             1.)},
                             {"Record unit", "length/s^2"},
                             {"Record motion", "outcrop"},
                             {"Compliant base", "contact"}};
        scene["Monitors"]["surface"]["Point"] = fmt::format("0, {}", height);
        scene["Monitors"]["base"]["Point"]    = "0, 0";
        const SceneRun run                    = run_scene(write_scene(
          block_mesh(
            uniform(0., h, 1), uniform(0., height, static_cast<std::size_t>(height / h)), h),
          scene));
        ASSERT_EQ(run.exit_code, 0);
        EXPECT_LE(run.certificate(), 1e-9);
        const std::string component = shear ? "ux" : "uy";
        double peak = 0., back = 0., at_base = 0.;
        for (const auto &[t, u] : steps_of_monitor(run, "surface", component, duration))
          {
            peak = std::max(peak, u);
            if (t > middle + height / c + 0.4)
              back = std::max(back, std::abs(u));
          }
        for (const auto &[t, u] : steps_of_monitor(run, "base", component, duration))
          at_base = std::max(at_base,
                             std::abs(u - ricker(t, frequency, middle) -
                                      ricker(t, frequency, middle + 2. * height / c)));
        const std::string wave = shear ? "shear" : "pressure";
        expect_answer({"D8 compliant base",
                       "peak at the surface of a " + wave + " wave of height 1",
                       2.,
                       "closed form (d'Alembert)"},
                      peak,
                      2e-3);
        expect_answer({"D8 compliant base",
                       "what comes back of the " + wave + " wave",
                       0.,
                       "closed form (d'Alembert)"},
                      back,
                      2e-3);
        EXPECT_LT(at_base, 0.01);
      }
  }

  // R. K. Miller, The effects of boundary friction on the propagation of elastic waves, Bull.
  // Seism. Soc. Am. 68, 1978: a plane harmonic wave of shear with the stress τ0 sin ωt meets a
  // joint that carries q τ0. What goes through is cut off at the strength, and the rest is thrown
  // back.
  TEST(Waves, SlipInHarmonicWave)
  {
    for (const double q : {0.1, 0.25, 0.5, 0.75})
      {
        const Shares shares =
          shares_of_wave({{"Shear stiffness", 1e4}, {"Cohesion", q * impedance * amplitude}});
        const double theta = std::asin(q);
        const char *source = "closed form (Miller 1978)";
        expect_answer(
          {"D6 slip in a harmonic wave",
           fmt::format("T^2 for q = {:g}", q),
           4. / pi * (theta / 2. - std::sin(2. * theta) / 4. + q * q * (pi / 2. - theta)),
           source},
          shares.through,
          1e-3);
        expect_answer({"D6 slip in a harmonic wave",
                       fmt::format("R^2 for q = {:g}", q),
                       4. / pi *
                         ((pi / 2. - theta) / 2. + std::sin(2. * theta) / 4. -
                          2. * q * std::cos(theta) + q * q * (pi / 2. - theta)),
                       source},
                      shares.back,
                      1e-3);
      }
  }

  // The same joint as a layer that does not slip (L. J. Pyrak-Nolte, L. R. Myer, N. G. W. Cook,
  // Transmission of seismic waves across single natural fractures, J. Geophys. Res. 95, 1990).
  TEST(Waves, ElasticLayer)
  {
    const double x      = 1.; // ωZ / 2k
    const Shares shares = shares_of_wave(
      {{"Shear stiffness", 2. * pi * frequency * impedance / (2. * x)}, {"Cohesion", 1.}});
    expect_answer({"D6 elastic layer in a harmonic wave",
                   "T^2 for 2k = omega Z",
                   1. / (1. + x * x),
                   "closed form (Pyrak-Nolte, Myer and Cook 1990)"},
                  shares.through,
                  1e-3);
    EXPECT_NEAR(shares.back, x * x / (1. + x * x), 1e-3);
  }
} // namespace fuga::tests

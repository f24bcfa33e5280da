// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "scenes/scene_model.h"
#include "scenes/scene_run.h"

#include <deal.II/lac/vector.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

using namespace fuga;
using namespace fuga::tests;

namespace
{
  constexpr double E1 = 3000., E2 = 1000., H1 = 1.5, H2 = 2.5, p = 0.4;

  struct LawCase
  {
    const char *name;
    /** Entries of the joint. */
    const char *layer;
    /** Closure under the pressure p = 0.4. */
    double closure;
  };

  std::ostream &
  operator<<(std::ostream &out, const LawCase &law)
  {
    return out << law.name;
  }

  // The closures are the inverse laws by hand.
  const LawCase laws[] = {
    // w = σ V_m/(K V_m + σ), K V_m = 1.
    {"hyperbolic",
     "set Normal law = hyperbolic\nset Normal stiffness = 1000\nset Normal closure limit = 1e-3",
     1e-3 * 0.4 / 1.4},
    // w = c0 (1 + ln(σ/p0)/ln 100).
    {"exponential",
     "set Normal law = exponential\nset Normal reference closure = 1e-3\n"
     "set Normal reference stress = 0.2",
     1e-3 * (1. + std::log(2.) / std::log(100.))},
    {"power_0_5",
     "set Normal law = power\nset Normal reference closure = 1e-3\n"
     "set Normal reference stress = 0.8\nset Normal exponent = 0.5",
     1e-3 * 0.25},
    {"power_1_5",
     "set Normal law = power\nset Normal reference closure = 1e-3\n"
     "set Normal reference stress = 0.8\nset Normal exponent = 1.5",
     1e-3 * std::pow(0.5, 2. / 3.)},
    {"power_5",
     "set Normal law = power\nset Normal reference closure = 1e-3\n"
     "set Normal reference stress = 0.8\nset Normal exponent = 5",
     1e-3 * std::pow(0.5, 0.2)},
    // The pressure is that of a point.
    {"spline",
     "set Normal law = tabular\nset Normal table = 0: 0; 2e-4: 0.1; 5e-4: 0.4; 7e-4: 1.2",
     5e-4},
    // Half way between two points.
    {"lines",
     "set Normal law = tabular\nset Normal table = 0: 0; 2e-4: 0.1; 5e-4: 0.7; 7e-4: 1.5\n"
     "set Normal interpolation = piecewise linear",
     3.5e-4},
    // Law (9) as a tangent at q = 1/2: σ = 3 ζ0/ρ (ln 2 - 5/8) = 0.4, w = ζ0/8.
    {"cubic_root_tangent",
     "set Normal law = cubic root tangent\nset Normal compliance = 1e-3\n"
     "set Thickness = 0.0019565495188175455",
     0.125 * 0.0019565495188175455},
    // The same written out.
    {"cubic_root_tangent_expression",
     "set Normal law = expression\n"
     "set Normal stress expression = "
     "3*0.0019565495188175455/1e-3*(-(w/0.0019565495188175455)^(2/3)/2 - "
     "(w/0.0019565495188175455)^(1/3) "
     "- ln(1 - (w/0.0019565495188175455)^(1/3)))\n"
     "set Normal tangent expression = 1e3/(1 - (w/0.0019565495188175455)^(1/3))\n"
     "set Normal closure limit = 0.0019565495188175455",
     0.125 * 0.0019565495188175455},
    // w = asinh(σ/0.2)/1000.
    {"expression",
     "set Normal law = expression\nset Normal stress expression = 0.2*sinh(1000*w)\n"
     "set Normal tangent expression = 200*cosh(1000*w)",
     1e-3 * std::asinh(2.)}};

  /** Two blocks of two cells each, one upon the other, 2 m wide. */
  void
  write_column(const std::string &name)
  {
    std::ofstream mesh(name);
    mesh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n6\n2 1 \"lower\"\n2 2 "
            "\"upper\"\n1 3 \"joint\"\n1 4 \"bottom\"\n1 5 \"top\"\n1 6 "
            "\"sides\"\n$EndPhysicalNames\n$Nodes\n9\n";
    const double heights[] = {0., H1, H1 + H2};
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i)
        mesh << 3 * j + i + 1 << " " << i << " " << heights[j] << " 0\n";
    mesh << "$EndNodes\n$Elements\n14\n";
    int number = 0;
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i)
        {
          const int a = 3 * j + i + 1;
          mesh << ++number << " 3 2 " << j + 1 << " " << j + 1 << " " << a << " " << a + 1 << " "
               << a + 4 << " " << a + 3 << "\n";
        }
    const int lines[][3] = {{3, 4, 5},
                            {3, 5, 6},
                            {4, 1, 2},
                            {4, 2, 3},
                            {5, 7, 8},
                            {5, 8, 9},
                            {6, 1, 4},
                            {6, 4, 7},
                            {6, 3, 6},
                            {6, 6, 9}};
    for (const auto &[group, a, b] : lines)
      mesh << ++number << " 1 2 " << group << " " << group << " " << a << " " << b << "\n";
    mesh << "$EndElements\n";
  }

  std::string
  column_file(const LawCase &law, const unsigned int levels)
  {
    const std::string directory = temporary_directory();
    write_column(directory + "/column.msh");
    std::ofstream(directory + "/column.prm") << fmt::format(R"(subsection Mesh
  set File = column.msh
end
subsection Bodies
  subsection lower
    set Young modulus = {}
    set Poisson ratio = 0
  end
  subsection upper
    set Young modulus = {}
    set Poisson ratio = 0
  end
end
subsection Joints
  subsection base
    set Line = joint
    set Plus body = upper
    set Minus body = lower
    set Friction coefficient = 0.5
    set Shear compliance = 1e-3
    {}
  end
end
subsection Boundaries
  subsection bottom
    set Fixed = all
  end
  subsection sides
    set Fixed = free
  end
end
subsection Loads
  subsection top
    set Type = pressure
    set Boundaries = top
    set Value = {}
  end
end
subsection Stages
  subsection load
    set Loads = top: t
    set Levels = {}
  end
  subsection unload
    set Loads = top: 1 - 0.5*t
  end
  subsection reload
    set Loads = top: 0.5 + 0.5*t
  end
end
)",
                                                            E1,
                                                            E2,
                                                            law.layer,
                                                            p,
                                                            levels);
    return directory + "/column.prm";
  }

  class ColumnScene : public testing::TestWithParam<LawCase>
  {
  };
} // namespace

// Uniaxial stress, ν = 0: the top sinks by p (H1/E1 + H2/E2) + w(p), however many levels there are,
// and comes back to the same place after unloading and reloading. The closed form to rounding; 1e-9
// of the displacement leaves room for the tolerance 1e-12 of the iteration.
TEST_P(ColumnScene, TopSinksByTheClosedForm)
{
  const double expected = p * (H1 / E1 + H2 / E2) + GetParam().closure;
  for (const unsigned int levels : {1u, 7u})
    {
      const std::string file = column_file(GetParam(), levels);
      const SceneRun run     = run_scene(file);
      ASSERT_EQ(run.exit_code, 0);
      EXPECT_LE(run.certificate(), 1e-9);
      SceneModel model(file);
      for (const double t : {1., 3.})
        {
          const auto u           = model.displacement(model.bars(run, t, false), t);
          const auto &space      = model.system->discretization();
          const std::size_t node = model.node_at({{1., H1 + H2}});
          EXPECT_NEAR(u[space.dof(node, 1)], -expected, 1e-9 * expected) << levels << " " << t;
          for (const double N : run.values("pressure", t))
            EXPECT_NEAR(N, p, 1e-9 * p);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Laws, ColumnScene, testing::ValuesIn(laws), [](const auto &law) {
  return law.param.name;
});

namespace
{
  class FloatingBlock : public testing::TestWithParam<LawCase>
  {
  };
} // namespace

// The block of problem S0, which only its joint holds, from the virgin state: it stands, opens and
// slides on every law; the joint carries the weight 0.024·4·12, and the judge finds nothing.
TEST_P(FloatingBlock, StandsOnEveryLaw)
{
  std::vector<std::string> overrides;
  for (const char *entry : {"Normal compliance", "Thickness"})
    if (std::string(GetParam().layer).find(entry) == std::string::npos)
      overrides.push_back(fmt::format("Joints/base/{}=", entry));
  std::stringstream lines(GetParam().layer);
  for (std::string line; std::getline(lines, line);)
    {
      const std::size_t at = line.find(" = ");
      overrides.push_back("Joints/base/" + line.substr(4, at - 4) + "=" + line.substr(at + 3));
    }
  const SceneRun run = run_scene("paper_2_linear.prm", overrides);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_LE(run.certificate(), 1e-9);
  for (const double t : {1., 2.})
    EXPECT_NEAR(run.resultant("N", t), -1.152, 1e-9) << t;
  RecordProperty("iterations", run.summary.at("iterations").dump());
}

INSTANTIATE_TEST_SUITE_P(Laws, FloatingBlock, testing::ValuesIn(laws), [](const auto &law) {
  return law.param.name;
});

// A run beyond the last point of a table says so, once per joint and direction, in the log and in
// the summary; one that stays within it does not.
TEST(TableScene, WarnsBeyondTheTable)
{
  const LawCase beyond{"", "set Normal law = tabular\nset Normal table = 0: 0; 1e-3: 0.3", 0.};
  const SceneRun run = run_scene(column_file(beyond, 1));
  ASSERT_EQ(run.summary.at("warnings").size(), 1u);
  const std::string text = run.summary.at("warnings").at(0);
  for (const char *part : {"joint 'base'", "normal table ends at 0.3", "reaches 0.4", "t = 1"})
    EXPECT_NE(text.find(part), std::string::npos) << text;
  const LawCase within{"", "set Normal law = tabular\nset Normal table = 0: 0; 1e-3: 0.41", 0.};
  EXPECT_EQ(run_scene(column_file(within, 1)).summary.at("warnings").size(), 0u);
}

// --plot-law tabulates the laws of all joints and computes nothing else. The values are those of
// law (9) with q = (w/ζ0)^(1/3) (verification V11), and of a linear shear law; units are told.
TEST(PlotLaw, WritesTables)
{
  namespace fs                = std::filesystem;
  const std::string directory = temporary_directory();
  const ProgramRun run        = run_program(
    {parameter_path("paper_3_cubic_root.prm"), "--plot-law", "--output-dir", directory});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  std::size_t n_files = 0;
  for ([[maybe_unused]] const auto &entry : fs::directory_iterator(directory))
    ++n_files;
  EXPECT_EQ(n_files, 1u);
  EXPECT_NE(run.out.find("fuga report"), std::string::npos) << run.out;
  const std::string text = file_text(directory + "/law_base.csv");
  for (const char *column : {",deformation[m],", ",stress[MPa],", ",limit[m]\r\n"})
    EXPECT_NE(text.find(column), std::string::npos) << column;
  const CsvTable table = parse_csv(text);
  // 400 steps up to 0.9 ζ0 = 1.8 mm.
  const double zeta = 2e-3, rho = 1.25e-4;
  ASSERT_EQ(table.text(200, "direction"), "normal");
  const double w = table.number(200, "deformation"), q = std::cbrt(w / zeta);
  EXPECT_NEAR(w, 0.45 * zeta, 1e-15);
  EXPECT_NEAR(table.number(200, "stress"), zeta / rho * q * q * q / (1. - q), 1e-10);
  EXPECT_NEAR(table.number(0, "tangent"), 1. / rho, 1e-9);
  EXPECT_NEAR(table.number(400, "limit"), zeta, 1e-15);
  ASSERT_EQ(table.text(401, "direction"), "shear");
  EXPECT_EQ(table.number(401, "limit"), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(table.number(801, "stress"), table.number(801, "deformation") / rho, 1e-10);
}

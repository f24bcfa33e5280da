// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "parameter_wrong_input.h"

#include <fuga/input/layer_law.h>
#include <fuga/input/read/read_parameters.h>

namespace fuga
{
  namespace
  {
    using testing_files::Changes;
    using testing_files::example_prm;
    using testing_files::expect_explained;
    using testing_files::expect_parts;
    using testing_files::message_of;
    using testing_files::name_of;
    using testing_files::replaced;
    using testing_files::write_file;
    using testing_files::WrongInput;

    /** The layer of joint 'base' in the example; its first line is line 27 of the file. */
    const std::string layer = "    set Normal law = cubic root\n"
                              "    set Normal compliance = 1.25e-4\n"
                              "    set Shear stiffness = 8000\n"
                              "    set Thickness = 0.002\n";

    Changes
    with_layer(const std::string &lines)
    {
      return {{layer, lines}};
    }

    JointParameters
    read_layer_of(const std::string &lines, const std::vector<std::string> &overrides = {})
    {
      return read_parameters(write_file("layer.prm", replaced(example_prm(), with_layer(lines))),
                             overrides)
        .joints[0];
    }

    const std::string shear = "set Shear stiffness = 8000\n";

    class WrongLayers : public testing::TestWithParam<WrongInput>
    {
    };

    TEST_P(WrongLayers, AreExplained)
    {
      expect_explained(GetParam());
    }

    const WrongInput layers[] = {
      {"UnknownLaw",
       with_layer("set Normal law = elastic\n" + shear),
       {},
       {".prm:27", "Normal law = 'elastic'", "hyperbolic", "tabular"}},
      {"HyperbolicShear",
       with_layer("set Normal compliance = 1\nset Shear law = hyperbolic\n"),
       {},
       {".prm:28", "Shear law = 'hyperbolic'", "power"}},
      {"HyperbolicWithoutLimit",
       with_layer("set Normal law = hyperbolic\nset Normal compliance = 1e-4\n" + shear),
       {},
       {".prm:27", "'Normal closure limit' is missing"}},
      {"HyperbolicWithoutCompliance",
       with_layer("set Normal law = hyperbolic\nset Normal closure limit = 1e-3\n" + shear),
       {},
       {".prm:23", "'Normal compliance' or 'Normal stiffness' is missing"}},
      {"HyperbolicRigid",
       with_layer("set Normal law = hyperbolic\nset Normal compliance = 0\n"
                  "set Normal closure limit = 1e-3\n" +
                  shear),
       {},
       {".prm:28", "Normal compliance = '0'", "compliance > 0"}},
      {"ExponentialWithoutStress",
       with_layer("set Normal law = exponential\nset Normal reference closure = 1e-3\n" + shear),
       {},
       {".prm:27", "'Normal reference stress' is missing"}},
      {"ExponentialWithCompliance",
       with_layer("set Normal law = exponential\nset Normal compliance = 1e-3\n" + shear),
       {},
       {".prm:28",
        "Normal compliance = '1e-3'",
        "'Normal law = exponential' (",
        ".prm:27",
        "linear, cubic root, cubic root tangent, hyperbolic"}},
      {"CubicRootTangentWithoutThickness",
       with_layer("set Normal law = cubic root tangent\nset Normal compliance = 1e-4\n" + shear),
       {},
       {".prm:27", "'Thickness' is missing", "cubic root tangent law"}},
      {"CubicRootTangentRigid",
       with_layer("set Normal law = cubic root tangent\nset Normal compliance = 0\n"
                  "set Thickness = 1e-3\n" +
                  shear),
       {},
       {".prm:28", "Normal compliance = '0'", "compliance > 0"}},
      {"PowerWithoutExponent",
       with_layer("set Normal law = power\nset Normal reference closure = 1e-3\n"
                  "set Normal reference stress = 1\n" +
                  shear),
       {},
       {".prm:27", "'Normal exponent' is missing"}},
      {"PowerExponentTooLarge",
       with_layer("set Normal law = power\nset Normal reference closure = 1e-3\n"
                  "set Normal reference stress = 1\nset Normal exponent = 7\n" +
                  shear),
       {},
       {".prm:30", "Normal exponent = '7'", "from 0.2 to 5"}},
      {"LinearWithTable",
       with_layer("set Normal compliance = 1e-4\nset Normal table = 0: 0; 1: 1\n" + shear),
       {},
       {".prm:28", "Normal table", "'Normal law = linear' (the default)", "law tabular"}},
      {"ShearPowerWithNormalEntries",
       with_layer("set Normal compliance = 1e-4\nset Shear law = power\n"
                  "set Normal exponent = 2\n"),
       {},
       {".prm:29", "Normal exponent = '2'", "'Normal law = linear'"}},
      {"TabularWithoutTable",
       with_layer("set Normal law = tabular\n" + shear),
       {},
       {".prm:27", "'Normal table' is missing"}},
      {"TableWithOnePoint",
       with_layer("set Normal law = tabular\nset Normal table = 0: 0\n" + shear),
       {},
       {".prm:28", "second point"}},
      {"TableNotFromZero",
       with_layer("set Normal law = tabular\nset Normal table = 1: 1; 2: 2\n" + shear),
       {},
       {".prm:28", "Begin with 0: 0"}},
      {"TableFalls",
       with_layer("set Normal law = tabular\nset Normal table = 0: 0; 1e-3: 2; 2e-3: 1\n" + shear),
       {},
       {".prm:28", "at w = 0.002", "'2e-3: 1'", "0.001: 2", "must grow"}},
      {"TableWithUnit",
       with_layer("set Normal law = tabular\nset Normal table = 0: 0; 1 mm: 2\n" + shear),
       {},
       {".prm:28", "'1 mm' is not a number", "without units"}},
      {"TableWithoutPairs",
       with_layer("set Normal law = tabular\nset Normal table = 0 0; 1 2\n" + shear),
       {},
       {".prm:28", "'0 0' is not a point"}},
      {"UnknownInterpolation",
       with_layer("set Normal law = tabular\nset Normal table = 0: 0; 1: 2\n"
                  "set Normal interpolation = cubic\n" +
                  shear),
       {},
       {".prm:29", "'cubic'", "monotone spline", "piecewise linear"}},
      {"ExpressionWithoutTangent",
       with_layer("set Normal law = expression\nset Normal stress expression = w\n" + shear),
       {},
       {".prm:27", "'Normal tangent expression' is missing"}},
      {"ExpressionOfPlace",
       with_layer("set Normal law = expression\nset Normal stress expression = w*x\n"
                  "set Normal tangent expression = x\n" +
                  shear),
       {},
       {".prm:28", "Normal stress expression", "Known here: w"}},
      {"InfiniteTangent",
       with_layer("set Normal law = expression\nset Normal stress expression = sqrt(w)\n"
                  "set Normal tangent expression = 0.5/sqrt(w)\n" +
                  shear),
       {},
       {".prm:29", "Normal tangent expression", "infinite"}},
      {"WrongDerivative",
       with_layer("set Normal law = expression\nset Normal stress expression = 1e4*w + 1e7*w^2\n"
                  "set Normal tangent expression = 1e4 + 1e7*w\n" +
                  shear),
       {},
       {".prm:28", "at w = ", "the tangent is", "the stress grows by", "--plot-law"}},
      {"StressAtZero",
       with_layer("set Normal law = expression\nset Normal stress expression = 1 + 1e4*w\n"
                  "set Normal tangent expression = 1e4\n" +
                  shear),
       {},
       {".prm:28", "at w = 0", "without deformation is 1"}},
      {"FallingExpression",
       with_layer("set Normal law = expression\nset Normal stress expression = sin(w)\n"
                  "set Normal tangent expression = cos(w)\n" +
                  shear),
       {},
       {".prm:28", "tangent is -", "must be positive"}},
      {"BoundedBeforeLimit",
       with_layer("set Normal law = expression\nset Normal stress expression = 1e3*w\n"
                  "set Normal tangent expression = 1e3\nset Normal closure limit = 1e-3\n" +
                  shear),
       {},
       {".prm:28", "without bound"}},
      {"SweepNeedsEntries",
       {},
       {"Sweep/Normal law=linear, hyperbolic", "Sweep/Joints=base"},
       {"Joints/base/Normal law = 'hyperbolic'", "'Normal closure limit' is missing"}},
      {"SweepOfCompliance",
       with_layer("set Normal law = exponential\nset Normal reference closure = 1e-3\n"
                  "set Normal reference stress = 1\n" +
                  shear),
       {"Sweep/Normal compliance=1e-4, 1e-3", "Sweep/Joints=base"},
       {"Joints/base/Normal compliance = '1e-4'", "does not use this entry"}},
    };
    INSTANTIATE_TEST_SUITE_P(Layers, WrongLayers, testing::ValuesIn(layers), name_of);

    /** A file of test values must be read as it stands, law by law; the stresses by hand. */
    double
    normal_stress(const std::string &lines, const double w)
    {
      const JointParameters joint = read_layer_of(lines + shear);
      return make_layer_law(joint, LayerDirection::normal, {})->stress(w);
    }

    TEST(Layers, AreRead)
    {
      EXPECT_NEAR(normal_stress("set Normal law = hyperbolic\nset Normal stiffness = 8000\n"
                                "set Normal closure limit = 2e-3\n",
                                1e-3),
                  16.,
                  1e-12);
      EXPECT_NEAR(
        normal_stress("set Normal law = exponential\nset Normal reference closure = 1e-3\n"
                      "set Normal reference stress = 4\n",
                      5e-4),
        0.4,
        1e-13);
      EXPECT_NEAR(normal_stress("set Normal law = power\nset Normal reference closure = 1e-3\n"
                                "set Normal reference stress = 4\nset Normal exponent = 1.5\n",
                                4e-3),
                  32.,
                  1e-12);
      EXPECT_NEAR(
        normal_stress("set Normal law = tabular\nset Normal table = 0: 0; 1e-3: 2; 3e-3: 4\n"
                      "set Normal interpolation = piecewise linear\n",
                      2e-3),
        3.,
        1e-13);
      EXPECT_NEAR(normal_stress(
                    "set Normal law = tabular\nset Normal table = 0: 0; 1e-3: 2; 3e-3: 4\n", 1e-3),
                  2.,
                  1e-13);
      EXPECT_NEAR(
        normal_stress("set Normal law = expression\nset Normal stress expression = 2e3*w + w\n"
                      "set Normal tangent expression = 2e3 + 1\n",
                      2e-3),
        4.002,
        1e-12);
    }

    TEST(Layers, ShearLawsAreRead)
    {
      const JointParameters joint =
        read_layer_of("set Normal compliance = 1e-4\nset Shear law = power\n"
                      "set Shear reference jump = 1e-3\nset Shear reference stress = 0.5\n"
                      "set Shear exponent = 0.5\n");
      EXPECT_NEAR(make_layer_law(joint, LayerDirection::shear, {})->stress(4e-3), 1., 1e-13);
      EXPECT_EQ(joint.shear_compliance, 0.);
    }

    // One joint section holds what all laws of a sweep need.
    TEST(Layers, SweepOverLaws)
    {
      const std::string lines = "set Normal compliance = 1e-4\nset Normal closure limit = 1e-3\n"
                                "set Normal table = 0: 0; 1e-3: 2\nset Thickness = 2e-3\n" +
                                shear;
      const std::string file = write_file("laws.prm", replaced(example_prm(), with_layer(lines)));
      const Parameters p     = read_parameters(
        file,
        {"Sweep/Normal law=linear, cubic root, hyperbolic, tabular, rigid", "Sweep/Joints=base"});
      ASSERT_EQ(p.variants.size(), 5u);
      EXPECT_EQ(p.variants[2].joints[0].normal_law, LayerLaw::hyperbolic);
      EXPECT_EQ(p.variants[3].joints[0].normal_law, LayerLaw::tabular);
      EXPECT_EQ(p.variants[4].joints[0].normal_compliance, 0.);
      // The same entries without the sweep are refused.
      expect_parts(message_of(file), {"Normal closure limit", "'Normal law = linear'"});
    }

    // What is not given does not appear in the echo, which is a parameter file itself.
    TEST(Layers, EchoCanBeRead)
    {
      const Parameters p     = read_parameters(write_file("echo.prm", example_prm()));
      const std::string text = echo_json(p);
      EXPECT_EQ(text.find("interpolation"), std::string::npos);
      EXPECT_EQ(echo_json(read_parameters(write_file("echo.json", text))), text);
    }
  } // namespace
} // namespace fuga

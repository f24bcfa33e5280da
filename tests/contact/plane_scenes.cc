// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "contact/plane_scenes.h"

#include "contact/cone_toy.h"

#include <fuga/laws/cubic_root_law.h>
#include <fuga/laws/exponential_law.h>
#include <fuga/laws/hyperbolic_law.h>
#include <fuga/laws/power_law.h>
#include <fuga/laws/tabular_law.h>

namespace fuga::tests
{
  namespace
  {
    constexpr std::size_t n = 6;

    using Change = std::function<void(PlaneScene &)>;

    Change
    friction(const std::function<void(FrictionLaw &)> &change)
    {
      return [change](PlaneScene &scene) {
        for (ContactElement &element : scene.elements)
          change(element.friction);
      };
    }

    template <typename Law, typename... Data>
    Change
    closure(const Data... data)
    {
      return [=](PlaneScene &scene) { scene.normal = std::make_unique<Law>(data...); };
    }

    template <typename Law, typename... Data>
    Change
    layer(const Data... data)
    {
      return [=](PlaneScene &scene) {
        scene.normal = std::make_unique<Law>(data...);
        scene.shear  = std::make_unique<Law>(data...);
      };
    }

    Change
    coupling(const ShearCoupling::Kind kind, const double exponent)
    {
      return [=](PlaneScene &scene) {
        scene.coupling = std::make_unique<ShearCoupling>(kind, *scene.normal, 0.2, 2., exponent);
      };
    }

    Change
    all(const std::vector<Change> &changes)
    {
      return [changes](PlaneScene &scene) {
        for (const Change &change : changes)
          change(scene);
      };
    }

    const Change gaps = [](PlaneScene &scene) {
      for (std::size_t k = 0; k < n; k += 3)
        scene.elements[k].initial_gap = 0.05;
    };

    const Change rigid = [](PlaneScene &scene) {
      scene.normal = make_rigid_law();
      scene.shear  = make_rigid_law();
    };

    const Change cohesion = friction([](FrictionLaw &law) { law.cohesion = 0.3; });
    const Change tension  = friction([](FrictionLaw &law) { law.tensile_strength = 0.2; });
    const Change bond     = all({cohesion, tension});
    const Change brittle =
      friction([](FrictionLaw &law) { law.bond_loss = FrictionLaw::BondLoss::slip; });
    const Change residual   = friction([](FrictionLaw &law) { law.friction_loss = 0.2; });
    const Change dilatancy  = friction([](FrictionLaw &law) { law.dilatancy = 0.1; });
    const Change rise_limit = friction([](FrictionLaw &law) { law.dilation_limit = 0.02; });
    const Change law_nine   = layer<CubicRootLaw>(0.3, 2.);

    /** After the loads, which then stay, the strength falls. */
    const Change reduction = [](PlaneScene &scene) {
      for (ContactElement &element : scene.elements)
        element.friction.reduced = true;
      std::vector<Vector> factors;
      for (const double t : {0., 1., 2., 3., 3.})
        factors.push_back(scene.history.factors(t));
      scene.history = LoadHistory({0., 1., 2., 3., 4.}, factors, {1., 1., 1., 1., 0.7});
      scene.levels  = {1., 2.2, 3., 3.5, 4.};
    };

    const std::vector<TabularLaw::Point> table = {
      {0., 0.}, {0.1, 0.2}, {0.3, 0.9}, {0.5, 2.}, {0.7, 4.}};
  } // namespace

  const std::vector<SceneCase> &
  scene_cases()
  {
    using Coupling                            = ShearCoupling::Kind;
    static const std::vector<SceneCase> cases = {
      {"coulomb", [](PlaneScene &) {}},
      {"rigid", rigid},
      {"gaps", gaps},
      {"cohesion", cohesion},
      {"bond", bond},
      {"brittle_bond", all({bond, brittle})},
      {"residual_friction", residual},
      {"brittle_bond_and_residual_friction", all({bond, brittle, residual})},
      {"dilatancy", dilatancy},
      {"limited_dilatancy", all({dilatancy, rise_limit})},
      {"strength_reduction", reduction},
      {"bond_under_strength_reduction", all({bond, reduction})},
      {"law_nine", law_nine},
      {"law_nine_of_closure", closure<CubicRootLaw>(0.3, 2.)},
      {"tangent_law_nine", layer<CubicRootTangentLaw>(0.3, 2.)},
      {"hyperbolic_closure", closure<HyperbolicLaw>(0.3, 2.)},
      {"exponential_closure", closure<ExponentialLaw>(0.5, 0.6)},
      {"power", layer<PowerLaw>(0.5, 1., 1.5)},
      {"table_of_lines", layer<TabularLaw>(table, TableInterpolation::piecewise_linear)},
      {"table_with_spline", layer<TabularLaw>(table, TableInterpolation::monotone_spline)},
      {"shear_coupled_to_closure", coupling(Coupling::closure, 1.)},
      {"shear_coupled_to_pressure", coupling(Coupling::pressure, 1.)},
      {"bond_on_coupled_layer", all({coupling(Coupling::closure, 0.5), bond})},
      {"all_on_law_nine_of_closure",
       all({closure<CubicRootLaw>(0.3, 2.), bond, brittle, residual, dilatancy, rise_limit, gaps})},
      {"all_on_law_nine", all({law_nine, bond, brittle, residual, dilatancy, rise_limit, gaps})},
      {"all_on_rigid_layer", all({rigid, bond, brittle, residual, dilatancy, rise_limit, gaps})},
      {"all_on_coupled_layer",
       all({coupling(Coupling::pressure, 0.5), bond, brittle, residual, dilatancy, gaps})}};
    return cases;
  }

  PlaneScene
  make_scene(const SceneCase &scene_case, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    PlaneScene scene{{},
                     make_linear_law(0.1),
                     make_linear_law(0.2),
                     nullptr,
                     std::vector<ContactElement>(n),
                     roundabout(),
                     {0.5, 1., 1.5, 2., 3., 3.7, 4., 5.},
                     {}};
    scene.system.S      = random_stiffness(2 * n, generator);
    const DenseMatrix F = random_loads(n, generator);
    scene.system.F      = DenseMatrix(2 * n, F.cols());
    for (std::size_t k = 0; k < n; ++k)
      {
        for (std::size_t i = 0; i < 2; ++i)
          for (Eigen::Index j = 0; j < F.cols(); ++j)
            scene.system.F(2 * k + i, j) = F(3 * k + i, j);
        ContactElement &element      = scene.elements[k];
        element.normal_bar           = static_cast<unsigned int>(2 * k);
        element.tangential_bar       = static_cast<unsigned int>(2 * k + 1);
        element.number               = static_cast<unsigned int>(k);
        element.friction.coefficient = 0.5;
      }
    scene_case.change(scene);
    for (ContactElement &element : scene.elements)
      {
        element.normal_law = scene.normal.get();
        element.shear_law  = scene.shear.get();
        element.coupling   = scene.coupling.get();
      }
    return scene;
  }

  PlaneScene
  oblique_scene(const SceneCase &scene_case, const unsigned int seed)
  {
    std::mt19937 generator(seed);
    PlaneScene scene = make_scene(scene_case, seed);
    scene.system     = random_bodies(3, generator);
    scene.elements.resize(3);
    for (std::size_t k = 0; k < scene.elements.size(); ++k)
      {
        scene.elements[k].normal_bar            = static_cast<unsigned int>(3 * k);
        scene.elements[k].tangential_bar        = static_cast<unsigned int>(3 * k + 1);
        scene.elements[k].second_tangential_bar = static_cast<unsigned int>(3 * k + 2);
      }
    return scene;
  }
} // namespace fuga::tests

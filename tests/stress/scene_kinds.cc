// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/scene_kinds.h"

#include "stress/families.h"
#include "stress/families_in_space.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace fuga::stress
{
  namespace
  {
    // A joint so soft that a body sinks by far more than its own size under a load that it hardly
    // feels is no structure; and a slip of 1e9 times the deformation of the bodies leaves no digits
    // for the latter on bars that are stiff against slip. So E ρ / L, with the stiffest body and
    // the softest bar, is limited to 1e7, and to 1e9 without stiff bars. Moduli and forces are
    // reduced together.
    void
    limit_ratio_to_layer(SceneData &model)
    {
      double stiffest = 0., softest_bar = 0., stiffest_bar = 1e300;
      for (const SceneData::Body &body : model.bodies)
        stiffest = std::max(stiffest, body.young_modulus);
      for (const SceneData::Joint &joint : model.joints)
        for (const auto &[law, rho] :
             {std::make_pair(joint.layer.normal_law, joint.layer.normal_compliance),
              std::make_pair(joint.layer.shear_law, joint.layer.shear_compliance)})
          {
            softest_bar  = std::max(softest_bar, law == "rigid" ? 0. : rho);
            stiffest_bar = std::min(stiffest_bar, law == "rigid" ? 0. : rho);
          }
      const double limit  = stiffest_bar > 1e-3 * softest_bar ? 1e9 : 1e7;
      const double factor = limit * model.width() / (stiffest * softest_bar);
      if (!(factor < 1.))
        return;
      for (SceneData::Body &body : model.bodies)
        body.young_modulus *= factor;
      for (SceneData::Joint &joint : model.joints)
        {
          joint.layer.cohesion *= factor;
          joint.layer.thickness *= factor;
        }
      for (Vector &stage : model.stages)
        for (std::size_t l = 0; l < stage.size(); ++l)
          if (model.loads[l].type != "displacement")
            stage[l] *= factor;
    }

    std::set<std::string>
    features_of(const SceneData &model)
    {
      static const std::set<std::string> strengths = {"Residual friction coefficient",
                                                      "Tensile strength",
                                                      "Bond lost by",
                                                      "Envelope exponent",
                                                      "Dilatancy angle",
                                                      "Dilation limit",
                                                      "Shear stiffness grows with"};
      std::set<std::string> result                 = {"cells: " + model.cells(),
                                                      fmt::format("cells: degree {}", model.degree)};
      for (const SceneData::Course &course : model.courses)
        if (course.duration > 0.)
          result.insert(course.share == "1" ? "motion: load at once" : "motion: load over time");
      for (const auto &[entry, unused] : model.dynamics)
        if (entry == "Spectral radius" || entry == "Damping ratio")
          result.insert("motion: " + entry);
      for (const SceneData::Load &load : model.loads)
        result.insert("load: " + load.type);
      for (const auto &[unused, components] : model.supports)
        result.insert(components == "all" ? "support: all" : "support: single components");
      for (const SceneData::Joint &joint : model.joints)
        {
          const Layer &layer = joint.layer;
          result.insert("normal law: " + layer.normal_law);
          result.insert("shear law: " + layer.shear_law);
          if (joint.line.empty())
            result.insert("joint: against an obstacle");
          if (layer.friction == 0.)
            result.insert("joint: without friction");
          if (layer.cohesion > 0.)
            result.insert("strength: cohesion");
          if (!layer.initial_gap.empty())
            result.insert("joint: initial gap");
          for (const auto &[entry, unused] : layer.more)
            if (strengths.count(entry) > 0)
              result.insert("strength: " + entry);
        }
      return result;
    }
  } // namespace

  const std::vector<SceneKind> &
  scene_kinds()
  {
    constexpr std::uint64_t seeds_of_motions  = 360; // a thousand of all kinds that move
    static const std::vector<SceneKind> kinds = {
      {"single", "one to five contact elements", families::single},
      {"stack", "anything of a block on a foundation", families::stack},
      {"tower", "floating bodies on floating bodies", families::tower},
      {"cross", "four joints that cross", families::cross},
      {"masonry", "a wall of bricks: joints that meet in T", families::masonry},
      {"arch", "voussoirs between abutments that may give way", families::arch},
      {"wedge", "a block between inclined rigid planes", families::wedge},
      {"virgin", "proportional load from the apex: all events at t = 0+", families::virgin},
      {"reversal", "simultaneous re-stick at every load reversal", families::reversal},
      {"symmetric", "exact symmetry: simultaneous events", families::symmetric},
      {"graded", "elements of size ratio 1e6 along one joint", families::graded},
      {"slender", "element aspect to 1e4", families::slender},
      {"offset", "coordinates up to 1e6 m from the origin", families::offset},
      {"stiff", "compliances 0 and 1e-12 to 1e-7, mixed within a joint", families::stiff},
      {"soft", "joints softer than the bodies by up to 1e10, near collapse", families::soft},
      {"contrast", "moduli of ratio 1e-6 to 1e6, Poisson's ratio 0.4999", families::contrast},
      {"rigid bodies", "rigid bodies on rigid joints", families::rigid_bodies},
      {"gap", "initial gaps that close, and falls through them", families::gap},
      {"settlement", "prescribed displacements", families::settlement},
      {"stages", "60 to 200 small stages", families::stages},
      {"many elements", "100 to 300 contact elements", families::many_elements},
      {"high friction", "f from 1 to 3 on stiff joints, reversals", families::high_friction},
      {"limit", "pushed beyond the limit load", families::limit},
      {"cohesion", "bonds that break", families::cohesion},
      {"cubic root", "law (9), to the closure limit", families::cubic_root},
      {"cubic root crossing",
       "law (9) and linear joints that cross or meet",
       families::cubic_root_crossing},
      {"residual", "friction that the first slip costs", families::residual},
      {"bonds", "tensile strength, brittle bonds", families::bonds},
      {"dilatancy", "lips that rise as they slide, to a limit or not", families::dilatancy},
      {"curved laws",
       "power, tabular, expression, hyperbolic, exponential, both readings of law (9)",
       families::curved_laws},
      {"coupled shear",
       "shear stiffness that grows with closure or pressure",
       families::coupled_shear},
      {"envelopes", "strength along a curve over the pressure", families::envelopes},
      {"envelopes with laws",
       "such strengths, also with bonds and residual friction, on any layer",
       families::envelopes_with_laws},
      {"lift-off", "all contact lost and found again, on any layer", families::lift_off},
      {"all laws", "any strength on any layer", families::all_laws},
      {"all laws crossing", "the same on joints that cross or meet", families::all_laws_crossing},
      {"polygons", "random polygons cut by one to five lines, triangles", families::polygons},
      {"polygons with laws",
       "the same with any strength on any layer",
       families::polygons_with_laws},
      {"motion",
       "loads at once or shaking, bodies that arrive",
       families::motion,
       seeds_of_motions},
      {"motion with laws",
       "the same with any strength on any layer",
       families::motion_with_laws,
       seeds_of_motions},
      {"extruded",
       "plane scenes made spatial: one path with lines of friction, one with cones",
       families::extruded},
      {"extruded reversal", "the same, loads to and fro", families::extruded_reversal},
      {"blocks in space",
       "blocks on each other, pushed in turning directions",
       families::blocks_in_space},
      {"pair in space",
       "two blocks side by side on a foundation: joints that meet in T",
       families::pair_in_space},
      {"wedge in space",
       "a block in a valley of two rigid planes, of hexahedra or tetrahedra",
       families::wedge_in_space},
      {"polyhedra", "random polyhedra cut by one to three planes, tetrahedra", families::polyhedra},
      {"motion in space",
       "blocks and wedges under loads at once or shaking",
       families::motion_in_space,
       seeds_of_motions},
      {"extruded with laws",
       "plane scenes made spatial with any strength on any layer",
       families::extruded_with_laws},
      {"blocks with laws",
       "blocks, pairs and wedges in space with any strength on any layer",
       families::blocks_with_laws},
      {"envelopes in space",
       "blocks, pairs and wedges in space with strengths along curves",
       families::envelopes_in_space},
      {"polyhedra with laws",
       "random polyhedra with any strength on any layer",
       families::polyhedra_with_laws},
      {"motion in space with laws",
       "motions in space with any strength on any layer",
       families::motion_in_space_with_laws,
       seeds_of_motions},
    };
    return kinds;
  }

  std::unique_ptr<SceneData>
  draw_scene(const std::string &kind, const std::uint64_t seed)
  {
    for (const SceneKind &candidate : scene_kinds())
      if (kind == candidate.name)
        {
          Random random(kind, seed);
          auto scene = candidate.draw(random);
          if (scene->dimension() == 2)
            limit_ratio_to_layer(*scene);
          return scene;
        }
    throw std::invalid_argument("unknown kind of scene: " + kind);
  }

  SceneAxes
  axes_of(const SceneData &model)
  {
    SceneAxes axes;
    axes.rho_min   = std::numeric_limits<double>::infinity();
    double softest = std::numeric_limits<double>::infinity(), stiffest = 0.;
    for (const SceneData::Body &body : model.bodies)
      {
        softest            = std::min(softest, body.young_modulus);
        stiffest           = std::max(stiffest, body.young_modulus);
        axes.poisson_ratio = std::max(axes.poisson_ratio, body.poisson_ratio);
      }
    axes.stiffness_ratio = stiffest / softest;
    for (const SceneData::Joint &joint : model.joints)
      {
        const Layer &layer = joint.layer;
        for (const auto &[law, rho] : {std::make_pair(layer.normal_law, layer.normal_compliance),
                                       std::make_pair(layer.shear_law, layer.shear_compliance)})
          {
            const double size = law == "rigid" ? 0. : rho;
            axes.rho_min      = std::min(axes.rho_min, size);
            axes.rho_max      = std::max(axes.rho_max, size);
            if (law != "rigid" && law != "linear" && axes.law.find(law) == axes.law.npos)
              axes.law = axes.law == "linear" ? law : axes.law + ", " + law;
          }
        axes.friction = std::max(axes.friction, layer.friction);
        axes.cohesion = std::max(axes.cohesion, layer.cohesion);
      }
    axes.aspect     = model.largest_aspect();
    axes.size_ratio = model.size_ratio();
    axes.offset     = model.offset();
    axes.features   = features_of(model);
    axes.n_bodies   = model.bodies.size();
    axes.n_joints   = model.joints.size();
    axes.n_stages   = model.stages.size();
    return axes;
  }
} // namespace fuga::stress

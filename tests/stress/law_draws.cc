// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/law_draws.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga::stress
{
  namespace
  {
    /** Takes the compliance of a direction for the axes of the report; entries say the rest. */
    struct Direction
    {
      std::string word, deformation;
      std::string &law;
      double &compliance;
    };

    Direction
    direction_of(Layer &layer, const bool normal)
    {
      if (normal)
        return {"Normal ", "reference closure", layer.normal_law, layer.normal_compliance};
      return {"Shear ", "reference jump", layer.shear_law, layer.shear_compliance};
    }

    void
    set(Layer &layer, const std::string &entry, const double value)
    {
      layer.more.emplace_back(entry, fmt::format("{}", value));
    }

    void
    make_power(Random &random, Layer &layer, const bool normal, const Scales &scales)
    {
      const Direction at = direction_of(layer, normal);
      at.law             = "power";
      at.compliance      = scales.compliance * random.power_of_ten(-3., 3.);
      const double s     = scales.pressure * random.power_of_ten(-1., 1.);
      set(layer, at.word + at.deformation, s * at.compliance);
      set(layer, at.word + "reference stress", s);
      set(layer, at.word + "exponent", random.uniform(0.3, 4.));
    }

    void
    make_table(Random &random, Layer &layer, const bool normal, const Scales &scales)
    {
      const Direction at = direction_of(layer, normal);
      at.law             = "tabular";
      at.compliance      = scales.compliance * random.power_of_ten(-3., 3.);
      const double s     = scales.pressure * random.power_of_ten(-1., 1.);
      std::string table  = "0: 0";
      double w = 0., stress = 0.;
      const unsigned int n_points = random.integer(1, 5);
      for (unsigned int i = 0; i < n_points; ++i)
        {
          w += s * at.compliance * random.uniform(0.1, 1.);
          stress += s * random.power_of_ten(-1., 1.);
          table += fmt::format("; {}: {}", w, stress);
        }
      layer.more.emplace_back(at.word + "table", table);
      if (random.chance(0.5))
        layer.more.emplace_back(at.word + "interpolation", "piecewise linear");
    }

    void
    make_expression(Random &random, Layer &layer, const bool normal, const Scales &scales)
    {
      const Direction at = direction_of(layer, normal);
      at.law             = "expression";
      at.compliance      = scales.compliance * random.power_of_ten(-3., 3.);
      const double s = scales.pressure * random.power_of_ten(-1., 1.), w = s * at.compliance;
      const auto expressions = [&](const std::string &stress, const std::string &tangent) {
        layer.more.emplace_back(at.word + "stress expression", stress);
        layer.more.emplace_back(at.word + "tangent expression", tangent);
      };
      if (random.chance(0.4))
        expressions(fmt::format("{}*sinh(w/{})", s, w), fmt::format("{}*cosh(w/{})", s / w, w));
      else if (random.chance(0.5) || !normal)
        expressions(fmt::format("{}*(sqrt(1 + w/{}) - 1)", s, w),
                    fmt::format("{}/sqrt(1 + w/{})", 0.5 * s / w, w));
      else
        {
          const double limit = w * random.power_of_ten(0., 2.);
          expressions(fmt::format("{}*w/(1 - w/{})", 1. / at.compliance, limit),
                      fmt::format("{}/(1 - w/{})^2", 1. / at.compliance, limit));
          set(layer, at.word + "closure limit", limit);
        }
    }

    /** Laws with entries of their own for the compliance: they harden towards a limit. */
    void
    make_closing(Random &random, Layer &layer, const Scales &scales)
    {
      layer.normal_compliance = scales.compliance * random.power_of_ten(-3., 3.);
      const double w = layer.normal_compliance * scales.pressure * random.power_of_ten(-1., 2.);
      switch (random.integer(0, 3))
        {
          case 0:
            layer.normal_law = "hyperbolic";
            set(layer, "Normal closure limit", w);
            break;
          case 1:
            layer.normal_law = "exponential";
            set(layer, "Normal reference closure", w);
            set(layer, "Normal reference stress", scales.pressure * random.power_of_ten(-1., 1.));
            break;
          case 2:
            layer.normal_law = "cubic root";
            layer.thickness  = w;
            break;
          default:
            // Its stress grows like a logarithm: the program refuses a limit that the bodies'
            // strength could pass.
            layer.normal_law = "cubic root tangent";
            layer.thickness  = std::max(w, 5e-4 * scales.softest * layer.normal_compliance);
        }
    }
  } // namespace

  Scales
  scales_of(const SceneData &model, const double pressure)
  {
    double stiffest = 0.;
    Scales scales;
    scales.softest = std::numeric_limits<double>::infinity();
    for (const SceneData::Body &body : model.bodies)
      {
        stiffest       = std::max(stiffest, body.young_modulus);
        scales.softest = std::min(scales.softest, body.young_modulus);
      }
    scales.pressure   = pressure;
    scales.compliance = model.width() / stiffest;
    scales.length     = scales.compliance * scales.pressure;
    return scales;
  }

  Scales
  scales_of(Random &random, const SceneData &model)
  {
    return scales_of(model, draw_pressure(random, model));
  }

  Layer
  straight_layer(Random &random, const Scales &scales)
  {
    const double place = std::log10(scales.compliance);
    Layer layer        = draw_layer(random, place - 4., place + 3., 0.3);
    layer.friction     = random.uniform(0.05, 1.2);
    return layer;
  }

  void
  make_curved(Random &random, Layer &layer, const Scales &scales)
  {
    switch (random.integer(0, 3))
      {
        case 0:
          make_power(random, layer, true, scales);
          break;
        case 1:
          make_table(random, layer, true, scales);
          break;
        case 2:
          make_expression(random, layer, true, scales);
          break;
        default:
          make_closing(random, layer, scales);
      }
    switch (random.integer(0, 9))
      {
        case 0:
          make_power(random, layer, false, scales);
          break;
        case 1:
          make_table(random, layer, false, scales);
          break;
        case 2:
          make_expression(random, layer, false, scales);
          break;
        default:
          break; // linear or rigid
      }
  }

  double
  lose_friction(Random &random, Layer &layer)
  {
    const double left = layer.friction * random.uniform(0.2, 0.95);
    set(layer, "Residual friction coefficient", left);
    return left;
  }

  void
  bond(Random &random, Layer &layer, const Scales &scales)
  {
    layer.cohesion = scales.pressure * random.power_of_ten(-2., 1.);
    if (random.chance(0.7))
      set(layer, "Tensile strength", random.uniform(0., 0.95) * layer.cohesion / layer.friction);
    if (random.chance(0.5))
      layer.more.emplace_back("Bond lost by", "slip");
  }

  void
  dilate(Random &random, Layer &layer, const Scales &scales, const double least_friction)
  {
    const double pi = 3.14159265358979323846;
    set(
      layer, "Dilatancy angle", 180. / pi * std::atan(least_friction * random.uniform(0.05, 0.95)));
    if (random.chance(0.6))
      set(layer, "Dilation limit", scales.length * random.power_of_ten(-2., 2.));
  }

  void
  bend(Random &random, Layer &layer, const Scales &scales)
  {
    for (const auto &[entry, unused] : layer.more)
      if (entry == "Dilatancy angle")
        return;
    set(layer, "Envelope exponent", random.uniform(0.2, 0.95));
    set(layer, "Envelope pressure", scales.pressure * random.power_of_ten(-2., 1.));
  }

  void
  couple(Random &random, Layer &layer, const Scales &scales)
  {
    const double place     = std::log10(scales.compliance);
    layer.normal_law       = "linear";
    layer.shear_law        = "linear";
    layer.shear_compliance = random.power_of_ten(place - 4., place + 3.);
    if (random.chance(0.4))
      {
        layer.normal_compliance = scales.compliance * random.power_of_ten(-3., 3.);
        layer.normal_law        = "hyperbolic";
        set(layer,
            "Normal closure limit",
            layer.normal_compliance * scales.pressure * random.power_of_ten(0., 2.));
      }
    else
      layer.normal_compliance = random.power_of_ten(place - 4., place + 3.);
    const bool closure = random.chance(0.5);
    layer.more.emplace_back("Shear stiffness grows with", closure ? "closure" : "pressure");
    if (closure)
      set(layer,
          "Shear growth closure",
          layer.normal_compliance * scales.pressure * random.power_of_ten(1., 3.));
    else
      set(layer, "Shear growth pressure", scales.pressure * random.power_of_ten(-1., 1.));
    set(layer, "Shear growth exponent", random.uniform(0.1, 1.));
  }
  Layer
  any_layer(Random &random, const Scales &scales)
  {
    Layer layer        = straight_layer(random, scales);
    const bool coupled = random.chance(0.15);
    if (coupled)
      couple(random, layer, scales);
    else if (random.chance(0.6))
      make_curved(random, layer, scales);
    double left = layer.friction;
    if (random.chance(0.4))
      left = lose_friction(random, layer);
    if (random.chance(0.3))
      {
        layer.cohesion = scales.pressure * random.power_of_ten(-2., 1.);
        if (random.chance(0.5))
          layer.more.emplace_back("Bond lost by", "slip");
      }
    if (!coupled && random.chance(0.3))
      dilate(random, layer, scales, left);
    return layer;
  }

  Layer
  any_layer_or_bond(Random &random, const Scales &scales)
  {
    Layer layer;
    if (random.chance(0.2))
      {
        layer = straight_layer(random, scales);
        if (random.chance(0.5))
          make_curved(random, layer, scales);
        bond(random, layer, scales);
      }
    else
      layer = any_layer(random, scales);
    if (random.chance(0.1))
      layer.initial_gap = fmt::format("{}", scales.length * random.power_of_ten(-2., 1.));
    return layer;
  }
} // namespace fuga::stress

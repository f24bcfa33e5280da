// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

// Every law of the layer and every strength that can be lost, alone and together.

#include "stress/families.h"
#include "stress/law_draws.h"

#include <fmt/format.h>

namespace fuga::stress::families
{
  namespace
  {
    GridModel
    with_layers(Random &random, GridModel model, const std::function<Layer(const Scales &)> &draw)
    {
      const Scales scales = scales_of(random, model);
      set_layers(model, [&] { return draw(scales); });
      draw_any_stages(random, model);
      return model;
    }

    /** Anything on straight layers that @p change has made into others. */
    GridModel
    with_straight_layers(Random &random, void (*change)(Random &, Layer &, const Scales &))
    {
      return with_layers(random, draw_anything(random), [&](const Scales &scales) {
        Layer layer = straight_layer(random, scales);
        change(random, layer, scales);
        return layer;
      });
    }
  } // namespace

  GridModel
  residual(Random &random)
  {
    return with_layers(random, draw_anything(random), [&](const Scales &scales) {
      Layer layer = straight_layer(random, scales);
      lose_friction(random, layer);
      return layer;
    });
  }

  GridModel
  bonds(Random &random)
  {
    return with_layers(random, draw_anything(random), [&](const Scales &scales) {
      Layer layer = straight_layer(random, scales);
      bond(random, layer, scales);
      if (random.chance(0.3))
        lose_friction(random, layer);
      return layer;
    });
  }

  GridModel
  dilatancy(Random &random)
  {
    return with_layers(random, draw_anything(random), [&](const Scales &scales) {
      Layer layer       = straight_layer(random, scales);
      const double left = random.chance(0.3) ? lose_friction(random, layer) : layer.friction;
      dilate(random, layer, scales, left);
      return layer;
    });
  }

  GridModel
  curved_laws(Random &random)
  {
    return with_straight_layers(random, make_curved);
  }

  GridModel
  coupled_shear(Random &random)
  {
    return with_straight_layers(random, couple);
  }

  GridModel
  envelopes(Random &random)
  {
    return with_straight_layers(random, bend);
  }

  GridModel
  envelopes_with_laws(Random &random)
  {
    return with_layers(random, draw_anything(random), [&](const Scales &scales) {
      Layer layer = any_layer(random, scales);
      bend(random, layer, scales);
      return layer;
    });
  }

  // A block whose top is moved down, lifted until all is open, and put down again, to and fro.
  GridModel
  lift_off(Random &random)
  {
    GridModel model     = random.chance(0.5) ? draw_single(random) : draw_stack(random);
    const Scales scales = scales_of(random, model);
    const bool curved   = random.chance(0.7);
    set_layers(model, [&] {
      Layer layer = straight_layer(random, scales);
      if (curved)
        make_curved(random, layer, scales);
      if (random.chance(0.3))
        lose_friction(random, layer);
      return layer;
    });
    if (random.chance(0.3))
      model.joints[0].layer.initial_gap =
        fmt::format("{}", scales.length * random.power_of_ten(-2., 1.));
    model.supports.erase("block_right");
    model.supports["block_top"] = "all";
    model.loads                 = {
                      {"displacement",
                       "block_top",
                       fmt::format("0; {}", -scales.length * random.power_of_ten(0., 1.))},
                      {"displacement", "block_top", fmt::format("{}; 0", scales.length * random.uniform(0., 2.))}};
    const unsigned int n_turns = random.integer(1, 3);
    for (unsigned int i = 0; i < n_turns; ++i)
      {
        model.stages.push_back({random.uniform(0.5, 1.5), random.uniform(-1., 1.)});
        model.stages.push_back({-random.uniform(0.1, 5.), random.uniform(-1., 1.)});
      }
    model.stages.push_back({1., random.uniform(-1., 1.)});
    return model;
  }

  GridModel
  all_laws(Random &random)
  {
    const GridModel model = draw_anything(random);
    return with_layers(
      random, model, [&](const Scales &scales) { return any_layer(random, scales); });
  }

  GridModel
  all_laws_crossing(Random &random)
  {
    const GridModel model = random.chance(0.5) ? draw_cross(random) : draw_masonry(random);
    return with_layers(
      random, model, [&](const Scales &scales) { return any_layer(random, scales); });
  }
} // namespace fuga::stress::families

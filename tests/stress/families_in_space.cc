// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "stress/families_in_space.h"

#include "stress/families.h"

namespace fuga::stress::families
{
  namespace
  {
    /** Layers with which a joint in space can be followed, stiffness from 1e-1 to 1e6 of a body's.
     */
    Layer
    draw_layer_in_space(Random &random)
    {
      Layer layer    = draw_layer(random, -8., -3., 0.15);
      layer.friction = random.uniform(0.2, 1.);
      return layer;
    }

    /** A plane scene with few contact elements and without points, in which the first load presses
     * all bodies together: how bodies without load lie is not unique. */
    GridModel
    draw_section(Random &random)
    {
      constexpr std::size_t many_faces = 12;
      const auto draw =
        random.one_of<GridModel (*)(Random &)>({draw_tower, draw_wedge, draw_stack, draw_stack});
      GridModel model = draw(random);
      while (model.n_joint_faces() > many_faces)
        model = draw(random);
      model.triangles    = false;
      model.plane_stress = false;
      model.load_levels  = 3;
      set_layers(model, [&] { return draw_layer_in_space(random); });
      return model;
    }

    SpatialGrid
    extruded_anyhow(Random &random, const GridModel &section)
    {
      const double length = random.power_of_ten(-0.5, 0.5);
      return extrude(section, grid_lines({0., length}, {2}, {random.power_of_ten(-0.5, 0.5)}));
    }
  } // namespace

  SpatialGrid
  extruded(Random &random)
  {
    GridModel section = draw_section(random);
    // Often what presses the joints together comes first.
    if (random.chance(0.6))
      {
        section.stages.emplace_back(section.loads.size(), 0.);
        section.stages[0][0] = 1.;
      }
    draw_stages(random, section, random.integer(1, 2));
    return extruded_anyhow(random, section);
  }

  SpatialGrid
  extruded_reversal(Random &random)
  {
    GridModel section = draw_section(random);
    draw_reversals(random, section, random.integer(1, 4));
    return extruded_anyhow(random, section);
  }
} // namespace fuga::stress::families

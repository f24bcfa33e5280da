// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_program_monitor_h
#define fuga_bodies_program_monitor_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/program/monitor_point.h>

namespace fuga
{
  /**
   * The displacement of one point, and on request its stress, as functions of interface coordinates
   * and load factors: two back substitutions per component (and per derivative) before the path
   * begins, and as many products as there are coordinates for each evaluation. No field is
   * recovered.
   */
  class Monitor
  {
  public:
    /** The data from which the displacement of the point is computed. */
    enum class Source
    {
      /** Interface coordinates and load factors. */
      loads,
      /**
       * For bodies in motion: the displacement of all nodes, entry node * dim + component, in place
       * of the coordinates.
       */
      field
    };

    /** @p model contains the material of the body. */
    template <int dim>
    Monitor(const MonitorDefinition &definition,
            const MonitorPoint<dim> &point,
            const ModelDefinition &model,
            const CondensedSystem<dim> &system,
            const Source source = Source::loads);

    const std::string &
    name() const
    {
      return its_name;
    }

    const std::array<double, 3> &
    position() const
    {
      return its_position;
    }

    /** Return u [length] for interface coordinates @p x and load factors @p a. */
    std::array<double, 3>
    displacement(const Vector &x, const Vector &a) const;

    /**
     * With Source::field, return the value at the point of a field by nodes, like the displacement.
     */
    std::array<double, 3>
    value_of(const Vector &field) const;

    /**
     * With Source::field, return the degrees of freedom (entry node * dim + component) of the field
     * that are used.
     */
    std::vector<unsigned int>
    watched_dofs() const;

    bool
    has_stress() const
    {
      return !gradient.empty();
    }

    /** Return the index of the body of the point. */
    unsigned int
    body() const
    {
      return its_body;
    }

    /**
     * Return σxx, σyy, σzz (across the plane; hoop stress), σxy, σxz, σyz [stress] at the thermal
     * strain αΔT of the point; not a number unless has_stress().
     */
    std::array<double, 6>
    stress(const Vector &x, const Vector &a, const double thermal_strain) const;

  private:
    template <int dim>
    std::array<double, 6>
    stress_in(const Vector &x, const Vector &a, const double thermal_strain) const;

    std::string its_name;
    std::array<double, 3> its_position{};
    unsigned int its_body = 0;
    Material material;
    PlaneAssumption assumption = PlaneAssumption::plane_strain;
    std::vector<LinearResponse> components;
    /** ∂u_i/∂x_j, row by row; empty without stress. */
    std::vector<LinearResponse> gradient;
    /** The hoop strain; empty except in axisymmetry. */
    LinearResponse radial;
  };
} // namespace fuga

#endif

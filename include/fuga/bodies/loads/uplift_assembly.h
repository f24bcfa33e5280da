// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_loads_uplift_assembly_h
#define fuga_bodies_loads_uplift_assembly_h

#include <fuga/bodies/joints/contact_bars.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/bodies/loads/uplift_way.h>
#include <fuga/bodies/space/face_map.h>

#include <functional>

namespace fuga
{
  /**
   * Converts the water of one uplift to forces between the two sides of contact elements: ∫ N u dA
   * along the faces of the joints, exact also if the water line or the distribution of the pressure
   * has a corner within a face.
   */
  template <int dim>
  class UpliftAssembly
  {
  public:
    /** All arguments must outlive this object. @throws InputError, see UpliftWay. */
    UpliftAssembly(const LoadDefinition &load,
                   const Discretization<dim> &discretization,
                   const JointGeometry<dim> &geometry,
                   const ContactBars<dim> &bars,
                   const JointedMesh &mesh);

    /** Return the pattern for one pair of levels. */
    LoadPattern
    assemble(const WaterLevels &levels) const;

    /**
     * Return the forces that press the two sides of every bar apart, for each of @p levels, if the
     * water has this access to the elements; with empty @p access, those in the closed joint.
     */
    std::vector<Vector>
    forces(const std::vector<WaterAccess> &access, const std::vector<WaterLevels> &levels) const;

    /**
     * Return the levels at which the forces do not change smoothly, in increasing order, see
     * fuga::levels_of_kinks().
     */
    std::vector<double>
    levels_of_kinks() const;

    const UpliftWay<dim> &
    way() const
    {
      return its_way;
    }

  private:
    using FacePoint = typename FaceMap<dim>::FacePoint;

    /** The part of one face that belongs to an element: on every line its reach when it is open. */
    struct Extent
    {
      std::size_t element = 0, way = 0;
      PlanOutline outline;
    };

    /** A point of a quadrature rule. */
    struct QuadraturePoint
    {
      double along = 0., across = 0., height = 0., area = 0.;
      /** Values of the shape functions of the nodes of the face. */
      std::vector<double> values;
    };

    /** A line across one face, in the direction of flow. */
    struct Line
    {
      std::size_t face = 0;
      typename FaceMap<dim>::Line line;
      /** Values at the beginning and the end of the line. */
      double along[2] = {}, across[2] = {}, height[2] = {};
      /** Quadrature points for integrands without a corner on the line. */
      std::vector<QuadraturePoint> points = {};

      bool
      is_along_flow() const
      {
        return across[0] == across[1];
      }
    };

    void
    find_extents();

    /**
     * Return lines that sweep all faces; the integral is exact if the pressure has corners only at
     * the heights of @p levels and, @p for_closed_joint, where it has them without any reach.
     */
    std::vector<Line>
    make_lines(const bool for_closed_joint, const std::vector<WaterLevels> &levels) const;

    /**
     * Return functions of the position on a face, by their values at its corners, that vanish where
     * the ends of the way have a corner and, if the joint is closed, where the pressure has one.
     */
    std::vector<Vector>
    corner_functions(const std::size_t face,
                     const bool for_closed_joint,
                     const std::vector<WaterLevels> &levels) const;

    /** Return the quadrature points of a part of a line, from one position on it to another. */
    std::vector<QuadraturePoint>
    points_between(const Line &line, const double begin, const double end) const;

    /** Return ∫ N u dA over all @p lines, with the @p access that determines the reaches. */
    std::vector<Vector>
    integrate(const std::vector<Line> &lines,
              const std::vector<WaterAccess> &access,
              const std::vector<WaterLevels> &levels) const;

    /** Return the reaches on the line at the coordinate @p across. */
    std::vector<WaterReach>
    reaches(const std::vector<WaterAccess> &access,
            const std::size_t way,
            const double across) const;

    /** Return the pressures on a line with these reaches. */
    WaterLine
    water_line(const std::size_t way, const double across, std::vector<WaterReach> open) const;

    /** Return the pressure of the water at a coordinate across the flow. */
    using WaterAcross = std::function<const WaterLine &(const double across)>;

    /** Add ∫ N u dA along one line. */
    void
    add_line(const Line &line,
             const WaterAcross &water,
             const std::vector<WaterLevels> &levels,
             std::vector<Vector> &forces) const;
    void
    add_points(const Line &line,
               const std::vector<QuadraturePoint> &points,
               const WaterAcross &water,
               const std::vector<WaterLevels> &levels,
               std::vector<Vector> &forces) const;

    /** Return the positions on a line at which its integrand has a corner, including 0 and 1. */
    std::vector<double>
    cuts(const Line &line, const WaterAcross &water, const std::vector<WaterLevels> &levels) const;

    /** Return ∫ N u dA with u due to the depth below a level. */
    std::vector<Vector>
    still_water(const std::vector<WaterLevels> &levels, double WaterLevels::*level) const;

    /** Return the forces under a profile from end to end, with still water in all open elements. */
    std::vector<Vector>
    forces_by_elements(const std::vector<WaterAccess> &access,
                       const std::vector<WaterLevels> &levels) const;

    const LoadDefinition &load;
    const Discretization<dim> &discretization;
    const ContactBars<dim> &bars;
    UpliftWay<dim> its_way;
    std::vector<FaceMap<dim>> maps;
    std::vector<Extent> extents;
    /**
     * Lines without corners: exact except for the faces in space that a corner crosses obliquely.
     */
    std::vector<Line> plain_lines;
    /** Contact elements at the nodes of every face, with their weights. */
    std::vector<std::vector<typename ContactBars<dim>::Shares>> elements;
  };
} // namespace fuga

#endif

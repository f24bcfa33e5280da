// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_warnings_implausible_loads_h
#define fuga_output_warnings_implausible_loads_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/contact/load_history.h>
#include <fuga/input/parameters.h>

#include <set>

namespace fuga
{
  /**
   * Warnings about loads that contradict each other at the end of a stage: a load that acts twice
   * on the same place, water that is higher than the face it presses on while the face above it is
   * dry, a joint without uplift that ends in water.
   */
  template <int dim>
  class ImplausibleLoads
  {
  public:
    /** @p load_factors are LoadProgram::load_factors. */
    ImplausibleLoads(const Parameters &parameters,
                     const CondensedSystem<dim> &system,
                     const LoadHistory &load_factors);

    /** Check the end of a stage in which the system has the bodies. */
    void
    review(const unsigned int stage);

    /** Return one warning for every contradiction, however many stages have it. */
    const std::vector<std::string> &
    warnings() const
    {
      return texts;
    }

  private:
    using BoundaryFace = typename Discretization<dim>::BoundaryFace;

    /** Still water on boundaries at a load time. */
    struct Water
    {
      const LoadDefinition *load = nullptr;
      double level               = 0.;
      double factor              = 1.;
      std::vector<bool> loaded;
    };

    void
    find_loads_given_twice(const unsigned int stage);
    bool
    do_the_same(const LoadDefinition &a, const LoadDefinition &b) const;
    std::vector<Water>
    water_at(const double t) const;
    /** Return for each boundary whether nothing presses on it, holds it or faces it. */
    std::vector<bool>
    dry_labels(const double t) const;
    void
    find_dry_faces(const unsigned int stage);
    void
    find_dry_ends(const unsigned int stage);
    void
    compare_ends(const LoadDefinition &uplift, const double factor, const double t);

    /** Add a warning; @p key distinguishes contradictions. */
    void
    warn(const std::string &key, std::string text);

    const Parameters &parameters;
    const ModelDefinition &model;
    const CondensedSystem<dim> &system;
    const LoadHistory &load_factors;
    double extent = 0.;
    std::set<std::string> known;
    std::vector<std::string> texts;
  };
} // namespace fuga

#endif

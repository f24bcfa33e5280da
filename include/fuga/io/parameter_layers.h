// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_layers_h
#define fuga_io_parameter_layers_h

#include <fuga/io/layer_law.h>
#include <fuga/io/parameter_values.h>

namespace fuga
{
  /** Fails at @p one if both entries are given. */
  void
  refuse_both(const ParameterSection &section, const AnyEntry &one, const AnyEntry &other);

  /** What reading the layer of a joint depends on besides its own section. */
  struct LayerSurroundings
  {
    const std::map<std::string, double> &constants;
    /** Stress up to which laws are checked [MPa]. */
    double largest_stress;
    /** Laws that section Sweep gives the joint: the section of the joint has the entries of all of
     * them. */
    std::vector<LayerLaw> swept_normal_laws, swept_shear_laws;
    /** The joint has shear strength, so that it needs a shear law. */
    bool has_shear;
  };

  /**
   * Reads law, compliance and curve of one direction into @p joint and checks the law.
   * @throws InputError for entries that are missing or belong to another law, and for laws that
   * check_law() refuses.
   */
  void
  read_layer(const ParameterSection &section,
             const LayerDirection direction,
             const LayerSurroundings &surroundings,
             JointParameters &joint);
} // namespace fuga

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_layer_law_h
#define fuga_input_layer_law_h

#include <fuga/input/parameters.h>

#include <map>
#include <memory>

namespace fuga
{
  /** The directions of a layer, each of which has its own law. */
  enum class LayerDirection
  {
    normal,
    shear
  };

  /** Return the laws of one direction with their words in parameter files. */
  std::vector<std::pair<std::string, LayerLaw>>
  law_words(const LayerDirection direction);

  /** Return the word of a law in parameter files. */
  std::string
  law_word(const LayerLaw law);

  /** Return whether a law has a compliance at zero deformation as a parameter. */
  bool
  has_compliance_entry(const LayerLaw law);

  /** Return whether this compliance must be above zero. */
  bool
  needs_compliance(const LayerLaw law);

  /**
   * Create the law of @p joint; no parameter may be missing. @throws InputError for an expression.
   */
  std::unique_ptr<ComplianceLaw>
  make_layer_law(const JointParameters &joint,
                 const LayerDirection direction,
                 const std::map<std::string, double> &constants);
} // namespace fuga

#endif

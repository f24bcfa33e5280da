// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_layer_law_h
#define fuga_io_layer_law_h

#include <fuga/io/parameters.h>

#include <map>
#include <memory>
#include <optional>

namespace fuga
{
  /** The directions in which a layer has a law each. */
  enum class LayerDirection
  {
    normal,
    shear
  };

  /** "Normal" or "Shear", with which the entries begin. */
  std::string
  direction_word(const LayerDirection direction);

  /** The word of a law in parameter files. */
  std::string
  law_word(const LayerLaw law);

  /** The words of all laws of one direction. */
  std::vector<std::string>
  law_words(const LayerDirection direction);

  /** Nothing if no law of this direction has the word. */
  std::optional<LayerLaw>
  law_of_word(const std::string &word, const LayerDirection direction);

  /** Whether a law has a compliance at zero deformation as a parameter. */
  bool
  has_compliance_entry(const LayerLaw law);

  /** Whether this compliance must be above zero. */
  bool
  needs_compliance(const LayerLaw law);

  /**
   * What the law of a direction still needs: "" or a sentence beginning with the name of the entry
   * in quotes.
   */
  std::string
  missing_entry(const JointParameters &joint, const LayerDirection direction);

  /** The law itself. Nothing may be missing. @throws InputError for an expression. */
  std::unique_ptr<ComplianceLaw>
  make_layer_law(const JointParameters &joint,
                 const LayerDirection direction,
                 const std::map<std::string, double> &constants);
} // namespace fuga

#endif

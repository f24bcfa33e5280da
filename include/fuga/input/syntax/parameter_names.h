// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_names_h
#define fuga_input_syntax_parameter_names_h

#include <string>
#include <vector>

namespace fuga
{
  /** Without white space at both ends, and with every run of it inside replaced by one blank. */
  std::string
  normalise_blanks(const std::string &text);

  /** The normalised pieces between separators, empty ones included; an empty text has no pieces. */
  std::vector<std::string>
  split_pieces(const std::string &text, const char separator);

  /** 'a', 'b', 'c'. */
  std::string
  quoted_list(const std::vector<std::string> &names);

  /**
   * A sentence that helps who wrote @p wrong instead of one of the @p known names: "Did you mean
   * 'x'?" for names a few letters away (capitals do not count), else the list of the known ones;
   * @p what says what they are, e.g. "entries of Mesh".
   */
  std::string
  name_hint(const std::string &wrong,
            const std::vector<std::string> &known,
            const std::string &what);
} // namespace fuga

#endif

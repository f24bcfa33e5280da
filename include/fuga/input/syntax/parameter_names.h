// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_syntax_parameter_names_h
#define fuga_input_syntax_parameter_names_h

#include <string>
#include <vector>

namespace fuga
{
  /** Remove white space at both ends, and replace every run of it inside by one blank. */
  std::string
  normalise_blanks(const std::string &text);

  /**
   * Return the normalised pieces between separators, including empty ones; an empty text has no
   * pieces.
   */
  std::vector<std::string>
  split_pieces(const std::string &text, const char separator);

  /** Return the names in the form 'a', 'b', 'c'. */
  std::string
  quoted_list(const std::vector<std::string> &names);

  /**
   * Return a sentence that helps a user who wrote @p wrong instead of one of the @p known names:
   * "Did you mean 'x'?" for names a few letters away (ignoring case), otherwise the list of the
   * known ones; @p what says what they are, e.g. "entries of Mesh".
   */
  std::string
  name_hint(const std::string &wrong,
            const std::vector<std::string> &known,
            const std::string &what);
} // namespace fuga

#endif

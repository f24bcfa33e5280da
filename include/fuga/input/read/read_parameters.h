// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_input_read_read_parameters_h
#define fuga_input_read_read_parameters_h

#include <fuga/input/parameters.h>

namespace fuga
{
  /**
   * Read a .prm or .json file, apply the @p overrides ("Section/Sub/Entry=value"; an empty value
   * removes the entry from the file) and check everything that can be checked without the mesh.
   * @throws InputError whose message names file, line, entry, value, what is allowed and what to
   * do.
   */
  Parameters
  read_parameters(const std::string &file, const std::vector<std::string> &overrides = {});

  /**
   * Return a complete parameter file with every entry, its documentation and its default (or an
   * example where there is none). Entries which may only be given in place of another one are
   * comments.
   */
  std::string
  default_parameter_text();

  /**
   * Return the echo as a JSON object with nested sections, which is itself a valid .json parameter
   * file.
   */
  std::string
  echo_json(const Parameters &parameters);
} // namespace fuga

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_point_text_h
#define fuga_bodies_point_text_h

#include <deal.II/base/tensor.h>

#include <fmt/format.h>

#include <string>

namespace fuga
{
  /** "(x, y)" or "(x, y, z)", for messages; also of a direction. @p digits significant digits. */
  template <int dim>
  std::string
  text_of(const dealii::Tensor<1, dim> &point, const int digits = 6)
  {
    std::string text;
    for (unsigned int c = 0; c < dim; ++c)
      text += fmt::format("{}{:.{}g}", c == 0 ? "(" : ", ", point[c], digits);
    return text + ")";
  }
} // namespace fuga

#endif

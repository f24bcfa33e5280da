// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_contact_path_choice_h
#define fuga_contact_path_choice_h

#include <fuga/contact/contact_path.h>

#include <memory>

namespace fuga
{
  /** Whether any element has two tangential bars, which share one cone of friction. */
  bool
  have_cones(const std::vector<ContactElement> &elements);

  /** ConePath if there are such elements, else EventPath. All arguments but @p options must outlive
   *  the path. @throws InputError, as ConePath. */
  std::unique_ptr<ContactPath>
  make_contact_path(const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const LoadHistory &history,
                    const PathOptions &options);
} // namespace fuga

#endif

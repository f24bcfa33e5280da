// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/cone_path.h>
#include <fuga/contact/event_path.h>
#include <fuga/contact/path_choice.h>

#include <algorithm>

namespace fuga
{
  bool
  have_cones(const std::vector<ContactElement> &elements)
  {
    return std::any_of(elements.begin(), elements.end(), [](const ContactElement &element) {
      return element.has_second_tangential_bar();
    });
  }

  std::unique_ptr<ContactPath>
  make_contact_path(const std::vector<ContactElement> &elements,
                    const LayeredSystem &system,
                    const LoadHistory &history,
                    const PathOptions &options)
  {
    if (have_cones(elements))
      return std::make_unique<ConePath>(elements, system, history, options);
    return std::make_unique<EventPath>(elements, system, history, options);
  }
} // namespace fuga

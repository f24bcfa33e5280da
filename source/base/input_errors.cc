// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/input_errors.h>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

namespace fuga
{
  namespace
  {
    constexpr std::size_t max_shown = 20;

    /** Several input errors; each of their messages has already been shortened. */
    class SeveralErrors : public InputError
    {
    public:
      explicit SeveralErrors(std::string whole_text) : InputError(""), text(std::move(whole_text))
      {
      }

      const char *
      what() const noexcept override
      {
        return text.c_str();
      }

    private:
      const std::string text;
    };
  } // namespace


  InputErrors::InputErrors(std::string name_of_file) : file(std::move(name_of_file))
  {
  }


  unsigned long
  InputErrors::line_of(const std::string &message) const
  {
    const std::size_t at = file.size() + 1;
    if (file.empty() || message.compare(0, at, file + ":") != 0 || at >= message.size() ||
        std::isdigit(static_cast<unsigned char>(message[at])) == 0)
      return std::numeric_limits<unsigned long>::max();
    return std::stoul(message.substr(at));
  }


  void
  InputErrors::throw_if_any() const
  {
    if (messages.empty())
      return;
    if (messages.size() == 1)
      throw InputError(messages.front());
    std::vector<std::string> sorted = messages;
    std::stable_sort(sorted.begin(), sorted.end(), [this](const auto &a, const auto &b) {
      return line_of(a) < line_of(b);
    });
    const std::size_t n = sorted.size();
    sorted.resize(std::min(n, max_shown));
    throw SeveralErrors(fmt::format(
      "{}\n{} errors{}. Nothing was computed.",
      fmt::join(sorted, "\nError: "),
      n,
      n > max_shown ? fmt::format(", the first {} are shown", max_shown) : std::string()));
  }
} // namespace fuga

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/read/parameter_readers.h>
#include <fuga/input/syntax/unit_text.h>
#include <fuga/input/values/value_readers.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fuga
{
  namespace
  {
    /** Number of further variants that are read after an error, because they may have errors of
     * their own. */
    constexpr std::size_t n_read_behind_error = 200;

    /** Return what an entry decides, given its name in an echo. */
    Decides
    decided_by(const std::string &full_name)
    {
      const EntryDeclaration *const entry = find_entry(full_name);
      return entry == nullptr ? Decides::condensation : entry->decides;
    }

    /**
     * Return a key of everything that determines the condensation, i.e. all but the laws and
     * strengths of the joints and the motion of the ground. A joint without shear strength has no
     * tangential bars; the time step may be that of a record.
     */
    std::string
    condensation_key(const Parameters &parameters)
    {
      std::string key;
      for (const auto &[name, value] : parameters.echo)
        if (decided_by(name) <= Decides::condensation)
          key += name + "=" + value + "\n";
      key += fmt::format("{}\n", parameters.model.dynamics.time_step);
      for (const JointParameters &joint : parameters.joints)
        key += joint.friction.is_frictionless() ? '0' : '1';
      return key;
    }

    /** Return a key of everything that determines the layers of the joints beyond the
     * condensation. */
    std::string
    layer_key(const Parameters &parameters)
    {
      std::string key;
      for (const auto &[name, value] : parameters.echo)
        if (decided_by(name) == Decides::layers)
          key += name + "=" + value + "\n";
      return key;
    }

    /** Return the unit in the meaning of an entry whose value is a number, in the units of the
     * user. */
    std::string
    unit_of(const SweptLine &line, const Units &units)
    {
      if (line.targets.empty())
        return "";
      const EntryDeclaration *entry = find_entry(line.targets.front().full_name());
      if (entry == nullptr || !(entry->range || entry->content == TextContent::level))
        return "";
      const std::size_t begin = entry->documentation.find('[');
      const std::size_t end   = entry->documentation.find(']');
      if (begin == std::string::npos)
        return "";
      const std::string unit = in_units(entry->documentation.substr(begin, end + 1 - begin), units);
      return unit.substr(1, unit.size() - 2);
    }

    /** Return the values of a variant as they are read: expressions of constants are numbers. */
    std::vector<std::string>
    settings_of(const SweepPlan &plan, const std::size_t i, const Parameters &parameters)
    {
      const std::vector<std::size_t> choice = plan.choice(i);
      std::vector<std::string> settings;
      for (std::size_t l = 0; l < choice.size(); ++l)
        {
          const SweptLine &line = plan.lines()[l];
          const auto read =
            std::find_if(parameters.echo.begin(), parameters.echo.end(), [&](const auto &entry) {
              return !line.targets.empty() && entry.first == line.targets.front().full_name();
            });
          settings.push_back(read == parameters.echo.end() ? line.values[choice[l]] : read->second);
        }
      return settings;
    }

    /** Collects the errors of variants, each of them once, regardless of how many variants have
     * it. */
    class ErrorsOfVariants
    {
    public:
      explicit ErrorsOfVariants(const SweepPlan &plan_of_sweep)
        : plan(plan_of_sweep), errors(plan.file().file)
      {
      }

      void
      add(const std::size_t variant, const std::vector<std::string> &messages)
      {
        for (const std::string &message : messages)
          if (known.insert(without_value(message)).second)
            errors.add(is_of_line(message) ? message : message + where(variant));
      }

      bool
      any() const
      {
        return errors.any();
      }

      void
      throw_if_any() const
      {
        errors.throw_if_any();
      }

    private:
      /** Return a message without "= 'value'": an unknown entry is one mistake, however many values
       * it has. */
      static std::string
      without_value(const std::string &message)
      {
        const std::size_t begin = message.find(" = '"), end = message.find("': ");
        return begin == std::string::npos || end == std::string::npos || end < begin
                 ? message
                 : message.substr(0, begin) + message.substr(end);
      }

      bool
      is_of_line(const std::string &message) const
      {
        return std::any_of(plan.lines().begin(), plan.lines().end(), [&](const SweptLine &line) {
          return message.compare(0, line.line.origin.size() + 1, line.line.origin + ":") == 0;
        });
      }

      std::string
      where(const std::size_t variant) const
      {
        const std::vector<std::size_t> choice = plan.choice(variant);
        std::string text;
        for (std::size_t l = 0; l < choice.size(); ++l)
          text += fmt::format("{}{} = {}",
                              l == 0 ? "" : ", ",
                              plan.lines()[l].line.name,
                              plan.lines()[l].values[choice[l]]);
        return fmt::format(" (In the variant {} of section Sweep.)", text);
      }

      const SweepPlan &plan;
      InputErrors errors;
      std::set<std::string> known;
    };

    /** A variant with its place in the order of computation. */
    struct ReadVariant
    {
      Variant variant;
      std::size_t layers = 0;
    };

    /** Return the number of a key, in the order in which keys appear. */
    std::size_t
    number_of(const std::string &key, std::map<std::string, std::size_t> &known)
    {
      return known.emplace(key, known.size()).first->second;
    }
  } // namespace


  Parameters
  read_sweep(const SweepPlan &plan)
  {
    ErrorsOfVariants errors(plan);
    Parameters result;
    std::vector<ReadVariant> variants;
    std::map<std::string, std::size_t> condensations, layers;
    std::size_t n = plan.n_variants();
    for (std::size_t i = 0; i < n; ++i)
      {
        InputErrors of_variant(plan.file().file);
        try
          {
            Parameters one = read_scan(plan.variant(i), of_variant);
            ReadVariant read;
            read.variant.settings     = settings_of(plan, i, one);
            read.variant.joints       = one.joints;
            read.variant.ground       = one.model.dynamics.ground;
            read.variant.condensation = number_of(condensation_key(one), condensations);
            read.layers               = number_of(layer_key(one), layers);
            variants.push_back(std::move(read));
            if (i == 0)
              result = one;
            if (result.condensations.size() < condensations.size())
              result.condensations.push_back(std::make_shared<const Parameters>(std::move(one)));
          }
        catch (const InputError &error)
          {
            if (!errors.any())
              n = std::min(n, i + 1 + n_read_behind_error);
            errors.add(
              i, of_variant.any() ? of_variant.all() : std::vector<std::string>{error.what()});
          }
      }
    errors.throw_if_any();

    std::stable_sort(variants.begin(), variants.end(), [](const auto &a, const auto &b) {
      return std::pair(a.variant.condensation, a.layers) <
             std::pair(b.variant.condensation, b.layers);
    });
    for (ReadVariant &read : variants)
      result.variants.push_back(std::move(read.variant));
    for (const SweptLine &line : plan.lines())
      {
        result.swept.push_back({line.line.name, unit_of(line, result.output.units), line.today});
        if (line.line.name.find('/') != std::string::npos)
          result.echo.emplace_back(line.line.full_name(), line.line.value);
      }
    return result;
  }
} // namespace fuga

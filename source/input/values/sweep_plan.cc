// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/syntax/parameter_names.h>
#include <fuga/input/values/parameter_values.h>
#include <fuga/input/values/sweep_plan.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace fuga
{
  namespace
  {
    /** Largest number of variants; more than this are a slip of the pen. */
    constexpr std::size_t max_variants = 20000;

    const SweepEntries &
    entries()
    {
      return entries_of<SweepEntries>();
    }

    const std::string &
    stages()
    {
      return entries_of<StageEntries>().name;
    }

    /** Remove the other form of an entry that is varied from @p scan, unless it is varied as
     * well. */
    void
    take_out_alternative(const ScannedEntry &varied, ParameterScan &scan)
    {
      const EntryDeclaration *const entry = find_entry(varied.full_name());
      if (entry == nullptr || entry->alternative == nullptr)
        return;
      const auto is_other = [&](const ScannedEntry &other) {
        return other.path == varied.path && scan.swept.count(other.full_name()) == 0 &&
               other.name == entry->alternative->name;
      };
      scan.entries.erase(std::remove_if(scan.entries.begin(), scan.entries.end(), is_other),
                         scan.entries.end());
    }

    /** Return whether section Sweep varies an entry of joints by its own name. */
    bool
    is_older(const std::string &name)
    {
      const std::vector<Text> &older = entries().older;
      return std::any_of(
        older.begin(), older.end(), [&](const Text &entry) { return entry.name() == name; });
    }


    const ScannedEntry *
    find(const ParameterScan &scan, const SectionPath &path, const std::string &name)
    {
      const auto found =
        std::find_if(scan.entries.begin(), scan.entries.end(), [&](const ScannedEntry &entry) {
          return entry.path == path && entry.name == name;
        });
      return found == scan.entries.end() ? nullptr : &*found;
    }

    std::size_t
    combinations(const std::vector<SweptLine> &lines)
    {
      std::size_t n = 1;
      for (const SweptLine &line : lines)
        n = std::min(n * line.values.size(), max_variants + 1);
      return n;
    }

    /** Keep only the stages of a sequence, in its order. */
    void
    put_stages_in_order(const std::string &sequence, ParameterScan &scan)
    {
      const auto is_stage = [](const SectionPath &path) {
        return path.size() == 2 && path.front() == stages();
      };
      const std::vector<ScannedSection> earlier = scan.sections;
      std::vector<ScannedSection> sections;
      for (const ScannedSection &section : earlier)
        if (!is_stage(section.path))
          sections.push_back(section);
      const std::vector<std::string> names = split_pieces(sequence, ',');
      for (const std::string &name : names)
        for (const ScannedSection &section : earlier)
          if (section.path == SectionPath{stages(), name})
            sections.push_back(section);
      scan.sections          = std::move(sections);
      const auto is_left_out = [&](const ScannedEntry &entry) {
        return is_stage(entry.path) &&
               std::find(names.begin(), names.end(), entry.path.back()) == names.end();
      };
      scan.entries.erase(std::remove_if(scan.entries.begin(), scan.entries.end(), is_left_out),
                         scan.entries.end());
    }
  } // namespace

  SweepPlan::SweepPlan(ParameterScan whole) : scan(std::move(whole))
  {
    const std::vector<ScannedEntry> all = scan.entries;
    scan.entries.clear();
    // Entries of Sweep that have no slash are declared like those of other sections.
    for (const ScannedEntry &entry : all)
      if (entry.path != SectionPath{entries().name} || entry.name.find('/') == std::string::npos)
        scan.entries.push_back(entry);
    const ScannedEntry *const combination =
      find(scan, {entries().name}, entries().combination.name());
    in_step = combination != nullptr && value_of_word(entries().combination, combination->value);
    for (const ScannedEntry &entry : all)
      if (entry.path != SectionPath{entries().name})
        continue;
      else if (entry.name.find('/') != std::string::npos)
        add_line(entry);
      else if (entry.value.empty())
        continue; // this is reported where declared entries are read
      else if (is_older(entry.name))
        add_older_line(entry);
      else if (entry.name == entries().stages.name())
        add_sequences(entry, '|');
      else if (entry.name == entries().load_sequences.name())
        add_sequences(entry, ';');
    check_together();
    for (const SweptLine &line : swept_lines)
      for (const ScannedEntry &target : line.targets)
        scan.swept[target.full_name()] = line.values;
    scan.is_variant = !swept_lines.empty();
  }

  void
  SweepPlan::add_line(const ScannedEntry &entry)
  {
    if (entry.value.empty())
      entry.fail("there is no value. Write values separated by commas, or remove the line.");
    swept_lines.push_back(
      {entry, targets_of(entry.name, entry), split_swept_values(entry, scan), ""});
  }

  void
  SweepPlan::add_older_line(const ScannedEntry &entry)
  {
    const ScannedEntry *const listed = find(scan, {entries().name}, entries().joints.name());
    const std::string name           = fmt::format("{}/{}/{}",
                                         entries_of<JointEntries>().name,
                                         listed == nullptr ? "*" : listed->value,
                                         entry.name);
    swept_lines.push_back(
      {entry, targets_of(name, entry), split_swept_values(entry, scan), name + " = ..."});
  }

  void
  SweepPlan::add_sequences(const ScannedEntry &entry, const char separator)
  {
    SweptLine line{entry, {}, split_pieces(entry.value, separator), ""};
    if (entry.name == entries().load_sequences.name())
      line.today = fmt::format("{} = {}", entries().stages.name(), fmt::join(line.values, " | "));
    const std::vector<std::string> known = subsections_of(stages());
    for (const std::string &sequence : line.values)
      {
        const std::vector<std::string> names = split_pieces(sequence, ',');
        for (auto name = names.begin(); name != names.end(); ++name)
          {
            if (std::find(known.begin(), known.end(), *name) == known.end())
              entry.fail(fmt::format(
                "there is no such stage '{}'. {}", *name, name_hint(*name, known, "stages")));
            if (std::find(names.begin(), name, *name) != name)
              entry.fail(
                fmt::format("the stage '{}' comes twice in '{}'. Write a second stage with "
                            "a name of its own in section Stages.",
                            *name,
                            sequence));
          }
        if (names.empty())
          entry.fail("there is an empty sequence. Name the stages of each, separated by commas.");
      }
    swept_lines.push_back(line);
  }

  std::vector<ScannedEntry>
  SweepPlan::targets_of(const std::string &name, const ScannedEntry &entry) const
  {
    const std::vector<std::string> pieces = split_pieces(name, '/');
    const std::string &section            = pieces.front();
    const SectionDeclaration *declaration = find_section(section);
    const bool has_names = declaration != nullptr && declaration->has_named_subsections();
    if (std::find(pieces.begin(), pieces.end(), "") != pieces.end() || section == entries().name ||
        pieces.size() > 3 || (pieces.size() == 3 && declaration != nullptr && !has_names))
      entry.fail(
        "no entry has this name. Write 'set SECTION/ENTRY = values' or, where a section has "
        "subsections, 'set SECTION/NAME/ENTRY = values'.");
    if (has_names && pieces.size() == 2)
      entry.fail(fmt::format("the entries of {} stand in subsections. Write {}/NAME/{}; several "
                             "names are separated by commas, and * means all.",
                             section,
                             section,
                             pieces.back()));
    if (section == entries_of<OutputEntries>().name ||
        section == entries_of<AccuracyEntries>().name)
      entry.fail(
        "the entries of this section cannot be varied: all variants have the same columns, "
        "and none finds its mesh itself.");
    if (section == entries_of<ConstantEntries>().name &&
        find(scan, {section}, pieces.back()) == nullptr)
      {
        std::vector<std::string> known;
        for (const ScannedEntry &constant : scan.entries)
          if (constant.path == SectionPath{section})
            known.push_back(constant.name);
        entry.fail(fmt::format("there is no constant '{}' in {}. {}",
                               pieces.back(),
                               scan.file,
                               name_hint(pieces.back(), known, "constants")));
      }
    if (pieces.size() == 2)
      return {{{section}, pieces.back(), "", entry.origin}};
    std::vector<std::string> names = split_pieces(pieces[1], ',');
    if (pieces[1] == "*" && !subsections_of(section).empty())
      names = subsections_of(section);
    std::vector<ScannedEntry> targets;
    for (const std::string &one : names)
      targets.push_back({{section, one}, pieces.back(), "", entry.origin});
    return targets;
  }

  std::vector<std::string>
  SweepPlan::subsections_of(const std::string &section) const
  {
    std::vector<std::string> names;
    for (const ScannedSection &one : scan.sections)
      if (one.path.size() == 2 && one.path.front() == section)
        names.push_back(one.path.back());
    return names;
  }

  void
  SweepPlan::check_together() const
  {
    std::map<std::string, std::string> varied;
    for (const SweptLine &line : swept_lines)
      {
        std::vector<std::string> names;
        for (const ScannedEntry &target : line.targets)
          names.push_back(target.full_name());
        if (line.targets.empty())
          names.push_back(stages());
        for (const std::string &name : names)
          if (const auto [earlier, is_new] = varied.emplace(name, line.line.origin); !is_new)
            line.line.fail(fmt::format(
              "{} is varied already, see {}. Keep one of the two lines.", name, earlier->second));
        const SweptLine &first = swept_lines.front();
        if (in_step && line.values.size() != first.values.size())
          line.line.fail(fmt::format("'Combination = in step' needs as many values in every line: "
                                     "here are {}, in {} ({}) {}.",
                                     line.values.size(),
                                     first.line.name,
                                     first.line.origin,
                                     first.values.size()));
      }
    if (!in_step && combinations(swept_lines) > max_variants)
      swept_lines.back().line.fail(fmt::format("that makes more than {} variants.", max_variants));
  }

  std::size_t
  SweepPlan::n_variants() const
  {
    return swept_lines.empty() ? 0
           : in_step           ? swept_lines.front().values.size()
                               : combinations(swept_lines);
  }

  std::vector<std::size_t>
  SweepPlan::choice(const std::size_t i) const
  {
    std::vector<std::size_t> result(swept_lines.size(), i);
    std::size_t rest = i;
    for (std::size_t l = swept_lines.size(); !in_step && l-- > 0;)
      {
        result[l] = rest % swept_lines[l].values.size();
        rest /= swept_lines[l].values.size();
      }
    return result;
  }

  ParameterScan
  SweepPlan::variant(const std::size_t i) const
  {
    ParameterScan result                  = scan;
    const std::vector<std::size_t> chosen = choice(i);
    for (std::size_t l = 0; l < swept_lines.size(); ++l)
      {
        const SweptLine &line    = swept_lines[l];
        const std::string &value = line.values[chosen[l]];
        for (ScannedEntry entry : line.targets)
          {
            entry.value = value;
            const auto same =
              std::find_if(result.entries.begin(), result.entries.end(), [&](const auto &e) {
                return e.path == entry.path && e.name == entry.name;
              });
            if (same == result.entries.end())
              result.entries.push_back(entry);
            else
              *same = entry; // constants are read in the order of the file
            take_out_alternative(entry, result);
          }
        if (line.targets.empty())
          put_stages_in_order(value, result);
      }
    return result;
  }
} // namespace fuga

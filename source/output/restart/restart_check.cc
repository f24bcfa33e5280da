// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/loads/load_assembly.h>
#include <fuga/input/entries/parameter_entries.h>
#include <fuga/output/restart/checkpoint.h>

#include <algorithm>
#include <fmt/format.h>
#include <set>

namespace fuga
{
  namespace
  {
    using Entry  = std::pair<std::string, std::string>;
    using Echo   = std::vector<Entry>;
    using Values = std::map<std::string, std::string>;

    /** Return whether the path does not depend on an entry. The mesh is identified by its
     * content. */
    bool
    may_change(const std::string &full_name)
    {
      const EntryDeclaration *const entry = find_entry(full_name);
      return entry != nullptr && entry->decides == Decides::nothing;
    }

    /** Return the stage that an entry belongs to, or nothing. */
    std::string
    stage_of_entry(const std::string &path)
    {
      const std::string section = entries_of<StageEntries>().name + "/";
      return path.rfind(section, 0) == 0
               ? path.substr(section.size(), path.rfind('/') - section.size())
               : "";
    }

    std::vector<std::string>
    stages_of(const Echo &echo)
    {
      std::vector<std::string> stages;
      for (const Entry &entry : echo)
        {
          const std::string stage = stage_of_entry(entry.first);
          if (!stage.empty() && (stages.empty() || stages.back() != stage))
            stages.push_back(stage);
        }
      return stages;
    }

    /** Return the stages of @p now after those of @p before; none if these do not come first. */
    std::set<std::string>
    added_stages(const Echo &before, const Echo &now)
    {
      const std::vector<std::string> old_stages = stages_of(before), stages = stages_of(now);
      if (stages.size() < old_stages.size() ||
          !std::equal(old_stages.begin(), old_stages.end(), stages.begin()))
        return {};
      return {stages.begin() + static_cast<std::ptrdiff_t>(old_stages.size()), stages.end()};
    }

    /** Return the entries that the path up to the checkpoint may depend on. */
    Echo
    problem(const Echo &echo, const std::set<std::string> &without_stages)
    {
      Echo result;
      for (const Entry &entry : echo)
        if (!may_change(entry.first) && without_stages.count(stage_of_entry(entry.first)) == 0)
          result.push_back(entry);
      return result;
    }

    std::vector<std::string>
    differences(const Echo &before, const Echo &now)
    {
      const Values old_values(before.begin(), before.end()), values(now.begin(), now.end());
      std::vector<std::string> result;
      for (const auto &[path, old_value] : before)
        {
          const auto found = values.find(path);
          if (found == values.end())
            result.push_back(fmt::format("{}: was {}, is not there now", path, old_value));
          else if (found->second != old_value)
            result.push_back(fmt::format("{}: was {}, is {}", path, old_value, found->second));
        }
      for (const auto &[path, value] : now)
        if (old_values.count(path) == 0)
          result.push_back(fmt::format("{}: was not there, is {}", path, value));
      if (result.empty())
        for (std::size_t i = 0; i < now.size(); ++i)
          if (before[i].first != now[i].first)
            {
              result.push_back(fmt::format("order: {} stands where {} stood; what comes first has "
                                           "the lower numbers",
                                           now[i].first,
                                           before[i].first));
              break;
            }
      return result;
    }
  } // namespace

  std::vector<std::pair<std::string, std::string>>
  description_of_problem(const Parameters &parameters)
  {
    Echo result = parameters.echo;
    for (std::size_t axis = 0; axis < parameters.model.dynamics.ground.size(); ++axis)
      if (const Vector &a = parameters.model.dynamics.ground[axis].accelerations; !a.empty())
        result.emplace_back(fmt::format("the motion of the ground along {}", "xyz"[axis]),
                            fmt::format("{} samples with the checksum {:08x}",
                                        a.size(),
                                        checksum({reinterpret_cast<const char *>(a.data()),
                                                  a.size() * sizeof(double)})));
    return result;
  }

  void
  check_same_problem(const Checkpoint &checkpoint, const Parameters &parameters)
  {
    const std::set<std::string> added = added_stages(checkpoint.parameters, parameters.echo);
    std::vector<std::string> changes  = differences(
      problem(checkpoint.parameters, {}), problem(description_of_problem(parameters), added));
    if (!added.empty())
      for (const LoadDefinition &load : parameters.model.loads)
        if (depends_on_time(load))
          changes.push_back(
            fmt::format("Stages/{}: added, but the load '{}' changes with t, so that "
                        "a stage more changes all of its patterns",
                        *added.begin(),
                        load.name));
    const bool has_searches =
      std::any_of(parameters.model.stages.begin(),
                  parameters.model.stages.end(),
                  [](const StageDefinition &s) { return s.purpose != StagePurpose::loading; });
    if (!added.empty() && has_searches)
      changes.push_back(
        fmt::format("Stages/{}: added, but the results hold factors of safety of the "
                    "state before it",
                    *added.begin()));
    const FileIdentity mesh = identify_file(parameters.mesh_file);
    if (!(mesh == checkpoint.mesh))
      changes.push_back(fmt::format("the mesh {}: another content ({} bytes, were {})",
                                    parameters.mesh_file,
                                    mesh.size,
                                    checkpoint.mesh.size));
    if (changes.empty())
      return;
    std::string list;
    for (const std::string &change : changes)
      list += "\n  " + change;
    throw InputError(fmt::format(
      "The run in {} cannot be restarted with another problem. Changed since its checkpoint:{}\n"
      "Take these changes back, or run without --restart, which computes everything from the "
      "beginning. (Title, "
      "Output/Fields, Output/Log, Output/Report, Output/Checkpoint and the certificate's bound may "
      "change, and "
      "stages may be added after the last one.)",
      parameters.output.directory,
      list));
  }

  bool
  is_complete(const Checkpoint &checkpoint, const Parameters &parameters)
  {
    return checkpoint.finished && (checkpoint.cut.result.verdict != Verdict::done ||
                                   added_stages(checkpoint.parameters, parameters.echo).empty());
  }
} // namespace fuga

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/work_counter.h>
#include <fuga/bodies/processes.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/output/files/version.h>
#include <fuga/output/tables/summary.h>
#include <fuga/output/tables/summary_sections.h>

#include <deal.II/base/config.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fmt/format.h>

namespace fuga
{
  std::string
  mechanism_name(const MechanismKind kind)
  {
    switch (kind)
      {
        case MechanismKind::none:
          return "none";
        case MechanismKind::sliding:
          return "sliding";
        case MechanismKind::overturning:
          return "overturning";
        case MechanismKind::closing:
          return "closing";
        case MechanismKind::mixed:
          return "mixed";
      }
    return "";
  }

  std::string
  beyond_limit_end_name(const BeyondLimit::End end)
  {
    switch (end)
      {
        case BeyondLimit::End::none:
          return "none";
        case BeyondLimit::End::largest_jump:
          return "largest jump";
        case BeyondLimit::End::load_removed:
          return "load removed";
        case BeyondLimit::End::limit_regained:
          return "limit load regained";
        case BeyondLimit::End::no_continuation:
          return "no continuation";
      }
    return "";
  }

  const char *const SafetyFactor::largest_factor_reached = "largest factor reached";
  const char *const SafetyFactor::not_computed           = "not computed";

  bool
  SafetyFactor::found() const
  {
    return verdict != largest_factor_reached && verdict != not_computed;
  }

  namespace
  {
    using Json = nlohmann::ordered_json;

    template <typename Pairs>
    Json
    object(const Pairs &pairs)
    {
      Json result = Json::object();
      for (const auto &[name, value] : pairs)
        result[std::string(name)] = value;
      return result;
    }

    /** Return where friction was found to be beyond its critical value, and in which ways the path
     * could go on there. */
    Json
    critical_section(const Summary &summary)
    {
      const CriticalFriction &critical = summary.path.critical;
      Json elements                    = Json::array();
      for (const NamedElement &element : summary.critical_elements)
        {
          elements.push_back({{"joint", element.joint}, {"element", element.number}});
          for (std::size_t c = 0; c < element.position.size(); ++c)
            elements.back()[std::string(1, "xyz"[c])] = element.position[c];
        }
      return {{"t", critical.t},
              {"continuations", critical.n_branches},
              {"all_counted", critical.all_counted},
              {"determinant_signs", critical.determinant_signs},
              {"decisions", summary.path.n_non_unique},
              {"elements", elements}};
    }

    Json
    path_section(const Summary &summary)
    {
      const PathResult &path = summary.path;
      Json json;
      json["total"]          = summary.n_events;
      json["by_kind"]        = object(summary.events_by_kind);
      json["steps"]          = path.n_steps;
      json["implicit_steps"] = path.n_jumps;
      if (path.jump.found)
        json["jump"] = {{"t", path.jump.t},
                        {"size", path.jump.size},
                        {"released_energy", path.jump.released},
                        {"friction_work", path.jump.dissipated},
                        {"size_with_hundredth_of_load", path.jump.size_nearer},
                        {"followed", path.n_followed_jumps},
                        {"over_failures", path.n_failures}};
      if (path.jump.found && path.verdict == Verdict::no_continuation &&
          path.mechanism != MechanismKind::none)
        json["jump"].update(
          {{"mechanism", mechanism_name(path.mechanism)}, {"motion", summary.motion}});
      json["zero_length_steps"] = path.n_zero_steps;
      json["schemes_tried"]     = path.n_schemes;
      json["decided_by"]        = {{"block switching", path.n_decided_by[0]},
                                   {"single switching", path.n_decided_by[1]},
                                   {"Newton's method", path.n_decided_by[2]},
                                   {"search", path.n_decided_by[3]}};
      return json;
    }

    Json
    bodies_section(const BodiesWork &work)
    {
      Json json = {{"solver", name_of(work.solver)}};
      if (work.estimate)
        json["estimate"] = {{"direct_memory_MB", work.estimate->direct_megabytes},
                            {"direct_on_disk_memory_MB", work.estimate->on_disk_megabytes},
                            {"direct_seconds", work.estimate->direct_seconds},
                            {"iterative_memory_MB", work.estimate->iterative_megabytes},
                            {"iterative_seconds", work.estimate->iterative_seconds},
                            {"machine_memory_MB", work.estimate->available_megabytes},
                            {"choice", name_of(work.estimate->choice)}};
      return json;
    }

    Json
    work_section(const WorkSummary &work)
    {
      return {{"processes", work.bodies.n_processes},
              {"factorisations_of_bodies", work.bodies.n_factorisations},
              {"condensed_loads", work.bodies.n_condensed_loads},
              {"solutions_of_bodies", work.bodies.n_solutions},
              {"iterations_of_bodies", work.bodies.n_iterations},
              {"recovered_fields", work.bodies.n_recovered_fields},
              {"layered_systems", work.n_layered_systems},
              {"bars_ever_active", work.scheme.n_bars_ever_active},
              {"scheme_factorisations", work.scheme.n_factorisations},
              {"scheme_updates", work.scheme.n_updates}};
    }

    Json
    counted_section()
    {
      Json json;
      for (std::size_t i = 0; i < work::n_phases; ++i)
        {
          const work::Counts &counts                       = work::all()[i];
          json[work::name_of(static_cast<work::Phase>(i))] = {
            {"dense_operations", counts.dense_operations},
            {"accurate_operations", counts.accurate_operations},
            {"dense_factorisations", counts.dense_factorisations},
            {"dense_solutions", counts.dense_solutions},
            {"sparse_operations", counts.sparse_operations},
            {"sparse_columns", counts.sparse_columns},
            {"bytes_written", counts.bytes_written},
            {"cpu_seconds", counts.cpu_seconds}};
        }
      return json;
    }

    Json
    first_part(const RunSummary &summary, const Parameters &parameters)
    {
      Json json;
      json["program"]        = "fuga";
      json["title"]          = parameters.title;
      json["parameter_file"] = parameters.parameter_file;
      json["verdict"]        = summary.verdict;
      json["exit_code"]      = summary.exit_code;
      if (!summary.message.empty())
        json["message"] = summary.message;
      return json;
    }

    std::string
    with_last_part(Json json, const RunSummary &summary, const Parameters &parameters)
    {
      json["work"]                               = work_section(summary.work);
      json["work"]["counted"]                    = counted_section();
      json["work"]["bodies"]                     = bodies_section(summary.work.bodies);
      json["work"]["peak_memory_MB_after_phase"] = object(summary.peaks);
      json["seconds"]                            = object(summary.phases);
      json["memory_MB"]                          = summary.memory_MB;
      if (const std::vector<double> memory = processes::peak_memory(); !memory.empty())
        json["memory_of_processes_MB"] = memory;
      json["joints"]     = summary.split_report;
      json["warnings"]   = summary.warnings;
      json["versions"]   = {{"fuga", version}, {"deal.II", DEAL_II_PACKAGE_VERSION}};
      json["parameters"] = Json::parse(echo_json(parameters));
      return json.dump(2) + "\n";
    }
  } // namespace

  std::string
  summary_json(const Summary &summary, const Parameters &parameters)
  {
    Json json              = first_part(summary, parameters);
    json["t"]              = summary.t;
    json["stage"]          = summary.stage;
    json["stage_fraction"] = summary.stage_fraction;
    json["driven_by"]      = summary.drive.name;
    json["drive"]          = summary.drive.value;
    if (summary.path.verdict == Verdict::limit_load)
      json["limit_load"] = {{"t", summary.t},
                            {"stage", summary.stage},
                            {"stage_fraction", summary.stage_fraction},
                            {"load_factors", object(summary.load_factors)},
                            {"driven_by", summary.drive.name},
                            {"drive", summary.drive.value},
                            {"mechanism", mechanism_name(summary.path.mechanism)},
                            {"motion", summary.motion},
                            {"proof",
                             {{"error", summary.proof.mechanism.error()},
                              {"resistance", summary.proof.mechanism.resistance},
                              {"inadmissible", summary.proof.mechanism.inadmissible},
                              {"balance", summary.proof.mechanism.balance},
                              {"drive", summary.proof.mechanism.drive}}}};
    if (const BarrierCertificate &barrier = summary.proof.barrier; barrier.proves())
      json["no_continuation"] = {{"t", summary.t},
                                 {"stage", summary.stage},
                                 {"stage_fraction", summary.stage_fraction},
                                 {"load_factors", object(summary.load_factors)},
                                 {"proof",
                                  {{"error", barrier.error()},
                                   {"equilibrium", barrier.equilibrium},
                                   {"inadmissible", barrier.inadmissible},
                                   {"drive", barrier.drive},
                                   {"margin", barrier.margin()}}}};
    if (const BeyondLimit &beyond = summary.path.beyond; beyond.end != BeyondLimit::End::none)
      json["beyond_limit"] = {{"end", beyond_limit_end_name(beyond.end)},
                              {"path_length", beyond.length},
                              {"t", beyond.t},
                              {"steps", beyond.n_steps}};
    if (!summary.motion_steps.empty())
      json["motion"] = motion_section(summary.motion_energies, summary.motion_steps);
    if (!summary.continuations.empty())
      json["continuations"] = continuations_section(summary.continuations);
    if (!summary.safety.empty())
      json["safety"] = safety_section(summary.safety);
    if (!summary.accuracy.rounds.empty())
      json["accuracy"] = accuracy_section(summary.accuracy);
    if (!summary.critical_elements.empty())
      json["friction_beyond_critical"] = critical_section(summary);
    json["load_factors"] = object(summary.load_factors);
    json["sizes"]        = object(summary.sizes);
    json["events"]       = path_section(summary);
    json["iterations"]   = {{"solutions", summary.iterations.n_solutions},
                            {"iterations", summary.iterations.n_iterations},
                            {"largest_in_one_solution", summary.iterations.max_in_one}};
    json["certificate"]  = {{"worst", summary.certificate.worst()},
                            {"bound", summary.certificate_bound},
                            {"entries", object(summary.certificate.entries())}};
    return with_last_part(std::move(json), summary, parameters);
  }

  std::string
  summary_json(const SweepSummary &summary, const Parameters &parameters)
  {
    Json json             = first_part(summary, parameters);
    json["variants"]      = summary.n_variants;
    json["condensations"] = summary.n_condensations;
    json["verdicts"]      = object(summary.verdicts);
    json["sizes"]         = object(summary.sizes);
    json["events"]        = {{"total", summary.n_events},
                             {"steps", summary.n_steps},
                             {"implicit_steps", summary.n_jumps},
                             {"schemes_tried", summary.n_schemes}};
    json["iterations"]    = {{"iterations", summary.n_iterations}};
    json["certificate"]   = {{"worst", summary.worst_certificate},
                             {"bound", summary.certificate_bound}};
    return with_last_part(std::move(json), summary, parameters);
  }
} // namespace fuga

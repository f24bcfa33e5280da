// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_output_tables_summary_h
#define fuga_output_tables_summary_h

#include <fuga/bodies/condensed/condensed_system.h>
#include <fuga/bodies/program/driving_quantity.h>
#include <fuga/contact/dynamics/moving_bodies.h>
#include <fuga/contact/judge/limit_proof.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/contact/path/verdict_name.h>
#include <fuga/input/parameters.h>
#include <fuga/output/results/motion_beyond_limit.h>
#include <fuga/output/tables/accuracy_report.h>

#include <map>
#include <string>
#include <vector>

namespace fuga
{
  /** The words of summary.json and of the log. */
  std::string
  mechanism_name(const MechanismKind kind);
  std::string
  beyond_limit_end_name(const BeyondLimit::End end);

  /** A contact element as the user knows it. */
  struct NamedElement
  {
    std::string joint;
    unsigned int number = 0;
    /** As many coordinates as the model has dimensions. */
    std::vector<double> position;
  };

  /** What a search for a factor of safety found. */
  struct SafetyFactor
  {
    /** "strength reduction" or "load factor". */
    std::string method;
    /** The verdict that ended the search, or "largest factor reached", or "not computed". */
    std::string verdict;
    /** Factor at the end of the search: the factor of safety if equilibrium was lost there. */
    double factor = 1.;
    /** Load time at the end of the search. */
    double t                = 0.;
    MechanismKind mechanism = MechanismKind::none;
    /** Joints that the mechanism moves, and how: mechanism_text(). */
    std::vector<std::string> moving_joints;
    std::string motion;
    /** The joints that are reduced, the loads that grow. */
    std::vector<std::string> acts_on;

    static const char *const largest_factor_reached;
    static const char *const not_computed;

    bool
    found() const;
  };

  /** What was computed, by counts; see doc/results.md. */
  struct WorkSummary
  {
    BodiesWork bodies;
    /** Times bodies and layer were put in series, eq. 4. */
    std::size_t n_layered_systems = 0;
    /** Of a sweep: sums over the variants, and the most active bars of one. */
    SchemeWork scheme;
  };

  /** What the summaries of a run and of a sweep have in common. */
  struct RunSummary
  {
    std::string verdict;
    int exit_code = 0;
    /** Reason of a numerical failure. */
    std::string message;
    std::vector<std::pair<std::string, std::size_t>> sizes;
    WorkSummary work;
    double certificate_bound = 0.;
    std::vector<std::pair<std::string, double>> phases;
    double memory_MB = 0.;
    /** Peak memory behind the last use of every phase [MB]. */
    std::vector<std::pair<std::string, double>> peaks;
    std::vector<std::string> split_report;
    std::vector<std::string> warnings;
  };

  /** What summary.json says of a run; see doc/results.md. */
  struct Summary : RunSummary
  {
    /** Name of the stage and its fraction at t. */
    double t = 0.;
    std::string stage;
    double stage_fraction = 0.;
    /** What drives the stage, at t. */
    DrivingQuantity drive;
    /** The mechanism of a limit load in words: mechanism_text(). */
    std::string motion;
    /** What proves the limit load, or that there is no continuation. */
    LimitProof proof;
    /** Factors of the load patterns at t, by load name. */
    std::map<std::string, double> load_factors;

    std::map<std::string, std::size_t> events_by_kind;
    std::size_t n_events = 0;
    PathResult path;
    /** The elements of PathResult::critical. */
    std::vector<NamedElement> critical_elements;
    std::vector<SafetyFactor> safety;
    AccuracyReport accuracy;
    IterationCount iterations;
    Certificate certificate;
    /** RunRecord::motion_energies, motion_steps and continuations. */
    MotionLedger motion_energies;
    std::vector<std::size_t> motion_steps;
    std::vector<MotionBeyondLimit> continuations;
  };

  /** What it says of a sweep. */
  struct SweepSummary : RunSummary
  {
    std::size_t n_variants = 0;
    /** Times the bodies were condensed for them. */
    std::size_t n_condensations = 0;
    /** Variants by verdict. */
    std::map<std::string, std::size_t> verdicts;
    std::size_t n_events     = 0;
    std::size_t n_steps      = 0;
    std::size_t n_jumps      = 0;
    std::size_t n_schemes    = 0;
    std::size_t n_iterations = 0;
    double worst_certificate = 0.;
  };

  std::string
  summary_json(const Summary &summary, const Parameters &parameters);
  std::string
  summary_json(const SweepSummary &summary, const Parameters &parameters);
} // namespace fuga

#endif

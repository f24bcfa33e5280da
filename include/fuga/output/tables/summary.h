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
  /** Return the word used in summary.json and in the log. */
  std::string
  mechanism_name(const MechanismKind kind);
  std::string
  beyond_limit_end_name(const BeyondLimit::End end);

  /** A contact element in the terms of the user. */
  struct NamedElement
  {
    std::string joint;
    unsigned int number = 0;
    /** Position, with as many coordinates as the model has dimensions. */
    std::vector<double> position;
  };

  /** The result of a search for a factor of safety. */
  struct SafetyFactor
  {
    /** Method of the search: "strength reduction" or "load factor". */
    std::string method;
    /** The verdict that ended the search, or "largest factor reached", or "not computed". */
    std::string verdict;
    /** Factor at the end of the search: the factor of safety if equilibrium was lost there. */
    double factor = 1.;
    /** Load time at the end of the search. */
    double t                = 0.;
    MechanismKind mechanism = MechanismKind::none;
    /** Joints that the mechanism moves, and their motion, see mechanism_text(). */
    std::vector<std::string> moving_joints;
    std::string motion;
    /** The joints whose strength is reduced, or the loads that grow. */
    std::vector<std::string> acts_on;

    static const char *const largest_factor_reached;
    static const char *const not_computed;

    bool
    found() const;
  };

  /** Counts of the work done, see doc/results.md. */
  struct WorkSummary
  {
    BodiesWork bodies;
    /** Number of times that bodies and layer were put in series, eq. 4. */
    std::size_t n_layered_systems = 0;
    /** For a sweep: sums over the variants, and the most active bars of a single variant. */
    SchemeWork scheme;
  };

  /** The common part of the summaries of a run and of a sweep. */
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
    /** Peak memory after the last use of every phase [MB]. */
    std::vector<std::pair<std::string, double>> peaks;
    std::vector<std::string> split_report;
    std::vector<std::string> warnings;
  };

  /** The contents of summary.json for a run, see doc/results.md. */
  struct Summary : RunSummary
  {
    /** Name of the stage and its fraction at t. */
    double t = 0.;
    std::string stage;
    double stage_fraction = 0.;
    /** The quantity that drives the stage, at t. */
    DrivingQuantity drive;
    /** The mechanism of a limit load in words, see mechanism_text(). */
    std::string motion;
    /** The proof of the limit load, or of the fact that there is no continuation. */
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
    /** See RunRecord::motion_energies, motion_steps and continuations. */
    MotionLedger motion_energies;
    std::vector<std::size_t> motion_steps;
    std::vector<MotionBeyondLimit> continuations;
  };

  /** The contents of summary.json for a sweep. */
  struct SweepSummary : RunSummary
  {
    std::size_t n_variants = 0;
    /** Number of times that the bodies were condensed for them. */
    std::size_t n_condensations = 0;
    /** Numbers of variants by verdict. */
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

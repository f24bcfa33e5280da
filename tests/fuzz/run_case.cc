// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include "fuzz/run_case.h"

#include "fuzz/mutator.h"

#include <fuga/base/errors.h>
#include <fuga/bodies/dynamics/time_steps.h>
#include <fuga/input/read/read_parameters.h>
#include <fuga/run/simulation/simulation.h>
#include <fuga/study/model_check.h>
#include <fuga/study/sweep.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fuga::fuzz
{
  namespace
  {
    std::string
    file_text(const std::filesystem::path &path)
    {
      std::ifstream file(path, std::ios::binary);
      std::stringstream text;
      text << file.rdbuf();
      return text.str();
    }

    double
    number_of_time_steps(const ModelDefinition &model)
    {
      double n = 0.;
      for (const StageDefinition &stage : model.stages)
        if (stage.is_dynamic())
          n += fuga::number_of_time_steps(model.dynamics, stage);
      return n;
    }

    /** Refined meshes of a million cells are no mistake, but they take their time. */
    bool
    is_small_model(const Parameters &parameters)
    {
      return parameters.model.refinements <= 1 && parameters.model.load_knots <= 2000 &&
             parameters.variants.size() <= 200 && number_of_time_steps(parameters.model) <= 2000.;
    }

    bool
    is_small_run(const Parameters &parameters)
    {
      unsigned int n_levels = 0;
      for (const StageDefinition &stage : parameters.model.stages)
        n_levels += std::min(stage.levels, 1000u);
      return n_levels <= 20 && number_of_time_steps(parameters.model) <= 50. &&
             parameters.model.load_knots <= 20 && parameters.variants.size() <= 6 &&
             parameters.solver.maximum_iterations <= 1000;
    }

    template <int dim>
    void
    run_model(const Parameters &parameters, const Reach reach, CaseResult &result)
    {
      if (reach != Reach::run || !is_small_run(parameters))
        {
          check_model<dim>(parameters);
          return;
        }
      result.was_run = true;
      result.exit_code =
        static_cast<int>(parameters.of_sweep ? Sweep<dim>(parameters).run()
                                             : Simulation<dim>(Model<dim>(parameters)).run());
    }

    void
    check_message(CaseResult &result)
    {
      // Every message names a file, a line, an entry or a place, and says what to do.
      if (result.message.size() < 30)
        result.complaint = "the message says too little: " + result.message;
      // Several messages may come together, one in a line.
      std::istringstream lines(result.message);
      for (std::string line; std::getline(lines, line);)
        if (line.size() > 4000)
          result.complaint = "the message is too long: " + line;
    }
  } // namespace

  std::vector<Seed>
  read_seeds(const std::string &directory)
  {
    std::vector<std::filesystem::path> files;
    for (const auto &entry : std::filesystem::directory_iterator(directory))
      if (entry.path().extension() != ".msh")
        files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<Seed> seeds;
    for (const auto &path : files)
      {
        Seed seed;
        seed.parameter_name = path.filename();
        seed.parameters     = file_text(path);
        // The mesh is called like the first word of the parameter file.
        const std::string stem = path.stem();
        seed.mesh_name         = stem.substr(0, stem.find('_')) + ".msh";
        seed.mesh              = file_text(std::filesystem::path(directory) / seed.mesh_name);
        seeds.push_back(seed);
      }
    return seeds;
  }

  Seed
  make_case(const std::vector<Seed> &seeds,
            const std::uint64_t campaign,
            const std::uint64_t number)
  {
    if (number < seeds.size())
      return seeds[number];
    campaign::Random random("fuzz " + std::to_string(campaign), number);
    Seed result = seeds[random.bits() % seeds.size()];
    std::vector<std::string> parameters, meshes;
    for (const Seed &seed : seeds)
      {
        parameters.push_back(seed.parameters);
        meshes.push_back(seed.mesh);
      }
    const unsigned int n = random.chance(0.6) ? 1 : random.integer(2, 6);
    for (unsigned int i = 0; i < n; ++i)
      if (random.chance(0.5))
        result.parameters = mutate(result.parameters, random, parameters);
      else
        result.mesh = mutate(result.mesh, random, meshes);
    return result;
  }

  CaseResult
  run_case(const Seed &files, const std::string &directory, const Reach reach)
  {
    CaseResult result;
    const std::string name = directory + '/' + files.parameter_name;
    std::ofstream(name, std::ios::binary) << files.parameters;
    std::ofstream(directory + '/' + files.mesh_name, std::ios::binary) << files.mesh;
    try
      {
        Parameters parameters       = read_parameters(name);
        parameters.output.directory = directory + "/out";
        if (!is_small_model(parameters))
          {
            result.message = "large";
            return result;
          }
        if (parameters.model.dimension == 3)
          run_model<3>(parameters, reach, result);
        else
          run_model<2>(parameters, reach, result);
      }
    catch (const InputError &error)
      {
        result.exit_code = 1;
        result.was_run   = false;
        result.message   = error.what();
        check_message(result);
      }
    catch (const NumericalFailure &error)
      {
        result.exit_code = 2;
        result.message   = error.what();
        check_message(result);
      }
    catch (const std::exception &error)
      {
        result.exit_code = 2;
        result.message   = error.what();
        result.complaint = "an exception that nobody put into words: " + result.message;
      }
    return result;
  }
} // namespace fuga::fuzz

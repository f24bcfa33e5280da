// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/base/process_info.h>
#include <fuga/bodies/processes.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

namespace fuga
{
  namespace
  {
    struct State
    {
      int number = 1, rank = 0;
      /** Communicator for MUMPS, so that its messages are not taken for those of this program. */
      MPI_Comm others = MPI_COMM_NULL;
      bool separated  = false;
      std::vector<double> memory;
    };

    State &
    state()
    {
      static State the_state;
      return the_state;
    }

    void
    finalise_mpi()
    {
      if (!processes::have_ended())
        MPI_Finalize();
    }

    void
    initialise_mpi()
    {
      int initialised = 0;
      MPI_Initialized(&initialised);
      if (initialised)
        return;
      MPI_Init(nullptr, nullptr);
      std::atexit(finalise_mpi);
    }

    /** Return whether a launcher is present: Open MPI's mpirun, or one that uses PMIx or PMI. */
    bool
    has_launcher()
    {
      for (const char *variable : {"OMPI_COMM_WORLD_SIZE", "PMIX_RANK", "PMI_RANK"})
        if (std::getenv(variable) != nullptr)
          return true;
      return false;
    }

    /** Call @p action for portions of n, since MPI counts by int. */
    template <typename Action>
    void
    in_portions(const std::size_t n, const Action &action)
    {
      constexpr std::size_t portion = std::size_t(1) << 24;
      for (std::size_t begin = 0; begin < n; begin += portion)
        action(begin, static_cast<int>(std::min(portion, n - begin)));
    }
  } // namespace


  void
  processes::join()
  {
    if (!has_launcher())
      return;
    // A process that waits while the first one works alone leaves its core to others.
    setenv("OMPI_MCA_mpi_yield_when_idle", "1", 0);
    initialise_mpi();
    State &all = state();
    MPI_Comm_size(MPI_COMM_WORLD, &all.number);
    MPI_Comm_rank(MPI_COMM_WORLD, &all.rank);
    if (all.number == 1)
      return;
    MPI_Comm_dup(MPI_COMM_WORLD, &all.others);
    if (!is_first() && std::freopen("/dev/null", "w", stdout) == nullptr)
      throw NumericalFailure("/dev/null cannot be opened.");
  }


  int
  processes::leave(const int code, const std::string &complaint)
  {
    if (number() == 1)
      {
        if (!complaint.empty())
          fmt::print(stderr, "{}", complaint);
        return code;
      }
    try
      {
        meet(Place::end);
      }
    catch (const Separated &)
      {
      }
    const std::array<int, 2> mine = {{code, complaint.empty() ? 0 : 1}};
    std::vector<std::array<int, 2>> all(number());
    MPI_Allgather(mine.data(), 2, MPI_INT, all.data(), 2, MPI_INT, MPI_COMM_WORLD);
    const auto speaker =
      std::find_if(all.begin(), all.end(), [](const auto &of_one) { return of_one[1] != 0; });
    const auto judge =
      std::find_if(all.begin(), all.end(), [](const auto &of_one) { return of_one[0] != no_code; });
    if (speaker - all.begin() == state().rank)
      fmt::print(stderr, "{}", complaint);
    else if (speaker == all.end() && is_first() && code == no_code)
      fmt::print(stderr, "Failure: the processes of the run did not do the same.\n");
    std::fflush(stderr);
    finalise_mpi();
    return judge == all.end() ? no_code : (*judge)[0];
  }


  unsigned int
  processes::number()
  {
    return static_cast<unsigned int>(state().number);
  }


  unsigned int
  processes::rank()
  {
    return static_cast<unsigned int>(state().rank);
  }


  bool
  processes::have_terminal()
  {
    return isatty(STDOUT_FILENO) != 0 && !has_launcher();
  }


  void
  processes::meet(const Place place, const std::size_t amount)
  {
    State &all = state();
    if (all.number == 1)
      return;
    if (all.separated)
      throw Separated();
    using Entry      = std::array<double, 3>; // integers up to 2^53 are exact
    const Entry mine = {
      {static_cast<double>(place), static_cast<double>(amount), peak_memory_in_megabytes()}};
    std::vector<Entry> entries(number());
    MPI_Allgather(mine.data(), 3, MPI_DOUBLE, entries.data(), 3, MPI_DOUBLE, MPI_COMM_WORLD);
    all.memory.clear();
    for (const Entry &entry : entries)
      {
        all.memory.push_back(entry[2]);
        all.separated = all.separated || entry[0] != mine[0] || entry[1] != mine[1];
      }
    if (all.separated)
      throw Separated();
  }


  // A sum over all processes at once may be rounded differently on each of them, so the first one
  // adds.
  void
  processes::sum(double *values, const std::size_t n)
  {
    if (number() == 1)
      return;
    meet(Place::sum, n);
    in_portions(n, [&](const std::size_t begin, const int count) {
      double *const at = values + begin;
      if (is_first())
        MPI_Reduce(MPI_IN_PLACE, at, count, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
      else
        MPI_Reduce(at, nullptr, count, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
      MPI_Bcast(at, count, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    });
  }


  void
  processes::sum(Vector &values)
  {
    sum(values.data(), values.size());
  }


  void
  processes::broadcast(double *values, const std::size_t n)
  {
    if (number() == 1)
      return;
    meet(Place::broadcast, n);
    in_portions(n, [&](const std::size_t begin, const int count) {
      MPI_Bcast(values + begin, count, MPI_DOUBLE, 0, MPI_COMM_WORLD);
    });
  }


  std::vector<std::size_t>
  processes::from_all(const std::size_t n)
  {
    std::vector<std::size_t> result(number(), n);
    if (number() == 1)
      return result;
    meet(Place::gather);
    MPI_Allgather(&n, sizeof(n), MPI_BYTE, result.data(), sizeof(n), MPI_BYTE, MPI_COMM_WORLD);
    return result;
  }


  void
  processes::gather(const void *mine,
                    const std::vector<std::size_t> &numbers,
                    const std::size_t size,
                    void *all)
  {
    const std::vector<int> counts(numbers.begin(), numbers.end());
    std::vector<int> offsets(counts.size(), 0);
    std::partial_sum(counts.begin(), counts.end() - 1, offsets.begin() + 1);
    MPI_Datatype type;
    MPI_Type_contiguous(static_cast<int>(size), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    MPI_Allgatherv(
      mine, counts[rank()], type, all, counts.data(), offsets.data(), type, MPI_COMM_WORLD);
    MPI_Type_free(&type);
  }


  std::vector<double>
  processes::peak_memory()
  {
    return state().memory;
  }


  int
  processes::fortran_communicator()
  {
    if (number() > 1)
      return MPI_Comm_c2f(state().others);
    // A program that no launcher started has nobody to communicate with, so no network is opened.
    if (!has_launcher())
      {
        setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
        setenv("OMPI_MCA_btl", "self", 0);
        setenv("OMPI_MCA_pml", "ob1", 0);
        // Runs that begin and end at the same time would delete each other's session directories.
        setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
      }
    initialise_mpi();
    return MPI_Comm_c2f(MPI_COMM_SELF);
  }


  bool
  processes::have_ended()
  {
    int finalised = 0;
    MPI_Finalized(&finalised);
    return finalised != 0;
  }
} // namespace fuga

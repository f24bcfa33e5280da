// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_processes_h
#define fuga_bodies_processes_h

#include <fuga/base/numerics/dense_matrix.h>

#include <exception>
#include <numeric>
#include <string>
#include <type_traits>
#include <vector>

namespace fuga
{
  /**
   * The processes that mpirun started for one run; a single one without mpirun, in which case
   * nothing here costs anything or touches MPI.
   *
   * All processes do the same in the same order: each reads the input, builds the tables of the
   * mesh and follows the contact path. The data of the bodies are divided among them by cells and
   * assembled by the functions below, which all processes have to call alike. They *meet* at the
   * beginning of every such function, so that if a process deviates because of an error of its own,
   * the others notice this instead of waiting for it.
   */
  namespace processes
  {
    /** The operations that processes do together. */
    enum class Place
    {
      begin,
      sum,
      broadcast,
      gather,
      mesh,
      solver,
      fields,
      end
    };

    /** Exception thrown where processes should meet if one of them is elsewhere. */
    class Separated : public std::exception
    {
    public:
      const char *
      what() const noexcept override
      {
        return "another process left the run";
      }
    };

    /**
     * Join the other processes if a launcher of MPI programs started this one; to be called first
     * in the program. All processes except for the first are silent from then on: their output is
     * discarded.
     */
    void
    join();

    /**
     * Leave the run; to be called last, with the exit code of this process (no_code after
     * Separated) and its error message. This function prints the message, once for all processes,
     * waits for the others and returns the exit code of the run, which is that of the first process
     * that has one.
     */
    int
    leave(const int code, const std::string &complaint);

    constexpr int no_code = -1;

    unsigned int
    number();

    unsigned int
    rank();

    /** Return whether this is the process that writes files and messages. */
    inline bool
    is_first()
    {
      return rank() == 0;
    }

    /**
     * Return whether the output of this process goes to a terminal. Launchers make every process
     * believe so; therefore the answer is no if there is one.
     */
    bool
    have_terminal();

    /**
     * Check that all processes are at the same place; @p amount has to be the same on all of them.
     * @throws Separated
     */
    void
    meet(const Place place, const std::size_t amount = 0);

    /**
     * Replace values by their sums over all processes; the results are identical on all, bit by
     * bit.
     */
    void
    sum(double *values, const std::size_t n);
    void
    sum(Vector &values);

    /** Send the values of the first process to all others. */
    void
    broadcast(double *values, const std::size_t n);

    /** Return the values of @p n on all processes, by process. */
    std::vector<std::size_t>
    from_all(const std::size_t n);

    /**
     * Concatenate the items of @p size bytes of all processes in the order of the processes; the
     * result is the same on all. @p numbers are the numbers of items on each process, see
     * from_all().
     */
    void
    gather(const void *mine,
           const std::vector<std::size_t> &numbers,
           const std::size_t size,
           void *all);

    /** Return the items of all processes, those of the first one first. */
    template <typename T>
    std::vector<T>
    gather(std::vector<T> mine)
    {
      static_assert(std::is_trivially_copyable_v<T>);
      if (number() == 1)
        return mine;
      const std::vector<std::size_t> numbers = from_all(mine.size());
      std::vector<T> all(std::accumulate(numbers.begin(), numbers.end(), std::size_t(0)));
      gather(mine.data(), numbers, sizeof(T), all.data());
      return all;
    }

    /**
     * Return the peak memory of every process at their last meeting [MB]; empty if there is only
     * one.
     */
    std::vector<double>
    peak_memory();

    /**
     * Return MPI's Fortran handle of a communicator for purposes other than the functions above: of
     * all processes, or of this one alone. Starts MPI if it has not been started.
     */
    int
    fortran_communicator();

    /**
     * Return whether MPI has been finalised, so that nothing that belongs to it can be released any
     * more.
     */
    bool
    have_ended();
  } // namespace processes
} // namespace fuga

#endif

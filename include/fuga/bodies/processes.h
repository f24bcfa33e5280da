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
   * The processes that mpirun started for one run; one if there was no mpirun, and then nothing
   * here costs anything or touches MPI.
   *
   * All processes do the same in the same order: each reads the input, builds the tables of the
   * mesh and follows the contact path. What the bodies need is divided among them by cells and put
   * together by the functions below, which all processes have to call alike. They *meet* at
   * the beginning of every such function, so that a process that left the common way by an error
   * of its own is noticed by the others instead of waited for.
   */
  namespace processes
  {
    /** What processes do together. */
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

    /** Thrown where processes should meet, if one of them is elsewhere. */
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
     * To be called first in the program: joins the others if a launcher of MPI programs started
     * this process. All but the first are silent from then on: what they print is lost.
     */
    void
    join();

    /**
     * To be called last, with the exit code of this process (no_code behind Separated) and what it
     * has to complain of: says it, once for all processes, waits for the others and returns the
     * exit code of the run, that of the first process that has one.
     */
    int
    leave(const int code, const std::string &complaint);

    constexpr int no_code = -1;

    unsigned int
    number();

    unsigned int
    rank();

    /** Whether this is the process that writes and speaks. */
    inline bool
    is_first()
    {
      return rank() == 0;
    }

    /** Whether what this process prints goes to a terminal. Launchers make every process believe
     * so: no, if there is one. */
    bool
    have_terminal();

    /** @p amount has to be the same on all processes. @throws Separated */
    void
    meet(const Place place, const std::size_t amount = 0);

    /** Replaces values by their sums over all processes; the same on all, bit by bit. */
    void
    sum(double *values, const std::size_t n);
    void
    sum(Vector &values);

    /** Gives the values of the first process to all. */
    void
    broadcast(double *values, const std::size_t n);

    /** What every process gives for @p n, by process. */
    std::vector<std::size_t>
    from_all(const std::size_t n);

    /** Puts things of @p size bytes behind those of the processes before, the same on all; @p numbers:
     *  how many each has, from_all(). */
    void
    gather(const void *mine,
           const std::vector<std::size_t> &numbers,
           const std::size_t size,
           void *all);

    /** The things of all processes, those of the first one first. */
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

    /** Peak memory of every process when they met last [MB]; empty if there is only one. */
    std::vector<double>
    peak_memory();

    /** MPI's handle, for Fortran, of a communicator for others than the functions above: all
     * processes, or this one alone. Starts MPI if nobody did. */
    int
    fortran_communicator();

    /** MPI has been finalised: nothing that belongs to it can be given back any more. */
    bool
    have_ended();
  } // namespace processes
} // namespace fuga

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_bodies_space_hanging_nodes_h
#define fuga_bodies_space_hanging_nodes_h

#include <fuga/base/numerics/dense_matrix.h>

#include <map>
#include <utility>
#include <vector>

namespace dealii
{
  template <int dim, int spacedim>
  class DoFHandler;
}

namespace fuga
{
  /**
   * The nodes of small cells on the face of a larger neighbour. They move with the nodes of that
   * face: u = Σ w_k u_k, the same for every direction. Forces on them are moved to these *masters*
   * with the same weights. No master is itself a hanging node. (doc/theory.md, section 1)
   */
  template <int dim>
  class HangingNodes
  {
  public:
    /** Master nodes with their weights. */
    using Masters = std::vector<std::pair<unsigned int, double>>;

    /** Create a table without hanging nodes. */
    HangingNodes() = default;

    /**
     * @p node_of_dof is the node of which this is the first degree of freedom; for other degrees of
     * freedom, and for those of no node, it is not below @p n_nodes. The data of all processes are
     * put together.
     */
    HangingNodes(const dealii::DoFHandler<dim, dim> &dofs,
                 const std::vector<unsigned int> &node_of_dof,
                 const unsigned int n_nodes);

    const std::map<unsigned int, Masters> &
    masters() const
    {
      return all_masters;
    }

    bool
    contain(const unsigned int node) const
    {
      return all_masters.count(node) > 0;
    }

    /** Move forces (entry node * dim + component) from hanging nodes to their masters. */
    void
    move_to_masters(Vector &forces) const;

  private:
    std::map<unsigned int, Masters> all_masters;
  };
} // namespace fuga

#endif

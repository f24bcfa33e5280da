// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <deal.II/base/numbers.h>

#include <fuga/base/errors.h>
#include <fuga/base/numerics/eigenpairs.h>
#include <fuga/bodies/elasticity/elastic_bodies.h>
#include <fuga/bodies/motion/modal_basis.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace fuga
{
  namespace
  {
    /** Eigenvalues below this share of the largest one are zero up to rounding. */
    constexpr double digits = 1e-12;

    /** The flexibility M^½ K⁻¹ M^½ of the bonded bodies on the degrees of freedom that have mass.
     * Its eigenvalues are 1/ω². */
    template <int dim>
    class BondedFlexibility
    {
    public:
      BondedFlexibility(const CondensedSystem<dim> &bodies, const Vector &mass) : model(bodies)
      {
        for (unsigned int dof = 0; dof < mass.size(); ++dof)
          if (mass[dof] > 0.)
            {
              dofs.push_back(dof);
              roots.push_back(std::sqrt(mass[dof]));
            }
      }

      std::size_t
      size() const
      {
        return dofs.size();
      }

      std::size_t
      n_dofs() const
      {
        return model.discretization().n_dofs();
      }

      /** Return K⁻¹ M^½ applied to @p columns, by nodes. */
      DenseMatrix
      displacements(const DenseMatrix &columns) const
      {
        DenseMatrix u(n_dofs(), columns.cols());
        for (Eigen::Index j = 0; j < columns.cols(); ++j)
          for (std::size_t i = 0; i < dofs.size(); ++i)
            u(dofs[i], j) = roots[i] * columns(i, j);
        model.solve_bonded(u);
        return u;
      }

      /** Return M^½ applied to fields by nodes. */
      DenseMatrix
      weighted(const DenseMatrix &fields) const
      {
        DenseMatrix result(dofs.size(), fields.cols());
        for (Eigen::Index j = 0; j < fields.cols(); ++j)
          for (std::size_t i = 0; i < dofs.size(); ++i)
            result(i, j) = roots[i] * fields(dofs[i], j);
        return result;
      }

    private:
      const CondensedSystem<dim> &model;
      std::vector<unsigned int> dofs;
      Vector roots;
    };

    /** Call action(first, end) for groups of columns, since one pass over the factors can serve
     * several columns. */
    template <typename Action>
    void
    by_pieces(const std::size_t n_columns, const Action &action)
    {
      constexpr std::size_t at_once = 32;
      for (std::size_t first = 0; first < n_columns; first += at_once)
        action(first, std::min(first + at_once, n_columns));
    }

    /** Return the pairs with values of at least @p smallest, or only the first one where @p one is
     * wanted. */
    Eigenpairs
    at_least(const double smallest, Eigenpairs pairs, const bool one)
    {
      const auto end = std::find_if(pairs.values.begin() + (one ? 1 : 0),
                                    pairs.values.end(),
                                    [&](const double value) { return value < smallest; });
      pairs.values.erase(end, pairs.values.end());
      pairs.vectors.conservativeResize(Eigen::NoChange, pairs.values.size());
      return pairs;
    }

    void
    append(const Eigenpairs &more, Eigenpairs &pairs)
    {
      pairs.vectors.conservativeResize(more.vectors.rows(),
                                       pairs.vectors.cols() + more.vectors.cols());
      pairs.vectors.rightCols(more.vectors.cols()) = more.vectors;
      pairs.values.insert(pairs.values.end(), more.values.begin(), more.values.end());
    }

    template <int dim>
    Eigenpairs
    all_pairs(const BondedFlexibility<dim> &flexibility)
    {
      const std::size_t n = flexibility.size();
      DenseMatrix matrix(n, n);
      by_pieces(n, [&](const std::size_t first, const std::size_t end) {
        matrix.middleCols(first, end - first) = flexibility.weighted(
          flexibility.displacements(DenseMatrix::Identity(n, n).middleCols(first, end - first)));
      });
      return eigenpairs(std::move(matrix));
    }

    /** Find the pairs by Lanczos iterations, each applied to what the one before has left, until
     * nothing remains: an iteration from one vector may miss modes of the same frequency. */
    template <int dim>
    Eigenpairs
    pairs_from(const double smallest, const BondedFlexibility<dim> &flexibility)
    {
      constexpr std::size_t small = 300, most = 1500;
      const std::size_t n = flexibility.size();
      Eigenpairs found;
      std::size_t wanted = 20;
      while (true)
        {
          if (n <= small || (n <= most && 3 * (found.values.size() + wanted) > n))
            return all_pairs(flexibility);
          if (found.values.size() > most)
            throw InputError(fmt::format("Dynamics/Highest frequency: more than {} normal modes "
                                         "are below it. Take a lower one, "
                                         "or Dynamics/Bodies = finite elements.",
                                         most));
          const Eigenpairs batch = largest_eigenpairs(n, wanted, [&](const Vector &x) {
            DenseMatrix column(n, 1);
            std::copy(x.begin(), x.end(), column.data());
            const DenseMatrix image = flexibility.weighted(flexibility.displacements(column));
            Vector y(image.data(), image.data() + n);
            if (found.values.empty())
              return y;
            Vector amounts = multiply_transposed(found.vectors, x);
            for (std::size_t k = 0; k < amounts.size(); ++k)
              amounts[k] *= found.values[k];
            add_multiple(-1., multiply(found.vectors, amounts), y);
            return y;
          });
          const Eigenpairs more  = at_least(smallest, batch, found.values.empty());
          if (more.values.empty())
            return found;
          append(more, found);
          wanted = more.values.size() < wanted ? 1 : 2 * wanted;
        }
    }

    /** Return Φ by nodes, including those without mass. */
    template <int dim>
    DenseMatrix
    shapes_of(const Eigenpairs &modes, const BondedFlexibility<dim> &flexibility)
    {
      DenseMatrix result(flexibility.n_dofs(), modes.values.size());
      by_pieces(modes.values.size(), [&](const std::size_t first, const std::size_t end) {
        const DenseMatrix u =
          flexibility.displacements(modes.vectors.middleCols(first, end - first));
        for (std::size_t k = first; k < end; ++k)
          result.col(k) = u.col(k - first) / modes.values[k];
      });
      return result;
    }

    /** Return L: the imbalance that the modes leave at the lips is their inertia. */
    template <int dim>
    DenseMatrix
    coupling_of(const CondensedSystem<dim> &model, const ModalBasis &basis)
    {
      const std::size_t m = model.n_coordinates();
      DenseMatrix L(basis.squares.size(), m);
      for (std::size_t k = 0; k < basis.squares.size(); ++k)
        {
          const Vector shape = to_vector(basis.shapes.col(k));
          Vector inertia     = shape;
          for (std::size_t dof = 0; dof < inertia.size(); ++dof)
            inertia[dof] *= basis.squares[k] * basis.mass[dof];
          const Vector at_lips = model.out_of_balance(inertia, shape);
          for (std::size_t c = 0; c < m; ++c)
            L(k, c) = at_lips[at_lips.size() - m + c] / basis.squares[k];
        }
      return L;
    }

    /** Return M^½ (Ψ - ΦL). */
    template <int dim>
    DenseMatrix
    static_less_modes(const CondensedSystem<dim> &model,
                      const BondedFlexibility<dim> &flexibility,
                      const ModalBasis &basis)
    {
      const auto &coordinates = model.interface_coordinates();
      const std::size_t m     = model.n_coordinates();
      DenseMatrix result(flexibility.size(), m);
      by_pieces(m, [&](const std::size_t begin, const std::size_t end) {
        DenseMatrix lips(basis.mass.size(), end - begin), fields = lips;
        for (std::size_t j = begin; j < end; ++j)
          {
            Vector y(coordinates.size(), 0.);
            y[y.size() - m + j]   = 1.;
            const Vector u        = coordinates.distribute(y.data(), {});
            const Vector Ku       = model.elastic_bodies().forces(u);
            lips.col(j - begin)   = view(u);
            fields.col(j - begin) = -view(Ku);
          }
        model.solve_bonded(fields);
        const DenseMatrix modes =
          multiply(basis.shapes, basis.coupling.middleCols(begin, end - begin));
        fields += lips - modes;
        result.middleCols(begin, end - begin) = flexibility.weighted(fields);
      });
      return result;
    }

    /** Find R and its axes. */
    void
    diagonalise(const DenseMatrix &rest, ModalBasis &basis)
    {
      basis.residual_mass     = multiply_transposed(rest, rest);
      const Eigenpairs axes   = eigenpairs(basis.residual_mass);
      basis.axes              = axes.vectors;
      basis.masses_along_axes = axes.values;
      const double largest    = largest_diagonal(basis.residual_mass) +
                             largest_diagonal(multiply_transposed(basis.coupling, basis.coupling));
      for (double &value : basis.masses_along_axes)
        if (value <= digits * largest)
          value = 0.;
    }
  } // namespace


  template <int dim>
  ModalBasis
  make_modal_basis(const CondensedSystem<dim> &model,
                   const Vector &mass,
                   const double highest_frequency)
  {
    ModalBasis basis;
    basis.mass              = mass;
    basis.highest_frequency = highest_frequency;
    const BondedFlexibility<dim> flexibility(model, mass);
    const double highest = 2. * dealii::numbers::PI * highest_frequency;
    if (flexibility.size() == 0)
      throw InputError(
        "Dynamics/Bodies = modes: no body has inertia. Give those that may move their "
        "weight density.");
    const Eigenpairs pairs = pairs_from(1. / (highest * highest), flexibility);
    const Eigenpairs modes =
      at_least(std::max(1. / (highest * highest), digits * pairs.values.front()), pairs, true);

    basis.shapes = shapes_of(modes, flexibility);
    for (const double value : modes.values)
      basis.squares.push_back(1. / value);
    basis.coupling = coupling_of(model, basis);

    diagonalise(static_less_modes(model, flexibility, basis), basis);
    return basis;
  }


  std::string
  describe(const ModalBasis &basis, const unsigned int dim)
  {
    const auto hertz = [](const double square) {
      return std::sqrt(square) / (2. * dealii::numbers::PI);
    };
    std::string shares;
    for (unsigned int c = 0; c < dim; ++c)
      {
        double all = 0., of_modes = 0.;
        Vector along(basis.mass.size(), 0.);
        for (std::size_t dof = c; dof < along.size(); dof += dim)
          all += along[dof] = basis.mass[dof];
        for (const double amount : multiply_transposed(basis.shapes, along))
          of_modes += amount * amount;
        if (all > 0.)
          shares += fmt::format("{}{:.3g} % of the mass along {}",
                                shares.empty() ? "" : ", ",
                                100. * of_modes / all,
                                "xyz"[c]);
      }
    return fmt::format("{} normal modes with the joints bonded, from {:.4g} to {:.4g} Hz: {}",
                       basis.squares.size(),
                       hertz(basis.squares.front()),
                       hertz(basis.squares.back()),
                       shares);
  }


  template ModalBasis
  make_modal_basis(const CondensedSystem<2> &, const Vector &, const double);
  template ModalBasis
  make_modal_basis(const CondensedSystem<3> &, const Vector &, const double);
} // namespace fuga

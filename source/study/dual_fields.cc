// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/bodies/field_expression.h>
#include <fuga/run/model/joint_model.h>
#include <fuga/study/dual_fields.h>

#include <deal.II/lac/vector.h>

#include <algorithm>

namespace fuga
{
  namespace
  {
    using Quantity = AccuracyTarget::Quantity;

    /** Return the jump of the bars of a joint whose work is N, T or M (as 0, 1, 2), if the joint is
     * straight. */
    Vector
    unit_jump_in_plane(const std::vector<ContactElement> &elements,
                       const std::vector<ElementFrame> &frames,
                       const unsigned int joint,
                       const unsigned int component,
                       const std::size_t n_bars)
    {
      Vector jump(n_bars, 0.);
      const auto first =
        std::find_if(elements.begin(), elements.end(), [joint](const auto &element) {
          return element.joint == joint;
        });
      for (std::size_t k = 0; k < elements.size(); ++k)
        {
          const ContactElement &element = elements[k];
          if (element.joint != joint)
            continue;
          if (component == 1 && element.has_tangential_bar())
            jump[element.tangential_bar] = 1.;
          else if (component == 0)
            jump[element.normal_bar] = 1.;
          else if (component == 2)
            jump[element.normal_bar] =
              (element.position[0] - first->position[0]) * frames[k].normal[1] -
              (element.position[1] - first->position[1]) * frames[k].normal[0];
        }
      return jump;
    }

    dealii::Tensor<1, 3>
    tensor(const std::array<double, 3> &values)
    {
      return dealii::Tensor<1, 3>({values[0], values[1], values[2]});
    }

    /** Return the jump of the bars of a joint in space whose work is N, T, M, T2, M1 or Mn (as 0
     * ... 5) in the frame of @p resultant: lips that move as a whole along an axis or turn about
     * it. Moments are about the first element. */
    Vector
    unit_jump_in_space(const std::vector<ContactElement> &elements,
                       const std::vector<ElementFrame> &frames,
                       const unsigned int joint,
                       const unsigned int component,
                       const JointResultant &resultant,
                       const std::size_t n_bars)
    {
      const auto n = tensor(resultant.normal), t1 = tensor(resultant.first_tangent);
      const auto t2                     = dealii::cross_product_3d(n, t1);
      const dealii::Tensor<1, 3> axes[] = {n, t1, t2, t2, -t1, -n};
      const bool turns                  = component == 2 || component > 3;
      const auto first                  = std::find_if(
        elements.begin(), elements.end(), [joint](const auto &e) { return e.joint == joint; });
      Vector jump(n_bars, 0.);
      for (std::size_t k = 0; k < elements.size(); ++k)
        {
          const ContactElement &element = elements[k];
          if (element.joint != joint)
            continue;
          const auto arm = tensor(element.position) - tensor(first->position);
          const auto direction =
            turns ? dealii::cross_product_3d(axes[component], arm) : axes[component];
          jump[element.normal_bar] = direction * tensor(frames[k].normal);
          if (element.has_tangential_bar())
            jump[element.tangential_bar] = direction * tensor(frames[k].tangents[0]);
          if (element.has_second_tangential_bar())
            jump[element.second_tangential_bar] = direction * tensor(frames[k].tangents[1]);
        }
      return jump;
    }
  } // namespace

  template <int dim>
  std::vector<bool>
  counting_elements(const Model<dim> &model)
  {
    const AccuracyTarget &target = model.parameters.accuracy;
    const FieldExpression<dim> where({target.where.empty() ? "1" : target.where},
                                     model.parameters.model.constants,
                                     target.origin + ": where the pressure counts");
    std::vector<bool> counts;
    for (const ContactElement &element : model.bodies.elements())
      counts.push_back(std::count(target.items.begin(), target.items.end(), element.joint) > 0 &&
                       where.value(place_of<dim>(element), 0) != 0.);
    return counts;
  }

  namespace
  {
    /** Stiffness of a bar without compliance, and stiffness of motions that nothing holds, relative
     * to that of the bodies: sufficiently near to rigid and to free for a field that only serves as
     * a weight. */
    constexpr double nearly_rigid = 1e4, nearly_free = 1e-6;

    /** Return the stiffness of the bars in the states of a level; it is zero if they are open, or
     * slip. */
    template <int dim>
    Vector
    bar_stiffnesses(const TrialRun<dim> &run, const typename TrialRun<dim>::Level &level)
    {
      const CondensedSystem<dim> &bodies = run.model().bodies;
      const double rigid                 = nearly_rigid * largest_diagonal(bodies.stiffness());
      Vector result(bodies.rigid_motions().rows(), 0.);
      const auto close = [&](const unsigned int bar) {
        result[bar] = run.compliance(bar) > 0. ? std::min(rigid, 1. / run.compliance(bar)) : rigid;
      };
      for (std::size_t k = 0; k < bodies.elements().size(); ++k)
        if (const ContactState state = level.results[k].state; state != ContactState::open)
          {
            close(bodies.elements()[k].normal_bar);
            if (bodies.elements()[k].has_tangential_bar() && !is_slipping(state))
              close(bodies.elements()[k].tangential_bar);
            if (bodies.elements()[k].has_second_tangential_bar() && !is_slipping(state))
              close(bodies.elements()[k].second_tangential_bar);
          }
      return result;
    }

    /** The cause of a dual field: a force on nodes, or the jump of bars. */
    struct Cause
    {
      Vector force, jump;
    };

    template <int dim>
    std::vector<Cause>
    causes(const TrialRun<dim> &run, const typename TrialRun<dim>::Level &level)
    {
      const Model<dim> &model      = run.model();
      const AccuracyTarget &target = model.parameters.accuracy;
      const auto &elements         = model.bodies.elements();
      const std::size_t n_bars     = model.bodies.rigid_motions().rows();
      std::vector<Cause> result;
      if (target.quantity == Quantity::pressure)
        {
          Vector jump(n_bars, 0.);
          const std::vector<bool> counts = counting_elements(model);
          for (std::size_t k = 0; k < elements.size(); ++k)
            if (counts[k])
              jump[elements[k].normal_bar] = level.results[k].pressure;
          result.push_back({{}, jump});
          return result;
        }
      for (const unsigned int item : target.items)
        for (const unsigned int component : target.components)
          if (target.quantity == Quantity::monitor)
            result.push_back(
              {model.monitor_points[item].unit_force(component), Vector(n_bars, 0.)});
          else if constexpr (dim == 2)
            result.push_back(
              {{}, unit_jump_in_plane(elements, model.frames, item, component, n_bars)});
          else
            result.push_back(
              {{},
               unit_jump_in_space(
                 elements, model.frames, item, component, level.resultants[item], n_bars)});
      return result;
    }
  } // namespace

  // The fields solve (S + Bᵀ C B) x = f + Bᵀ C w, with the condensed force f, the jump w and the
  // stiffness C of the bars.
  template <int dim>
  std::vector<dealii::Vector<double>>
  dual_fields(const TrialRun<dim> &run, const typename TrialRun<dim>::Level &level)
  {
    const CondensedSystem<dim> &bodies = run.model().bodies;
    const std::vector<Cause> all       = causes(run, level);
    const SparseOperator &B            = bodies.jump_operator();
    const Vector C                     = bar_stiffnesses(run, level);
    DenseMatrix K                      = bodies.stiffness();
    const std::size_t n                = K.rows();
    const double least                 = nearly_free * largest_diagonal(K);
    add_congruent(B, C, K);
    for (std::size_t i = 0; i < n; ++i)
      K(i, i) += least;
    DenseMatrix x(n, all.size());
    for (std::size_t c = 0; c < all.size(); ++c)
      {
        Vector right = all[c].jump;
        for (std::size_t bar = 0; bar < right.size(); ++bar)
          right[bar] *= C[bar];
        right = multiply_transposed(B, right);
        if (!all[c].force.empty())
          {
            const Vector condensed = bodies.response(all[c].force).coordinates;
            for (std::size_t i = 0; i < condensed.size(); ++i)
              right[i] += condensed[i];
          }
        x.col(c) = view(right);
      }
    if (n > 0 && !solve_positive_definite(K, x))
      throw NumericalFailure(
        "The weights of the refinement cannot be computed: the stiffness of the joints is "
        "not positive definite.");
    std::vector<dealii::Vector<double>> fields;
    for (std::size_t c = 0; c < all.size(); ++c)
      fields.push_back(
        bodies.bonded_field(all[c].force, Vector(x.col(c).data(), x.col(c).data() + n)));
    return fields;
  }

  template std::vector<bool>
  counting_elements(const Model<2> &);
  template std::vector<bool>
  counting_elements(const Model<3> &);
  template std::vector<dealii::Vector<double>>
  dual_fields(const TrialRun<2> &, const TrialRun<2>::Level &);
  template std::vector<dealii::Vector<double>>
  dual_fields(const TrialRun<3> &, const TrialRun<3>::Level &);
} // namespace fuga

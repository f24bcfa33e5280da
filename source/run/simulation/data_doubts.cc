// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/element/layer_response.h>
#include <fuga/contact/judge/conditioning.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/run/simulation/data_doubts.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** The smallest and the largest of positive numbers. */
    class Range
    {
    public:
      void
      add(const double value)
      {
        if (value > 0.)
          smallest = std::min(smallest, value);
        largest = std::max(largest, value);
      }

      std::string
      text(const std::string &unit) const
      {
        if (largest == 0.)
          return "zero";
        if (smallest < largest)
          return fmt::format("from {:.2g} to {:.2g} {}", smallest, largest, unit);
        return fmt::format("{:.2g} {}", largest, unit);
      }

    private:
      double smallest = std::numeric_limits<double>::infinity(), largest = 0.;
    };

    Range
    compliances_of(const std::vector<ContactElement> &elements)
    {
      Range range;
      for (const ContactElement &element : elements)
        element.for_each_bar([&range](const unsigned int, const ComplianceLaw &law) {
          range.add(law.initial_compliance());
        });
      return range;
    }

    /** Return the change of the data that moves the answer by as much as it is wrong by @p error;
     * for a path that failed, the change that moves its end. */
    std::string
    what_moves(const Conditioning &found, const double error, const bool is_certified)
    {
      if (!is_certified && !found.explains_by_loads(error))
        return fmt::format("joints move so far that the last digit of a jump is worth a force of "
                           "{:.1e} of the largest",
                           found.last_digit);
      return fmt::format("if all loads grow by {:.1e} of their size, {}",
                         found.change,
                         found.other_end
                           ? std::string("the path ends in another way")
                           : fmt::format("forces move by {:.1e} and jumps by {:.1e} of the largest",
                                         found.forces,
                                         found.jumps));
    }
  } // namespace

  // The question is only asked for bodies that are condensed and at rest.
  template <int dim>
  std::string
  doubt_about_data(const PhaseRun<dim> &phase, const Certificate &worst, RunLog &log)
  {
    if (phase.motion || !phase.model.bodies.has_stiffness())
      return {};
    const std::vector<ContactElement> &elements = phase.joint.elements;
    PathOptions options                         = phase.model.path_options();
    options.beyond_limit                        = false;
    // The certificate is in doubt or, for a path that failed, its end.
    const bool is_certified = worst.worst() <= phase.parameters.solver.certificate_bound;
    const auto is_explained = [&](const Conditioning &conditioning) {
      return is_certified ? conditioning.other_end : conditioning.explains(worst.worst());
    };
    log.line(
      fmt::format("The path {}: it is followed again, under loads changed in their last digits",
                  is_certified ? "failed" : "violates the bound of its certificate"));
    const Conditioning found = conditioning(
      [&](const LoadHistory &loads) {
        return std::make_unique<EventPath>(elements, phase.layered, loads, options);
      },
      phase.layered,
      phase.loading,
      phase.model.loads.levels,
      is_explained);
    if (!is_explained(found))
      return {};

    const Units &u = phase.parameters.output.units;
    Range moduli, distances;
    for (const Material &material : phase.parameters.model.materials)
      moduli.add(material.young_modulus);
    for (const ContactElement &element : elements)
      distances.add(std::hypot(element.position[0], element.position[1], element.position[2]));
    const std::string bound =
      is_certified ? std::string()
                   : fmt::format(". The certificate, {:.1e}, is no worse than that", worst.worst());
    return fmt::format("ill-conditioned data: {}{}. Moduli {}, compliances {}/{}, joints {} from "
                       "the origin",
                       what_moves(found, worst.worst(), is_certified),
                       bound,
                       moduli.text(u.stress()),
                       compliances_of(elements).text(u.length),
                       u.stress(),
                       distances.text(u.length));
  }

  namespace
  {
    /** Return the text for a law that ends. No finite stress reaches the closure limit of a normal
     * law, but a few powers of ten lead to where no digit is left between a closure and the limit.
     * Where the shear stiffness grows with closure, lips without shear reach the closure at which
     * it is infinite, and sheared ones come so near that no digit is left between both. */
    std::string
    what_ends(const ContactElement &element, const double closure, const Units &units)
    {
      constexpr double too_much = 1e-6;
      const double limit        = closure_limit(element);
      if (limit != element.normal_law->deformation_limit())
        return fmt::format("'Shear growth closure' of {:.9g} {}. There the shear stiffness of the "
                           "law is infinite. Give a larger one, a stiffer normal law, or one with "
                           "a closure limit below it.",
                           limit,
                           units.length);
      const double w          = std::min(closure, std::nextafter(limit, 0.));
      const double last_digit = std::numeric_limits<double>::epsilon() * w *
                                element.normal_law->tangent(w) / element.normal_law->stress(w);
      if (last_digit < too_much)
        return {};
      return fmt::format("closure limit of {:.9g} {}. A change of the last digit of the closure "
                         "changes the pressure by {:.1e} of it. Give a thicker layer, or a stiffer "
                         "law.",
                         limit,
                         units.length,
                         last_digit);
    }
  } // namespace

  template <int dim>
  std::string
  limit_of_law(const PhaseRun<dim> &phase, const JointState &state)
  {
    const Units &u = phase.parameters.output.units;
    for (std::size_t k = 0; k < state.states.size(); ++k)
      {
        const ContactElement &element = phase.joint.elements[k];
        if (!is_at_closure_limit(element, state, k))
          continue;
        const double closure   = -gap(element, state, k);
        const std::string ends = what_ends(element, closure, u);
        if (!ends.empty())
          return fmt::format("outside of the law: at load time {:.9g} element {} of joint '{}', at "
                             "({:g}; {:g}; {:g}), is closed by {:.9g} {}, all but {:.1e} of its {}",
                             state.t,
                             element.number,
                             phase.model.joint_names[element.joint],
                             element.position[0],
                             element.position[1],
                             element.position[2],
                             closure,
                             u.length,
                             1. - closure / closure_limit(element),
                             ends);
      }
    return {};
  }

  template std::string
  doubt_about_data(const PhaseRun<2> &, const Certificate &, RunLog &);
  template std::string
  doubt_about_data(const PhaseRun<3> &, const Certificate &, RunLog &);
  template std::string
  limit_of_law(const PhaseRun<2> &, const JointState &);
  template std::string
  limit_of_law(const PhaseRun<3> &, const JointState &);
} // namespace fuga

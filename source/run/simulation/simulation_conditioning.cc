// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/base/errors.h>
#include <fuga/contact/judge/conditioning.h>
#include <fuga/contact/path/event_path.h>
#include <fuga/run/simulation/simulation.h>

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

// Whether a certificate above its bound is the fault of the data.
namespace fuga
{
  namespace
  {
    /** Smallest and largest of positive numbers. */
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
  } // namespace

  // Only where it costs no more than the run did: bodies that are condensed and at rest, loads from
  // the beginning.
  template <int dim>
  std::string
  Simulation<dim>::doubt_about_data() const
  {
    if (!from_the_beginning || motion || !model.bodies.has_stiffness())
      return {};
    PathOptions options      = model.path_options();
    options.beyond_limit     = false;
    const Conditioning found = conditioning(
      [&](const LoadHistory &loads) {
        return std::make_unique<EventPath>(joint.elements, layered, loads, options);
      },
      layered,
      phase.loading,
      model.loads.levels);
    // The certificate is in doubt or, of a path that failed, its end.
    const bool is_certified = worst.worst() <= parameters.solver.certificate_bound;
    if (is_certified ? !found.other_end : !found.explains(worst.worst()))
      return {};

    const Units &u = parameters.output.units;
    Range moduli, compliances, distances;
    for (const Material &material : parameters.model.materials)
      moduli.add(material.young_modulus);
    for (const ContactElement &element : joint.elements)
      {
        element.for_each_bar([&](const unsigned int, const ComplianceLaw &law) {
          compliances.add(law.initial_compliance());
        });
        distances.add(std::hypot(element.position[0], element.position[1], element.position[2]));
      }
    return fmt::format(
      "ill-conditioned data: if all loads grow by {:.1e} of their size, {}{}. Moduli {}, "
      "compliances {}/{}, joints {} from the origin",
      found.change,
      found.other_end ? std::string("the path ends in another way")
                      : fmt::format("forces move by {:.1e} and jumps by {:.1e} of the largest",
                                    found.forces,
                                    found.jumps),
      is_certified ? std::string()
                   : fmt::format(". The certificate, {:.1e}, is no worse than that", worst.worst()),
      moduli.text(u.stress()),
      compliances.text(u.length),
      u.stress(),
      distances.text(u.length));
  }

  template class Simulation<2>;
  template class Simulation<3>;
} // namespace fuga

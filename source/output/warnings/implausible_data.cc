// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/input/entries/parameter_entries.h>
#include <fuga/input/values/parameter_scanner.h>
#include <fuga/output/warnings/implausible_data.h>

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace fuga
{
  namespace
  {
    /** A quantity in a unit of the user. */
    struct Quantity
    {
      /** Name of the quantity, for the beginning of the sentence. */
      std::string name;
      double value = 0.;
      std::string unit;
      /** The unit in terms of newtons, metres and their products. */
      double unit_size = 1.;
    };

    std::string
    path_of(const LoadDefinition &load, const AnyEntry &entry)
    {
      return path_name({entries_of<LoadEntries>().name, load.name, entry.name()});
    }


    /** Judges sizes; ranges are in N and m. */
    class Review
    {
    public:
      explicit Review(const Parameters &run_parameters)
        : parameters(run_parameters)
        , units(parameters.output.units)
        , newton(*units.newtons())
        , metre(*units.metres())
      {
      }

      void
      bodies()
      {
        for (const Material &material : parameters.model.materials)
          {
            const BodyEntries &e = entries_of<BodyEntries>();
            const auto name      = [&](const AnyEntry &entry) {
              return path_name({e.name, material.body, entry.name()});
            };
            if (material.weight_density > 0.)
              check(specific_weight(name(e.weight_density), material.weight_density),
                    5e3,
                    80e3,
                    "It is weight, not mass, per volume: 9.81 m/s2 times the density");
            const double weight = material.weight_density * newton / (metre * metre * metre);
            const bool is_stone = weight >= 22.5e3 && weight <= 30e3;
            check(stress(name(e.young_modulus), material.young_modulus),
                  is_stone ? 5e8 : 1e6,
                  is_stone ? 2e11 : 4e11,
                  fmt::format("{}Check the unit, which is {}",
                              is_stone ? "The body is as heavy as concrete, masonry or rock. " : "",
                              units.stress()));
            check({name(e.poisson_ratio), material.poisson_ratio, "", 1.},
                  0.05,
                  0.49,
                  "Towards 0.5 a body keeps its volume, and its elements lock");
            if (material.thermal_expansion > 0.)
              check({name(e.thermal_expansion), material.thermal_expansion, "1/K", 1.},
                    1e-6,
                    5e-5,
                    "Concrete, rock and steel have about 1e-5 1/K");
          }
      }

      void
      joints()
      {
        for (const JointParameters &joint : parameters.joints)
          {
            const auto name = [&](const char *what) {
              return fmt::format("joint '{}': {}", joint.definition.name, what);
            };
            const double friction = joint.friction.coefficient;
            if (friction > 0.)
              check({name("friction coefficient"), friction, "", 1.},
                    0.03,
                    1.5,
                    friction > 1.5 ? "An angle is entered as 'Friction angle', in degrees"
                                   : "'Friction angle' is in degrees; a coefficient is entered as "
                                     "'Friction coefficient'");
            const std::string advice = fmt::format("Check the unit, which is {}", units.stress());
            check(stress(name("cohesion"), joint.friction.cohesion), 0., 20e6, advice);
            check(
              stress(name("tensile strength"), joint.friction.tensile_strength), 0., 20e6, advice);
            if (const StrengthEnvelope &envelope = joint.friction.envelope; envelope.is_curved())
              {
                check({name("envelope exponent"), envelope.exponent, "", 1.},
                      0.5,
                      1.,
                      "Tests of soil and rock have 0.5 to 1");
                check(stress(name("envelope pressure"), envelope.pressure), 100., 1e9, advice);
              }
            if (joint.normal_compliance > 0.)
              check({name("normal stiffness"),
                     1. / joint.normal_compliance,
                     units.stress() + "/" + units.length,
                     newton / (metre * metre * metre)},
                    1e6,
                    infinity,
                    "Check the unit of the stiffness, or of the compliance");
          }
      }

      void
      water()
      {
        for (const LoadDefinition &load : parameters.model.loads)
          if (load.kind == LoadKind::uplift || type_of(parameters, load) == "hydrostatic")
            check(specific_weight(path_of(load, entries_of<LoadEntries>().unit_weight),
                                  load.depth.gradient),
                  9e3,
                  14e3,
                  fmt::format("Water has {:.4g} {}",
                              9810. / specific_weight("", 0.).unit_size,
                              specific_weight("", 0.).unit));
      }

      void
      mesh(const double extent)
      {
        const bool has_weight =
          std::any_of(parameters.model.loads.begin(),
                      parameters.model.loads.end(),
                      [](const LoadDefinition &load) {
                        return load.kind == LoadKind::weight || load.has_level();
                      });
        check(
          {"the largest extent of the mesh", extent, units.length, metre},
          has_weight ? 0.3 : 0.,
          5e3,
          fmt::format("Check the unit in which the mesh was drawn: here it is {}", units.length));
      }

      std::vector<std::string> warnings;

    private:
      static constexpr double infinity = std::numeric_limits<double>::infinity();

      Quantity
      stress(std::string name, const double value) const
      {
        return {std::move(name), value, units.stress(), newton / (metre * metre)};
      }

      Quantity
      specific_weight(std::string name, const double value) const
      {
        return {std::move(name),
                value,
                fmt::format("{}/{}", units.force, units.volume()),
                newton / (metre * metre * metre)};
      }

      /** Warn of a quantity outside the range [@p low, @p high]. */
      void
      check(const Quantity &quantity,
            const double low,
            const double high,
            const std::string &advice)
      {
        constexpr double rounding = 1e-9;
        const double value        = quantity.value * quantity.unit_size;
        if (value >= low * (1. - rounding) && value <= high * (1. + rounding))
          return;
        const auto text = [&](const double x) {
          return fmt::format(
            "{:.4g}{}{}", x / quantity.unit_size, quantity.unit.empty() ? "" : " ", quantity.unit);
        };
        const std::string usual = value < low && high == infinity ? text(low) + " and more"
                                  : low == 0.                     ? "at most " + text(high)
                                                                  : text(low) + " to " + text(high);
        warnings.push_back(fmt::format(
          "{} = {} is unusual; usual is {}. {}.", quantity.name, text(value), usual, advice));
      }

      const Parameters &parameters;
      const Units &units;
      const double newton, metre;
    };


    /** Compare the layers: a mistake in units shows in the modulus of the layer, whatever the units
     * are. */
    void
    compare_layers(const Parameters &parameters, std::vector<std::string> &warnings)
    {
      double softest_body = std::numeric_limits<double>::infinity();
      for (const Material &material : parameters.model.materials)
        softest_body = std::min(softest_body, material.young_modulus);
      for (const JointParameters &joint : parameters.joints)
        if (joint.normal_layer_modulus() > softest_body)
          warnings.push_back(fmt::format(
            "joint '{}': the layer modulus thickness/compliance = {:.4g} {} is above the modulus "
            "{:.4g} of the softest body. The layer hardly deforms; check the unit of the "
            "compliance.",
            joint.definition.name,
            joint.normal_layer_modulus(),
            parameters.output.units.stress(),
            softest_body));
    }
  } // namespace


  std::string
  type_of(const Parameters &parameters, const LoadDefinition &load)
  {
    for (const auto &[entry, value] : parameters.echo)
      if (entry == path_of(load, entries_of<LoadEntries>().type))
        return value;
    return {};
  }


  std::vector<std::string>
  implausible_data(const Parameters &parameters, const double extent)
  {
    std::vector<std::string> warnings;
    const Units &units = parameters.output.units;
    if (units.named && units.newtons() && units.metres())
      {
        Review review(parameters);
        review.bodies();
        review.joints();
        review.water();
        review.mesh(extent);
        warnings = std::move(review.warnings);
      }
    compare_layers(parameters, warnings);
    return warnings;
  }
} // namespace fuga

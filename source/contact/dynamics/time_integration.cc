// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#include <fuga/contact/dynamics/time_integration.h>

namespace fuga
{
  TimeIntegration::TimeIntegration(Vector mass, Damping of_bodies, const double spectral_radius)
    : m(std::move(mass))
    , damping(std::move(of_bodies))
    , alpha_m((2. * spectral_radius - 1.) / (spectral_radius + 1.))
    , alpha_f(spectral_radius / (spectral_radius + 1.))
    , gamma(0.5 - alpha_m + alpha_f)
    , beta(0.25 * (1. - alpha_m + alpha_f) * (1. - alpha_m + alpha_f))
  {
    u = v = a = out_of_balance = Vector(m.size(), 0.);
  }

  double
  TimeIntegration::mass_factor(const double h) const
  {
    return (1. - alpha_m) / ((1. - alpha_f) * beta * h * h);
  }

  double
  TimeIntegration::damping_factor(const double h) const
  {
    return gamma / (beta * h);
  }

  void
  TimeIntegration::begin(const Vector &initial_velocity, const Vector &net_forces)
  {
    u.assign(m.size(), 0.);
    v = steady_v   = initial_velocity;
    damped         = damping(v);
    out_of_balance = net_forces;
    add_multiple(-1., damped, out_of_balance);
    defect = out_of_balance;
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        a[i]                                     = m[i] > 0. ? out_of_balance[i] / m[i] : 0.;
        (m[i] > 0. ? defect : out_of_balance)[i] = 0.;
      }
  }

  TimeIntegration::Change
  TimeIntegration::predicted(const double h) const
  {
    Change result{Vector(m.size()), Vector(m.size())};
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        result.u[i] = h * (m[i] > 0. ? v[i] + 0.5 * h * a[i] : steady_v[i]);
        result.v[i] = h * ((1. - gamma) * a[i] + gamma * predicted_acceleration(i, h));
      }
    return result;
  }

  double
  TimeIntegration::predicted_acceleration(const std::size_t i, const double h) const
  {
    return m[i] > 0. ? a[i] : (steady_v[i] - v[i]) / (beta * h) - (0.5 / beta - 1.) * a[i];
  }

  // With Δū the remaining inertia at the end of the step is that of a constant acceleration.
  Vector
  TimeIntegration::push(const Vector &growth) const
  {
    Vector result = growth;
    for (std::size_t i = 0; i < m.size(); ++i)
      result[i] += defect[i] + (out_of_balance[i] - m[i] * a[i]) / (1. - alpha_f);
    return result;
  }

  void
  TimeIntegration::advance(const double h,
                           const Vector &correction,
                           const Vector &mean,
                           MotionLedger &ledger)
  {
    const Vector v_at_begin = v, damped_at_begin = damped;
    const double kinetic_at_begin = kinetic_energy();
    double of_inertia             = 0.;
    Vector du                     = predicted(h).u;
    add_multiple(1., correction, du);
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        const double a_before = a[i], v_before = v_at_begin[i];
        u[i] += du[i];
        a[i] = predicted_acceleration(i, h) + correction[i] / (beta * h * h);
        v[i] = v_before + h * ((1. - gamma) * a_before + gamma * a[i]);
        // Without mass the acceleration resists nothing, and one sudden change of velocity would
        // let it oscillate with every step for ever: the velocity would then be a small difference
        // of two such oscillations.
        if (m[i] == 0.)
          a[i] = (v[i] - v_before) / h;
        steady_v[i]           = m[i] > 0. ? v[i] : du[i] / h;
        const double q_before = out_of_balance[i], known_at_begin = q_before + defect[i];
        out_of_balance[i] =
          (m[i] * ((1. - alpha_m) * a[i] + alpha_m * a_before) - alpha_f * q_before) /
          (1. - alpha_f);
        (m[i] > 0. ? of_inertia : ledger.sudden) +=
          0.5 * (known_at_begin + out_of_balance[i]) * du[i];
        defect[i] = 0.;
      }
    damped = damping(v);
    ledger.work += dot(mean, du);
    // This is the part of the work of mean forces that are out of balance which does not become
    // kinetic energy.
    ledger.numerical += of_inertia - (kinetic_energy() - kinetic_at_begin);
    for (std::size_t i = 0; i < damped.size(); ++i)
      {
        const double mean_damped = 0.5 * (damped_at_begin[i] + damped[i]);
        const double way         = 0.5 * h * (v_at_begin[i] + v[i]);
        ledger.damping += mean_damped * way;
        ledger.numerical += mean_damped * (du[i] - way);
      }
    ledger.kinetic = kinetic_energy();
  }

  void
  TimeIntegration::correct(const Vector &net_forces)
  {
    defect = net_forces;
    add_multiple(-1., damped, defect);
    add_multiple(-1., out_of_balance, defect);
  }

  void
  TimeIntegration::accelerate(const Vector &forces)
  {
    for (std::size_t i = 0; i < forces.size(); ++i)
      if (m[i] > 0.)
        {
          a[i] += (1. - alpha_f) / (1. - alpha_m) * forces[i] / m[i];
          out_of_balance[i] += forces[i];
          defect[i] -= forces[i];
        }
  }

  double
  TimeIntegration::kinetic_energy() const
  {
    double result = 0.;
    for (std::size_t i = 0; i < m.size(); ++i)
      result += 0.5 * m[i] * v[i] * v[i];
    return result;
  }
} // namespace fuga

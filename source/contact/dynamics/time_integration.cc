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
    , u(m.size(), 0.)
    , v(m.size(), 0.)
    , a(m.size(), 0.)
    , out_of_balance(m.size(), 0.)
  {
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
  TimeIntegration::begin(const Vector &initial_velocity, const Vector &initial_out_of_balance)
  {
    u.assign(m.size(), 0.);
    v              = initial_velocity;
    out_of_balance = defect = initial_out_of_balance;
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        a[i]                                     = m[i] > 0. ? out_of_balance[i] / m[i] : 0.;
        (m[i] > 0. ? defect : out_of_balance)[i] = 0.;
      }
  }

  Vector
  TimeIntegration::push(const double h, const Vector &growth) const
  {
    Vector result = growth, of_damping(m.size());
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        const double of_motion =
          (1. - alpha_m) * (v[i] / (beta * h) + (0.5 / beta - 1.) * a[i]) - alpha_m * a[i];
        result[i] += defect[i] + (out_of_balance[i] + m[i] * of_motion) / (1. - alpha_f);
        of_damping[i] = gamma / beta * v[i] - h * (1. - 0.5 * gamma / beta) * a[i];
      }
    const Vector damped = damping(of_damping);
    for (std::size_t i = 0; i < damped.size(); ++i)
      result[i] += damped[i];
    return result;
  }

  void
  TimeIntegration::advance(const double h,
                           const Vector &du,
                           const Vector &mean,
                           MotionLedger &ledger)
  {
    Vector mean_velocity(m.size());
    for (std::size_t i = 0; i < m.size(); ++i)
      {
        const double a_before = a[i], v_before = v[i];
        u[i] += du[i];
        a[i] = (du[i] / h - v_before) / (beta * h) - (0.5 / beta - 1.) * a_before;
        v[i] = v_before + h * ((1. - gamma) * a_before + gamma * a[i]);
        out_of_balance[i] =
          (m[i] * ((1. - alpha_m) * a[i] + alpha_m * a_before) - alpha_f * out_of_balance[i]) /
          (1. - alpha_f);
        defect[i]        = 0.;
        mean_velocity[i] = du[i] / h;
      }
    ledger.work += dot(mean, du);
    if (const Vector damped = damping(mean_velocity); !damped.empty())
      ledger.damping += h * dot(damped, mean_velocity);
    ledger.kinetic = kinetic_energy();
  }

  void
  TimeIntegration::correct(const Vector &true_out_of_balance)
  {
    for (std::size_t i = 0; i < m.size(); ++i)
      defect[i] = true_out_of_balance[i] - out_of_balance[i];
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

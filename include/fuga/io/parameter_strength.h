// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_io_parameter_strength_h
#define fuga_io_parameter_strength_h

#include <fuga/io/parameter_values.h>
#include <fuga/io/parameters.h>

#include <optional>

namespace fuga
{
  /** Why the numbers of a friction law do not go together. */
  struct StrengthProblem
  {
    enum class Part
    {
      residual,
      tension,
      dilatancy
    };

    Part part;
    std::string text;
  };

  std::optional<StrengthProblem>
  find_strength_problem(const FrictionLaw &law);

  /** Friction, bond and dilatancy of one joint. @throws InputError */
  FrictionLaw
  read_strength(const ParameterSection &section);

  /** How the shear stiffness of a joint grows. @throws InputError */
  ShearGrowth
  read_shear_growth(const ParameterSection &section);

  /** That it goes together with the joint's laws and friction. @throws InputError */
  void
  check_shear_growth(const ParameterSection &section, const JointParameters &joint);
} // namespace fuga

#endif

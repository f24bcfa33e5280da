// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_tests_judges_judges_h
#define fuga_tests_judges_judges_h

// All judges but from_contact.h, which needs the contact headers.
#include "judges/enumeration.h"
#include "judges/judge_problem.h"
#include "judges/lemke.h"
#include "judges/lemke_step.h"
#include "judges/rate_enumeration.h"
#include "judges/semismooth_newton.h"

#endif

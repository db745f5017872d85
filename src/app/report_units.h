// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/report.h"
#include "app/user_defaults.h"

namespace poinsot::app {

/// The report for people who think in other units.
Report inUnits(Report report, const UnitChoice& units);

}  // namespace poinsot::app

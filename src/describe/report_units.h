// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "request/user_files.h"

namespace poinsot::describe {

/// The report for people who think in other units.
Report inUnits(Report report, const request::UnitChoice& units);

}  // namespace poinsot::describe

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "request/user_files.h"

namespace poinsot::describe {

/// Converts a report's values to the units that a user chose.
Report inUnits(Report report, const request::UnitChoice& units);

}  // namespace poinsot::describe

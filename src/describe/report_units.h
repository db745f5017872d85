// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "describe/report.h"
#include "request/user_files.h"

namespace poinsot::describe {

/// Returns the report with its values in the units that a user chose.
Report inUnits(Report report, const request::UnitChoice& units);

}  // namespace poinsot::describe

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reference/grade.h"

namespace poinsot::reference {

/// Returns a table to print, with one quantity per line, followed by the notes.
std::string gradeTable(const Grade& grade);

/// Returns a JSON object with file, scene, rows, from_s, to_s, quantities, fits and notes. `quantities` has one
/// entry for each key, null if the log lacks the columns. `fits` is null, or the readings with which the log fits
/// and the remaining errors. Numbers that are not finite are null.
std::string gradeJson(const Grade& grade, const std::string& fileName, const std::string& sceneName);

}  // namespace poinsot::reference

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reference/grade.h"

namespace poinsot::reference {

/// Returns a table for people, with one quantity per line, followed by the notes.
std::string gradeTable(const Grade& grade);

/// Returns one JSON object: file, scene, rows, from_s, to_s, quantities by key (null if absent), fits (null, or
/// the reading in which the log fits, with its quantities), notes. Numbers that are not finite are null.
std::string gradeJson(const Grade& grade, const std::string& fileName, const std::string& sceneName);

}  // namespace poinsot::reference

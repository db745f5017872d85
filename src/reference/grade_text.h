// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "reference/grade.h"

namespace poinsot::reference {

/// A table for people, a quantity a line, then the notes.
std::string gradeTable(const Grade& grade);

/// One JSON object: file, scene, rows, from_s, to_s, quantities by key (null where absent), fits (null, or how
/// else theirs has to be read and the quantities then), notes. A number that is not finite is null.
std::string gradeJson(const Grade& grade, const std::string& fileName, const std::string& sceneName);

}  // namespace poinsot::reference

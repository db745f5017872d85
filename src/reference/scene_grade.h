// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "reference/grade.h"
#include "scene/scene.h"

namespace poinsot::reference {

/// Grades a log against the motion of a scene.
/// @throws core::Error(kLimit) if a driven motion is too long. If the log's times are far from 0, such as Unix
/// time, the message also contains the errors counted from the log's first row.
Grade gradeAgainst(const scene::Scene& scene, const TrajectoryTable& theirs);

/// Parses the largest attitude error to accept: a number in rad such as "1e-6", or an angle with its unit such as
/// "0.1 deg".
/// @returns rad. @throws core::Error(kUsage) with `name` and `word` if `word` is not an angle, or is negative.
double attitudeLimit_rad(std::string_view name, std::string_view word);

}  // namespace poinsot::reference

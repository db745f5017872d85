// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "physics/motion.h"
#include "reference/trajectory_columns.h"
#include "reference/trajectory_times.h"

namespace poinsot::reference {

enum class TrajectoryFormat {
  kCsv,   ///< header with the column names, then one line per time
  kJson,  ///< object with format, scene, units, axes, columns and rows
};

/// Returns the first bytes of a trajectory without a choice of columns, which identify an earlier output.
std::string trajectoryMark(TrajectoryFormat format);

using TextSink = std::function<void(std::string_view)>;

/// Writes the motion at the given times, in pieces of about 64 kB, so that little memory is needed. Numbers are
/// the shortest decimals that read back as the same doubles. A value that does not exist is `nan` in CSV and
/// `null` in JSON.
/// @throws core::Error(kLimit) if the phase of the motion at a time exceeds the range of a double;
/// process::Interrupted
void writeTrajectory(const physics::Motion& motion, const ChosenColumns& columns, const TrajectoryTimes& times,
                     TrajectoryFormat format, const std::string& sceneName, const TextSink& sink);

}  // namespace poinsot::reference

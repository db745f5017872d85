// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "physics/motion.h"
#include "reference/trajectory_times.h"

namespace poinsot::reference {

enum class TrajectoryFormat {
  kCsv,   ///< a header with the names of the columns, then a line per time; nothing else
  kJson,  ///< an object: format, scene, units, axes, columns, rows
};

/// First line of a trajectory in CSV, without its newline. @param alpha  energy loss of the motion, s/(kg·m²).
std::string trajectoryHeader(double alpha = 0);

/// First bytes of every trajectory in this format: what tells an earlier output from somebody's file.
std::string trajectoryMark(TrajectoryFormat format);

/// Takes the text, a piece after the other.
using TextSink = std::function<void(std::string_view)>;

/// Writes the motion at these times; in memory there is never more than one piece (64 kB). Numbers are the
/// shortest decimals that read back as the same doubles.
/// @throws core::Error(kLimit) for a time so far that the phase of the motion has no double; process::Interrupted
void writeTrajectory(const physics::Motion& motion, const TrajectoryTimes& times, TrajectoryFormat format,
                     const std::string& sceneName, const TextSink& sink);

}  // namespace poinsot::reference

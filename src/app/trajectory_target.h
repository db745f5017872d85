// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/trajectory_text.h"

namespace poinsot::app {

/// Where a trajectory goes.
struct TrajectoryTarget {
  TrajectoryFormat format = TrajectoryFormat::kCsv;
  std::filesystem::path path;  ///< empty: standard output

  bool isStream() const { return path.empty(); }
};

/// Reads the format off the name; "-" is CSV on standard output.
/// @throws core::Error(kUsage) saying which names work.
TrajectoryTarget parseTrajectoryTarget(const std::string& name);

/// Fails early where the file could not or should not be written: what output::checkTarget() refuses, and a file
/// that is neither empty nor an earlier trajectory, unless `force`.
/// @throws core::Error(kIo)
void checkTrajectoryTarget(const TrajectoryTarget& target, bool force);

}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "output/file_kind.h"
#include "reference/trajectory.h"

namespace poinsot::reference {

/// Where a trajectory goes.
struct TrajectoryTarget {
  TrajectoryFormat format = TrajectoryFormat::kCsv;
  std::filesystem::path path;  ///< empty: standard output

  bool isStream() const { return path.empty(); }
};

/// Reads the format off the name; "-" is CSV on standard output.
/// @throws core::Error(kUsage) saying which names work.
TrajectoryTarget parseTrajectoryTarget(const std::string& name);

/// Trajectories of this program.
output::FileKind trajectoryKind(TrajectoryFormat format);

}  // namespace poinsot::reference

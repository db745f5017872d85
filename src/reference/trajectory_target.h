// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "output/file_kind.h"
#include "reference/trajectory.h"

namespace poinsot::reference {

struct TrajectoryTarget {
  TrajectoryFormat format = TrajectoryFormat::kCsv;
  std::filesystem::path path;  ///< empty for standard output

  bool isStream() const { return path.empty(); }
};

/// Takes the format from the extension of a name; "-" means CSV on standard output.
/// @throws core::Error(kUsage) with the names that work
TrajectoryTarget parseTrajectoryTarget(const std::string& name);

/// Returns a kind of file that recognises earlier trajectories of this program.
output::FileKind trajectoryKind(TrajectoryFormat format);

}  // namespace poinsot::reference

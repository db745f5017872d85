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

/// Returns the target for a file name, with the format from the extension. "-" means CSV on standard output.
/// @throws core::Error(kUsage) with the allowed names
TrajectoryTarget parseTrajectoryTarget(const std::string& name);

/// Returns the file kind by which earlier trajectories of this program are recognised. A CSV file counts as one if
/// its header names all columns of a motion, or exactly the columns of `header`.
/// @param header  ChosenColumns::header() of the new trajectory
output::FileKind trajectoryKind(TrajectoryFormat format, const std::string& header);

}  // namespace poinsot::reference

// SPDX-License-Identifier: Apache-2.0
#include "app/trajectory_target.h"

#include <fmt/format.h>

#include <fstream>

#include "core/error.h"
#include "core/text.h"
#include "output/target_check.h"

namespace poinsot::app {
namespace {

/// Empty (nothing is lost), or begins as this program's trajectories do.
bool isOwn(const std::filesystem::path& path, TrajectoryFormat format) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string start(trajectoryMark(format).size(), '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  return !file.bad() && (file.gcount() == 0 || start == trajectoryMark(format));
}

}  // namespace

TrajectoryTarget parseTrajectoryTarget(const std::string& name) {
  if (name == "-") return {};
  const std::filesystem::path path(name);
  if (path.extension() == ".csv") return {TrajectoryFormat::kCsv, path};
  if (path.extension() == ".json") return {TrajectoryFormat::kJson, path};
  throw core::Error(
      core::ErrorKind::kUsage,
      fmt::format("output '{}': works: NAME.csv, NAME.json, - (CSV on standard output)", core::printable(name)));
}

void checkTrajectoryTarget(const TrajectoryTarget& target, bool force) {
  output::checkTarget(target.path, force || isOwn(target.path, target.format));
}

}  // namespace poinsot::app

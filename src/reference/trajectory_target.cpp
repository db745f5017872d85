// SPDX-License-Identifier: Apache-2.0
#include "reference/trajectory_target.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::reference {
TrajectoryTarget parseTrajectoryTarget(const std::string& name) {
  if (name == "-") return {};
  const std::filesystem::path path(name);
  if (path.extension() == ".csv") return {TrajectoryFormat::kCsv, path};
  if (path.extension() == ".json") return {TrajectoryFormat::kJson, path};
  throw core::usageError(fmt::format("output '{}': must be NAME.csv, NAME.json or - (CSV on standard output){}",
                                     core::printable(name), core::smallLettersHint(name, {".csv", ".json"})));
}

output::FileKind trajectoryKind(TrajectoryFormat format, const std::string& header) {
  output::FileKind usual = output::textKind("a trajectory", trajectoryMark(format));
  if (format == TrajectoryFormat::kJson) return usual;
  const output::FileKind same = output::textKind(usual.name, header + '\n');
  return {usual.name,
          [usual, same](const std::filesystem::path& file) { return usual.isOwn(file) || same.isOwn(file); }};
}

}  // namespace poinsot::reference

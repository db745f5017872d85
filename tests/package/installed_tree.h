// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {

/// The build, installed into a scratch folder as PREFIX and then moved, so that no path of the build or of the
/// first place can be of use.
class InstalledTree {
 public:
  InstalledTree();

  const ScratchFolder& folder() const { return folder_; }
  std::filesystem::path prefix() const { return folder_ / "moved"; }

  /// Runs a script of bash in the folder; PREFIX, CXX and FLAGS are set in it. Fails the test unless it ends with
  /// 0.
  std::string run(const std::string& script) const;

 private:
  ScratchFolder folder_;
};

}  // namespace poinsot

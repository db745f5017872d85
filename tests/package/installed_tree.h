// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {

/// Build that was installed into a scratch folder as PREFIX and then moved, so that neither a path of the build
/// nor of the first folder works.
class InstalledTree {
 public:
  InstalledTree();

  const ScratchFolder& folder() const { return folder_; }
  std::filesystem::path prefix() const { return folder_ / "moved"; }

  /// Runs a bash script in the folder with PREFIX, CXX and FLAGS set. Fails the test if the exit code is not 0.
  std::string run(const std::string& script) const;

 private:
  ScratchFolder folder_;
};

}  // namespace poinsot

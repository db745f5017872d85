// SPDX-License-Identifier: Apache-2.0
#include "package/installed_tree.h"

#include <gtest/gtest.h>

namespace poinsot {

InstalledTree::InstalledTree() {
  run("cmake --install " POINSOT_BINARY_DIR
      " --prefix $PWD/prefix >install.log 2>&1 || { cat install.log; exit 1; }\n"
      "mv prefix moved");
}

std::string InstalledTree::run(const std::string& script) const {
  const auto result = runShell(folder_.path(), "set -euo pipefail\n" + script,
                               {"PREFIX=" + prefix().string(), "CXX=" POINSOT_CXX, "FLAGS=" POINSOT_CXX_FLAGS,
                                "PKG_CONFIG_PATH=" + (prefix() / "lib" / "pkgconfig").string()});
  EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
  return result.out;
}

}  // namespace poinsot

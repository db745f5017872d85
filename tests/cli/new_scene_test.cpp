// SPDX-License-Identifier: Apache-2.0
#include "cli/new_scene.h"

#include <gtest/gtest.h>

namespace poinsot {
namespace {

TEST(NewSceneText, GetsAKeyInsertedIntoItsTable) {
  constexpr const char* kText = "[show]\ntitle = \"x\"\n# plane = false   # off\n\n[show.body]\nscale = 2\n";
  EXPECT_EQ(cli::withKey(kText, {"show.plane", "true"}),
            "[show]\ntitle = \"x\"\nplane = true\n\n[show.body]\nscale = 2\n");
  EXPECT_EQ(cli::withKey(kText, {"show.body.scale", "3"}),
            "[show]\ntitle = \"x\"\n# plane = false   # off\n\n[show.body]\nscale = 3\n");
  EXPECT_EQ(cli::withKey(kText, {"show.L", "false"}),
            "[show]\nL = false\ntitle = \"x\"\n# plane = false   # off\n\n[show.body]\nscale = 2\n");
  EXPECT_EQ(cli::withKey(kText, {"style.theme", "\"dark\""}),
            std::string(kText) + "\n[style]\ntheme = \"dark\"\n");
}

}  // namespace
}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
#include "cli/new_scene.h"

#include <gtest/gtest.h>

#include <numbers>

#include "physics/catalogue.h"
#include "scene/scene_file.h"

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

TEST(NewSceneText, BeginsWithTheBodyOfTheCatalogueThatItIsNamedAfter) {
  for (const physics::CatalogueBody& body : physics::catalogue()) {
    const std::string text = cli::blankScene(body.name, {});
    const scene::Scene scene = scene::parseScene(text, "a.toml");
    const bool inHand = body.mass_kg < 100;
    EXPECT_EQ(text.find("\ncatalogue = \"" + body.name + "\"") != text.npos, inHand) << text;
    if (!inHand) continue;
    EXPECT_EQ(scene.body.mass->mass_kg(), body.mass_kg);
    EXPECT_NEAR(scene.motion.omega_B.norm(), std::numbers::pi, 0.1);  // half a turn in a second
  }
}

}  // namespace
}  // namespace poinsot

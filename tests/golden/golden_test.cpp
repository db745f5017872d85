// SPDX-License-Identifier: Apache-2.0
// A dozen small pictures guard the look. They are compared decoded, by the rule of image/difference.h: "near"
// passes, as a newer Mesa or libm may move a few pixels by one.
//
//   POINSOT_UPDATE_GOLDEN=1 ./poinsot test -L golden     writes new references, for review with git diff
//
// Every picture that is not identical leaves NAME.reference.png, NAME.actual.png and NAME.difference.png (16 times
// amplified) in build/golden-review/.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "image/difference.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

struct Golden {
  const char* name;
  const char* scene;  // a file of scenes/, or the text of one
  double filmTime_s;
  image::PixelSize size{256, 144};
};

const Golden kGoldens[] = {
    {"racket_steady", "tennis_racket", 1.0},
    {"racket_flipping", "tennis_racket", 5.2},
    {"rolling", "poinsot_rolling", 7.0},
    {"football", "football", 3.0},
    {"chandler", "chandler_wobble", 5.0},
    {"two_views",
     "[body]\nshape = \"ellipsoid\"\nsize = [17, 17, 28]\nmass = 1\n[motion]\nomega_body = [1.6, 0, "
     "3.5]\n[camera]\n"
     "frames = [\"space\", \"body\"]\n[show]\nellipsoid = false\nplane = false\n",
     3.0},
    {"two_keys", "[body]\nprincipal_moments = [1, 2, 2.5]\n[motion]\nomega_body = [0.3, 1, 0.2]\n", 2.0},
    {"dark",
     "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n[style]\ntheme = \"dark\"\n",
     4.0},
    {"box_in_space",
     "[body]\nshape = \"box\"\nsize = [3, 2, 1]\nmass = 1\n[motion]\nomega_body = [1, 2, 0.5]\n[show]\nellipsoid "
     "= false\n"
     "plane = false\npolhode = false\nherpolhode = false\n",
     1.5},
    {"cylinder",
     "[body]\nshape = \"cylinder\"\nsize = [1, 1, 3]\nmass = 1\n[motion]\nomega_body = [0.8, 0, 2]\n[show]\nplane "
     "= false\n",
     2.5},
    {"plane_above",
     "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\nL_points = \"up\"\n", 1.0},
    {"body_frame",
     "[body]\nprincipal_moments = [2, 3, 4]\n[motion]\nomega_body = [1, 0.5, 1.6]\n[camera]\nframe = \"body\"\n",
     3.0},
    {"torus",
     "[body]\nshape = \"torus\"\nradius = 1.1\ntube_radius = 0.35\nmass = 1\n[motion]\nomega_body = [0.6, 0, "
     "2]\n[show]\nellipsoid = false\nplane = false\npolhode = false\n",
     2.5},
    {"t_handle",
     "[body]\nshape = \"t_handle\"\nbar_length = 3\nbar_radius = 0.2\nshaft_length = 1.5\nshaft_radius = "
     "0.2\nmass = 1\n[motion]\nomega_body = [0.1, 3, 0]\n",
     2.0},
    {"heavy_top",
     "[body]\nprincipal_moments = [1.40625, 1.40625, 0.65625]\n[motion]\nomega_body = [0, 0, 9.15625]\n"
     "orientation = [0.966, 0.259, 0, 0]\n[motion.gravity]\nmgr_body = [0, 0, 2.84375]\n[time]\nspeed = 0.4\n",
     4.0},
    {"portrait",
     "[body]\nprincipal_moments = [1, 3, 3]\n[motion]\nomega_body = [2, 1, 0]\n[show]\ntitle = \"A "
     "rod\"\n[style]\n"
     "text_size = 0.7\nline_width = 1.5\n",
     2.0,
     {160, 200}},
};

// What GoogleTest and ctest print of a case.
void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.name; }

scene::Scene sceneOf(const Golden& golden) {
  const std::string text = golden.scene;
  if (text.find('\n') != std::string::npos) return scene::parseScene(text, std::string(golden.name) + ".toml");
  return scene::loadScene(fs::path(POINSOT_SOURCE_DIR) / "scenes" / (text + ".toml"));
}

image::Image actualPicture(const Golden& golden) {
  gl::pinEnvironment(true);
  static const auto context = gl::openContext(gl::Backend::kAuto);
  static render::Renderer renderer(*context);
  const stage::Stage stage(sceneOf(golden));
  return renderer.render(stage.compose(golden.filmTime_s, {golden.size.width, golden.size.height}));
}

void write(const fs::path& path, const image::Image& picture) {
  fs::create_directories(path.parent_path());
  const auto bytes = image::encodePng(picture);
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

bool wantsUpdate() {
  const char* wish = std::getenv("POINSOT_UPDATE_GOLDEN");
  return wish && *wish && *wish != '0';
}

class GoldenTest : public testing::TestWithParam<Golden> {};

TEST_P(GoldenTest, LooksAsItDid) {
  const Golden& golden = GetParam();
  const fs::path reference =
      fs::path(POINSOT_SOURCE_DIR) / "tests/golden/images" / (std::string(golden.name) + ".png");
  const fs::path review = fs::path(POINSOT_BINARY_DIR) / "golden-review";
  const image::Image actual = actualPicture(golden);
  if (!fs::exists(reference)) {
    ASSERT_TRUE(wantsUpdate()) << reference << " is missing";
    write(reference, actual);
    return;
  }
  const image::Image expected = image::readPng(reference);
  ASSERT_EQ(expected.size, actual.size);
  const auto difference = image::compare(expected, actual);
  const auto verdict = image::verdict(difference);
  if (verdict == image::Verdict::kIdentical) return;
  write(review / (std::string(golden.name) + ".reference.png"), expected);
  write(review / (std::string(golden.name) + ".actual.png"), actual);
  write(review / (std::string(golden.name) + ".difference.png"), image::amplifiedDifference(expected, actual));
  const std::string figures = "max " + std::to_string(difference.maxAbs) + ", differing " +
                              std::to_string(difference.differingPixels) + " px, FLIP mean " +
                              std::to_string(difference.flipMean) + " max " + std::to_string(difference.flipMax) +
                              "; see " + review.string();
  if (!wantsUpdate()) {
    EXPECT_NE(verdict, image::Verdict::kDifferent) << figures;
    return;
  }
  ASSERT_EQ(std::getenv("CI"), nullptr) << "references are not rewritten in CI";
  write(reference, actual);
  std::printf("%s rewritten: %s\n", golden.name, figures.c_str());
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(kGoldens),
                         [](const auto& golden) { return std::string(golden.param.name); });

}  // namespace
}  // namespace poinsot

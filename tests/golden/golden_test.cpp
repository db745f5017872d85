// SPDX-License-Identifier: Apache-2.0
// Small pictures guard the look: of every scene of the gallery, and of those in tests/golden/scenes, one for each
// drawn thing, view and style. They are compared decoded, by the rule of image/near_rule.h: "near" passes, as a
// newer Mesa or libm may move a few pixels by one.
//
//   POINSOT_UPDATE_GOLDEN=1 ./poinsot test -L golden     writes new references, for review with git diff
//
// Every picture that is not identical leaves NAME.reference.png, NAME.actual.png and NAME.difference.png (16 times
// amplified) in build/golden-review/.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "image/near_rule.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

/// A scene, at the instant that it calls telling.
struct Golden {
  fs::path scene;
  std::string name;
};

std::vector<Golden> goldens() {
  std::vector<Golden> all;
  for (const auto& [folder, prefix] : {std::pair("scenes", "gallery_"), std::pair("tests/golden/scenes", "")})
    for (const auto& entry : fs::directory_iterator(fs::path(POINSOT_SOURCE_DIR) / folder))
      if (entry.path().extension() == ".toml")
        all.push_back({entry.path(), prefix + entry.path().stem().string()});
  std::ranges::sort(all, {}, &Golden::name);
  return all;
}

// What GoogleTest and ctest print of a case.
void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.name; }

/// The scene's, made small where it is not.
image::PixelSize sizeOf(const scene::Scene& scene) {
  constexpr int kWidest = 400, kHeight = 144;
  const int width = scene.output.width, height = scene.output.height;
  if (width <= kWidest) return {width, height};
  return {width * kHeight / height, kHeight};
}

image::Image actualPicture(const Golden& golden) {
  gl::pinEnvironment(true);
  static const auto context = gl::openContext(gl::Backend::kAuto);
  static render::Renderer renderer(*context);
  const stage::Stage stage(scene::loadScene(golden.scene));
  const image::PixelSize size = sizeOf(stage.scene());
  return renderer.render(stage.compose(stage.scene().time.stillTime_s(), {size.width, size.height}));
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
  const fs::path reference = fs::path(POINSOT_SOURCE_DIR) / "tests/golden/images" / (golden.name + ".png");
  const fs::path review = fs::path(POINSOT_BINARY_DIR) / "golden-review";
  const image::Image actual = actualPicture(golden);
  if (!fs::exists(reference)) {
    ASSERT_TRUE(wantsUpdate()) << reference << " is missing";
    write(reference, actual);
    return;
  }
  const image::Image expected = image::readPng(reference);
  ASSERT_EQ(expected.size, actual.size);
  const auto difference = image::compare(expected, actual).difference;
  const auto verdict = image::verdict(difference);
  if (verdict == image::Verdict::kIdentical) return;
  write(review / (golden.name + ".reference.png"), expected);
  write(review / (golden.name + ".actual.png"), actual);
  write(review / (golden.name + ".difference.png"), image::amplifiedDifference(expected, actual));
  const std::string figures = "max " + std::to_string(difference.maxAbs) + ", differing " +
                              std::to_string(difference.differingPixels) + " px, FLIP mean " +
                              std::to_string(difference.flip.mean) + " max " +
                              std::to_string(difference.flip.max) + "; see " + review.string();
  if (!wantsUpdate()) {
    EXPECT_NE(verdict, image::Verdict::kDifferent) << figures;
    return;
  }
  ASSERT_EQ(std::getenv("CI"), nullptr) << "references are not rewritten in CI";
  write(reference, actual);
  std::printf("%s rewritten: %s\n", golden.name.c_str(), figures.c_str());
}

TEST(Goldens, AreOfScenesThatAreThere) {
  std::set<std::string> wanted, there;
  for (const Golden& golden : goldens()) wanted.insert(golden.name);
  for (const auto& entry : fs::directory_iterator(fs::path(POINSOT_SOURCE_DIR) / "tests/golden/images"))
    there.insert(entry.path().stem().string());
  EXPECT_EQ(there, wanted);
}

INSTANTIATE_TEST_SUITE_P(Pictures, GoldenTest, testing::ValuesIn(goldens()),
                         [](const auto& golden) { return golden.param.name; });

}  // namespace
}  // namespace poinsot

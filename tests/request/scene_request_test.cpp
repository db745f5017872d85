// SPDX-License-Identifier: Apache-2.0
#include "request/scene_request.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "core/error.h"
#include "support/scratch_folder.h"

namespace poinsot::request {
namespace {

const char* const kScene =
    "schema = 1\n[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 10, 0]\n"
    "[time]\nduration = 4\n";

core::ErrorKind kindOf(const std::string& fileName) {
  try {
    readSceneRequest(fileName, {});
  } catch (const core::Error& error) {
    EXPECT_NE(std::string(error.what()).find(fileName), std::string::npos) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "read " << fileName;
  return core::ErrorKind::kUsage;
}

TEST(SceneRequest, ReadsTheFileOnce) {
  const ScratchFolder folder;
  const auto file = folder.put("a.toml", kScene);
  const auto request = readSceneRequest(file.string(), {"time.duration=6"});
  std::filesystem::remove(file);
  const auto scene = loadRequested(request);
  EXPECT_EQ(scene.name, "a");
  EXPECT_EQ(scene.time.duration_s, 6.0);
}

TEST(SceneRequest, ReportsInvalidTexAsASceneError) {
  const ScratchFolder folder;
  const auto file = folder.put("a.toml", fmt::format("{}[show]\ntitle = '$\\omgea$'\nsubtitle = '$x'\n", kScene));
  try {
    loadRequested(readSceneRequest(file.string(), {}));
    FAIL() << "nothing was thrown";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
    const std::string report = error.what();
    EXPECT_NE(report.find("a.toml:9:9: error: show.title"), std::string::npos) << report;
    EXPECT_NE(report.find("did you mean \\omega"), std::string::npos) << report;
    EXPECT_NE(report.find("a.toml:10:12: error: show.subtitle"), std::string::npos) << report;
  }
}

TEST(SceneRequest, SizeOverridesTheSceneAndMayBeOdd) {
  const ScratchFolder folder;
  auto request = readSceneRequest(folder.put("a.toml", kScene).string(), {});
  request.size = image::PixelSize{161, 91};
  EXPECT_EQ(loadRequested(request).output.width, 161);
  EXPECT_EQ(loadRequested(request).output.height, 91);
}

TEST(SceneRequest, ShowsOnlyTheRequestedView) {
  const ScratchFolder folder;
  const std::string text =
      std::string(kScene) +
      "[[view]]\n[[view]]\ntitle = \"Body\"\nat = [0, 1]\n[[plot]]\nquantities = [\"omega_2\"]\n";
  auto request = readSceneRequest(folder.put("a.toml", text).string(), {});
  request.view = 1;
  const auto scene = loadRequested(request);
  ASSERT_EQ(scene.views.size(), 1u);
  EXPECT_EQ(scene.views[0].title, "Body");
  EXPECT_EQ(scene.views[0].place.row, 0);
  EXPECT_TRUE(scene.plots.empty());
  request.view = 2;
  EXPECT_THROW(loadRequested(request), core::Error);
}

TEST(SceneRequest, ReadsOnlyRegularFiles) {
  const ScratchFolder folder;
  EXPECT_EQ(kindOf((folder / "missing.toml").string()), core::ErrorKind::kScene);
  EXPECT_EQ(kindOf(folder.path().string()), core::ErrorKind::kScene);
  EXPECT_EQ(kindOf("/dev/zero"), core::ErrorKind::kScene);
  ASSERT_EQ(mkfifo((folder / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(kindOf((folder / "fifo").string()), core::ErrorKind::kScene);  // and does not wait for a writer
}

}  // namespace
}  // namespace poinsot::request

// SPDX-License-Identifier: Apache-2.0
// Scenes of earlier versions must still load, with the same sizes and motions. Each folder of released/ has the
// gallery of one version, the keys that it read (keys.txt), and what its own code computed for each scene
// (motion.csv): the size of the picture, motion seconds per film second, and omega in rad/s after one second of
// film.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "scene/keys/keys.h"
#include "scene/motion/make_motion.h"
#include "scene/scene_file.h"

namespace poinsot::scene {
namespace {

namespace fs = std::filesystem;

struct Recorded {
  int width = 0, height = 0;
  double speed = 0;
  Eigen::Vector3d omega_W = Eigen::Vector3d::Zero();
};

Recorded recordedNow(const fs::path& file) {
  const Scene scene = loadScene(file);
  const double speed = chosenSpeed(scene), t_s = scene.time.start_s + speed;
  return {scene.output.width, scene.output.height, speed, makeMotion(scene, 0, t_s)->at(t_s).omega_W};
}

std::string lineOf(const std::string& name, const Recorded& scene) {
  const Eigen::Vector3d& omega = scene.omega_W;
  return fmt::format("{},{},{},{:.17g},{:.17g},{:.17g},{:.17g}", name, scene.width, scene.height, scene.speed,
                     omega.x(), omega.y(), omega.z());
}

std::map<std::string, Recorded> recordedIn(const fs::path& folder) {
  std::ifstream file(folder / "motion.csv");
  std::string line, name;
  std::getline(file, line);  // the columns' names
  std::map<std::string, Recorded> recorded;
  while (std::getline(file, line)) {
    std::ranges::replace(line, ',', ' ');
    std::istringstream words(line);
    words >> name;
    Recorded& scene = recorded[name];
    words >> scene.width >> scene.height >> scene.speed >> scene.omega_W.x() >> scene.omega_W.y() >>
        scene.omega_W.z();
    EXPECT_FALSE(words.fail()) << line;
  }
  return recorded;
}

class ReleasedVersion : public ::testing::TestWithParam<const char*> {
 protected:
  fs::path folder_ = fs::path(POINSOT_SOURCE_DIR "/tests/scene/released") / GetParam();
};

TEST_P(ReleasedVersion, ScenesKeepTheirSizesAndMotions) {
  const auto recorded = recordedIn(folder_);
  std::size_t scenes = 0;
  for (const auto& entry : fs::directory_iterator(folder_)) {
    if (entry.path().extension() != ".toml") continue;
    ++scenes;
    const std::string name = entry.path().stem();
    const Recorded now = recordedNow(entry.path());
    const auto then = recorded.find(name);
    if (then == recorded.end()) {
      ADD_FAILURE() << "motion.csv lacks the line\n" << lineOf(name, now);
      continue;
    }
    SCOPED_TRACE(lineOf(name, now));
    EXPECT_EQ(now.width, then->second.width);
    EXPECT_EQ(now.height, then->second.height);
    EXPECT_EQ(now.speed, then->second.speed);
    // Measured 5.2e-16. Driven motions may move by their tolerance when the integrator changes.
    EXPECT_LE((now.omega_W - then->second.omega_W).norm(), 1e-9 * then->second.omega_W.norm());
  }
  EXPECT_EQ(scenes, recorded.size());
}

TEST_P(ReleasedVersion, KeysAreStillAccepted) {
  std::ifstream file(folder_ / "keys.txt");
  std::size_t keys = 0;
  for (std::string path; std::getline(file, path); ++keys)
    EXPECT_NE(findKey(path), nullptr) << path << ": was a key; scenes that have it must still load";
  EXPECT_GE(keys, 363u);  // number of keys of 0.1.0
}

INSTANTIATE_TEST_SUITE_P(Versions, ReleasedVersion, ::testing::Values("0.1.0"), [](const auto& version) {
  std::string name = version.param;
  std::ranges::replace(name, '.', '_');
  return name;
});

}  // namespace
}  // namespace poinsot::scene

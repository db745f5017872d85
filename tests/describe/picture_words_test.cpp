// SPDX-License-Identifier: Apache-2.0
#include "describe/picture_words.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace poinsot::describe {
namespace {

using testing::HasSubstr;

constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0]\n[time]\nduration = 4\n";
const std::string kOne = "motion.omega_body=[0.1..0.3:3, 2, 0]";

request::SceneRequest asked(const std::vector<std::string>& overrides, const request::SweepRequest& sweep = {}) {
  return {.fileName = "spin.toml", .text = kScene, .overrides = overrides, .sweep = sweep};
}

TEST(PictureWords, DescribeSweepsAndMaps) {
  const auto grid = asked({kOne, "time.speed=1..2:2"});
  const std::string words = pictureWords(request::requestedScene(grid)).description;
  EXPECT_THAT(words,
              HasSubstr("6 pictures of one scene side by side, at one instant: ω₁ from 0.1 rad/s to 0.3 rad/s "
                        "from left to right, speed from 1 to 2 from top to bottom."));
  const auto instants = asked({"time.still=0|0.5|2", "time.speed=1"});
  EXPECT_THAT(pictureWords(request::requestedScene(instants)).description,
              HasSubstr("3 pictures of one scene side by side, at several instants: t from 0.0 s to 2.0 s."));
  const auto map = asked({}, {.map = true});
  // Half periods 2K/lambda in the limit of small swings: pi/(w sqrt((I_k - I_i)(I_k - I_j)/(I_i I_j))), with
  // w = |L|/I_k and |L| = 4.00125.
  EXPECT_THAT(pictureWords(request::requestedScene(map)).description,
              HasSubstr("from 1.36 s in dark colours at the axes e1 and e3, the stable ones"));
}

}  // namespace
}  // namespace poinsot::describe

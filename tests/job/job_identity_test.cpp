// SPDX-License-Identifier: Apache-2.0
#include "job/job_identity.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace poinsot::job {
namespace {

constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0]\n[time]\nduration = 4\n";
const std::string kOne = "motion.omega_body=[0.1..0.3:3, 2, 0]";

request::SceneRequest asked(const std::vector<std::string>& overrides, const request::SweepRequest& sweep = {}) {
  return {.fileName = "spin.toml", .text = kScene, .overrides = overrides, .sweep = sweep};
}

// A render that resumes must not take another sweep's segments for its own.
TEST(JobIdentity, DependsOnASweepsRangesColumnsAndLabels) {
  std::set<core::Digest> digests;
  const auto add = [&](const request::SceneRequest& request) { digests.insert(sceneDigest({request})); };
  add(asked({kOne}));
  add(asked({"motion.omega_body=[0.1..0.3:4, 2, 0]"}));
  add(asked({kOne}, {.columns = 2}));
  add(asked({kOne}, {.labels = {"$a$"}}));
  add(asked({kOne}, {.map = true}));
  auto plain = asked({kOne});
  plain.sweep.reset();
  add(plain);
  plain.view = 1;
  add(plain);
  EXPECT_EQ(digests.size(), 7u);
}

}  // namespace
}  // namespace poinsot::job

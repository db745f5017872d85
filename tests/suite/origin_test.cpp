// SPDX-License-Identifier: Apache-2.0
// Origins of references: how they are read from descriptions, and how a new picture's origin differs.
#include <gtest/gtest.h>

#include "suite/reference.h"

namespace poinsot::suite {
namespace {

const compare::PictureOrigin kThen{"llvmpipe (LLVM 15.0.6, 128 bits)", "Mesa 22.3.6", "poinsot 0.1.0", "5f"};

TEST(PictureOrigin, NamesOnlyFactsThatDiffer) {
  compare::PictureOrigin now = kThen;
  EXPECT_EQ(compare::originChange(kThen, now), "");
  now.scene = "60";  // the scene is not part of the comparison
  EXPECT_EQ(compare::originChange(kThen, now), "");
  now.software = "poinsot 0.2.0";
  EXPECT_EQ(compare::originChange(kThen, now), "approved by poinsot 0.1.0, drawn by poinsot 0.2.0");
  now.driver = "Mesa 25.0.7-2";
  EXPECT_EQ(compare::originChange(kThen, now),
            "approved by poinsot 0.1.0 with Mesa 22.3.6, drawn by poinsot 0.2.0 with Mesa 25.0.7-2");
  now = {"softpipe", kThen.driver, kThen.software, kThen.scene};
  EXPECT_EQ(compare::originChange(kThen, now), "approved by llvmpipe (LLVM 15.0.6, 128 bits), drawn by softpipe");
}

TEST(PictureOrigin, IgnoresFactsThatOnlyOnePictureHas) {
  compare::PictureOrigin now = kThen;
  now.driver = now.software = "";
  EXPECT_EQ(compare::originChange(kThen, now), "");
  EXPECT_EQ(compare::originChange(now, kThen), "");
  EXPECT_EQ(compare::originChange({}, kThen), "");
}

// The texts of an image may come from a stranger.
TEST(PictureOrigin, PrintsNoControlCharacters) {
  compare::PictureOrigin now = kThen;
  now.software = "x\33[2J";
  EXPECT_EQ(compare::originChange(kThen, now), "approved by poinsot 0.1.0, drawn by x\\x1b[2J");
}

TEST(PictureOrigin, IsReadFromDescriptionsWithAndWithoutADriver) {
  const auto early = parsePictureOrigin(R"({"renderer": "r", "software": "s", "scene": "5f"})");
  ASSERT_TRUE(early);
  EXPECT_EQ(early->driver, "");
  EXPECT_EQ(early->software, "s");
  const auto whole = parsePictureOrigin(R"({"renderer": "r", "driver": "d", "software": "s", "scene": "5f"})");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->driver, "d");
  for (const char* other :
       {R"({"renderer": "r", "driver": 1, "software": "s", "scene": ""})", R"({"renderer": "r", "software": "s"})",
        R"({"renderer": "r", "driver": "d", "software": "s"})",
        R"({"renderer": "r", "driver": "d", "software": "s", "scene": "", "gain": 3})"})
    EXPECT_FALSE(parsePictureOrigin(other)) << other;
}

}  // namespace
}  // namespace poinsot::suite

// SPDX-License-Identifier: Apache-2.0
// Groups of alike changes. Each picture differs from the reference in one property of a change.
#include "compare/alike.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace poinsot::compare {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Returns a change in a box of a picture of 200x100 pixels.
PictureDiff changed(double flipMean, image::PixelRect box = {20, 10, 60, 30}) {
  PictureDiff diff;
  diff.verdict = Verdict::kDifferent;
  diff.hasFigures = true;
  diff.figures.flip.mean = flipMean;
  diff.changes.size = {200, 100};
  diff.changes.pixels = 100;
  diff.changes.largest = 200;
  diff.changes.box = box;
  diff.changes.placeCount = 1;
  diff.changes.places = {{box, 100}};
  return diff;
}

std::vector<AlikeGroup> groupsOf(const std::vector<PictureDiff>& diffs) {
  std::vector<const PictureDiff*> all;
  for (const PictureDiff& diff : diffs) all.push_back(&diff);
  return alikeChanges(all);
}

TEST(AlikeChanges, AreGroupedByFallingChange) {
  const auto groups = groupsOf({changed(0.012), changed(0.02), changed(0.011)});
  ASSERT_EQ(groups.size(), 1u);
  EXPECT_EQ(groups[0].kind, "in some places");
  EXPECT_THAT(groups[0].members, ElementsAre(1, 0, 2));
}

TEST(AlikeChanges, HaveTheSamePlaceInPicturesOfAnySize) {
  PictureDiff large = changed(0.01, {200, 100, 600, 300});
  large.changes.size = {2000, 1000};
  EXPECT_EQ(groupsOf({changed(0.01), large}).size(), 1u);
  EXPECT_THAT(groupsOf({changed(0.01), changed(0.01, {20, 10, 60, 60})}), IsEmpty());  // overlap 2/5
  EXPECT_EQ(groupsOf({changed(0.01), changed(0.01, {20, 10, 60, 49})}).size(), 1u);    // overlap 20/39
  EXPECT_THAT(groupsOf({changed(0.01), changed(0.01, {100, 10, 140, 30})}), IsEmpty());
}

TEST(AlikeChanges, DifferInNeitherVerdictNorKindNorSize) {
  EXPECT_THAT(groupsOf({changed(0.021), changed(0.01)}), IsEmpty());
  PictureDiff near = changed(0.01);
  near.verdict = Verdict::kNear;
  EXPECT_THAT(groupsOf({changed(0.01), near}), IsEmpty());
  PictureDiff right = changed(0.01), left = right, faint = right, blue = right;
  right.changes.shift = Shift{1, 0};
  left.changes.shift = Shift{-1, 0};
  faint.changes.largest = 2;
  blue.changes.recolouring = Recolouring{"#000000", "#0000ff", 100};
  const auto groups = groupsOf({right, left, faint, blue, changed(0.01)});
  EXPECT_THAT(groups, IsEmpty());
  EXPECT_EQ(kindOf(right.changes), "moved by 1 px to the right");
  EXPECT_EQ(kindOf(faint.changes), "hardly visible");
  EXPECT_EQ(kindOf(blue.changes), "#000000 became #0000ff");
}

TEST(AlikeChanges, LeaveOutIdenticalAndUnreadablePictures) {
  PictureDiff identical = changed(0);
  identical.verdict = Verdict::kIdentical;
  identical.changes = {};
  EXPECT_THAT(groupsOf({identical, identical, PictureDiff(), PictureDiff()}), IsEmpty());
}

TEST(AlikeChanges, FormTheSameGroupsInAnyOrder) {
  std::vector<PictureDiff> diffs;
  for (int i = 0; i < 5; ++i) diffs.push_back(changed(0.01 * (1 + 0.1 * i)));
  for (int i = 0; i < 3; ++i) diffs.push_back(changed(0.05 * (1 + 0.1 * i)));
  for (std::size_t i = 0; i < diffs.size(); ++i) {
    std::ranges::rotate(diffs, diffs.begin() + 1);
    const auto groups = groupsOf(diffs);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0].members.size(), 5u);
    EXPECT_EQ(diffs[groups[0].members.front()].figures.flip.mean, 0.01 * (1 + 0.1 * 4));
    EXPECT_EQ(groups[1].members.size(), 3u);
  }
}

}  // namespace
}  // namespace poinsot::compare

// SPDX-License-Identifier: Apache-2.0
// Blocks of type at the nine places: where they stand, and that no block covers another.
#include "stage/type/note_layout.h"

#include <gtest/gtest.h>

#include <random>

namespace poinsot::stage {
namespace {

using scene::Spot;

constexpr glm::dvec2 kSize{1600, 900};
constexpr double kEdge = 50;

NoteBlock block(int place, double width, double height) {
  return {static_cast<Spot>(place), {{.pieces = {}, .width_px = width, .ascent_px = height, .descent_px = 0}}};
}

TEST(NoteLayout, PutsNineBlocksInThreeRowsOfThree) {
  std::vector<NoteBlock> blocks;
  for (int place = 0; place < 9; ++place) blocks.push_back(block(place, 200, 80));
  const auto boxes = placedBlocks(blocks, kSize, kEdge);
  const double lefts[] = {50, 700, 1350}, tops[] = {50, 410, 770};
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(boxes[i].left, lefts[i % 3]) << i;
    EXPECT_EQ(boxes[i].top, tops[i / 3]) << i;
    EXPECT_EQ(boxes[i].width(), 200);
    EXPECT_EQ(boxes[i].height(), 80);
  }
  const NoteReach reach = reachOf(blocks, boxes, kSize);
  EXPECT_EQ(reach.top, 130);
  EXPECT_EQ(reach.bottom, 130);
  EXPECT_EQ(reach.left, 250);
  EXPECT_EQ(reach.right, 250);
  EXPECT_TRUE(leavesRoom(boxes, reach, kSize));
}

// A long title pushes blocks beside it down, and a long footnote pushes them up.
TEST(NoteLayout, MovesBlocksAwayFromALongBlock) {
  const auto top = placedBlocks({block(0, 1400, 60), block(1, 300, 40), block(2, 200, 40)}, kSize, kEdge);
  EXPECT_EQ(top[0].top, kEdge);
  EXPECT_GT(top[2].top, top[0].bottom);
  EXPECT_GT(top[1].top, top[0].bottom);
  EXPECT_FALSE(near(top[1], top[2]));
  const auto bottom = placedBlocks({block(6, 1400, 60), block(8, 200, 40)}, kSize, kEdge);
  EXPECT_EQ(bottom[0].bottom, 850);
  EXPECT_LT(bottom[1].bottom, bottom[0].top);
}

TEST(NoteLayout, NeverPutsABlockOverAnother) {
  std::mt19937 random(11);
  const auto below = [&](unsigned n) { return static_cast<double>(random() % n); };
  int roomy = 0;
  for (int i = 0; i < 500; ++i) {
    std::vector<NoteBlock> blocks;
    for (int place = 0; place < 9; ++place)
      if (random() % 2) blocks.push_back(block(place, 20 + below(1200), 20 + below(160)));
    const auto boxes = placedBlocks(blocks, kSize, kEdge);
    for (std::size_t a = 0; a < boxes.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(near(boxes[a], boxes[b])) << i;
    roomy += leavesRoom(boxes, reachOf(blocks, boxes, kSize), kSize);
  }
  EXPECT_GT(roomy, 50);  // both answers occur
  EXPECT_LT(roomy, 450);
}

TEST(NoteLayout, ReportsWhenThereIsNoRoom) {
  const std::vector<NoteBlock> tall = {block(0, 100, 400)}, wide = {block(3, 700, 20)},
                               fits = {block(0, 100, 300)};
  for (const auto& [blocks, room] : {std::pair(tall, false), std::pair(wide, false), std::pair(fits, true)}) {
    const auto boxes = placedBlocks(blocks, kSize, kEdge);
    EXPECT_EQ(leavesRoom(boxes, reachOf(blocks, boxes, kSize), kSize), room);
  }
}

}  // namespace
}  // namespace poinsot::stage

// SPDX-License-Identifier: Apache-2.0
#include "stage/type/picture_writing.h"

#include <algorithm>

namespace poinsot::stage {

PictureWriting pictureWriting(const scene::Scene& scene, const WrittenThings& things, glm::ivec2 size_px,
                              const Sizing& sizing, const Palette& colors) {
  constexpr int kMostRounds = 40;
  constexpr double kSmaller = 0.9;
  constexpr double kLeastRoom = 0.25;  // least width of a row, as a fraction of the picture's width
  const glm::dvec2 size(size_px);
  Sizing type = typeScaled(sizing, scene.style.textSize);
  for (int round = 0;; ++round, type = typeScaled(type, kSmaller)) {
    const double edge_px = noteEdge_px(type);
    const double room_px = std::max(size.x - 2 * edge_px, kLeastRoom * size.x);
    PictureWriting writing{pictureBlocks(scene, things, type, room_px, colors), {}, {}};
    writing.boxes = placedBlocks(writing.blocks, size, edge_px);
    writing.reach = reachOf(writing.blocks, writing.boxes, size);
    if (round == kMostRounds || leavesRoom(writing.boxes, writing.reach, size)) return writing;
  }
}

}  // namespace poinsot::stage

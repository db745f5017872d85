// SPDX-License-Identifier: Apache-2.0
#include "stage/type/picture_writing.h"

namespace poinsot::stage {

PictureWriting pictureWriting(const scene::Scene& scene, const WrittenThings& things, glm::ivec2 size_px,
                              const Sizing& sizing, const Palette& colors) {
  constexpr int kMostRounds = 40;
  constexpr double kSmaller = 0.9;
  const glm::dvec2 size(size_px);
  Sizing type = typeScaled(sizing, scene.style.textSize);
  for (int round = 0;; ++round, type = typeScaled(type, kSmaller)) {
    const double edge_px = noteEdge_px(type);
    PictureWriting writing{pictureBlocks(scene, things, type, size.x - 2 * edge_px, colors), {}, {}};
    writing.boxes = placedBlocks(writing.blocks, size, edge_px);
    writing.reach = reachOf(writing.blocks, writing.boxes, size);
    if (round == kMostRounds || leavesRoom(writing.boxes, writing.reach, size)) return writing;
  }
}

}  // namespace poinsot::stage

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stage/type/note_layout.h"
#include "stage/type/note_rows.h"

namespace poinsot::stage {

/// Text at fixed positions of a picture, at an instant. The positions are the same at all instants.
struct PictureWriting {
  std::vector<NoteBlock> blocks;
  std::vector<PixelBox> boxes;
  NoteReach reach;
};

/// Returns the text of a picture. If the text takes too much of the picture, all text is made smaller by the same
/// factor. The factor depends only on widths and positions that do not change with time, so text keeps its size
/// during a film.
PictureWriting pictureWriting(const scene::Scene& scene, const WrittenThings& things, glm::ivec2 size_px,
                              const Sizing& sizing, const Palette& colors);

}  // namespace poinsot::stage

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stage/type/note_layout.h"
#include "stage/type/note_rows.h"

namespace poinsot::stage {

/// Type of a picture that stands still, at an instant. The places are the same at all instants.
struct PictureWriting {
  std::vector<NoteBlock> blocks;
  std::vector<PixelBox> boxes;
  NoteReach reach;
};

/// Returns the type of a picture. Type that takes too much of the picture is set smaller, all of it alike. Only
/// widths and places decide this, and they do not depend on the time, so that type keeps its size during a film.
PictureWriting pictureWriting(const scene::Scene& scene, const WrittenThings& things, glm::ivec2 size_px,
                              const Sizing& sizing, const Palette& colors);

}  // namespace poinsot::stage

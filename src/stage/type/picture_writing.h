// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stage/type/note_layout.h"
#include "stage/type/note_rows.h"

namespace poinsot::stage {

/// The type of a picture that stands still, at an instant; its places do not depend on it.
struct PictureWriting {
  std::vector<NoteBlock> blocks;
  std::vector<PixelBox> boxes;
  NoteReach reach;
};

/// Type that is too much for the picture is set smaller, all of it alike. What decides are widths and places,
/// which do not depend on the time: so a film's type does not breathe.
PictureWriting pictureWriting(const scene::Scene& scene, const WrittenThings& things, glm::ivec2 size_px,
                              const Sizing& sizing, const Palette& colors);

}  // namespace poinsot::stage

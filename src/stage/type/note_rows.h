// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/type/lettering.h"
#include "stage/type/note_layout.h"
#include "stage/type/readout_board.h"

/// Text of a picture as rows of type. A row wider than `room_px` is set smaller.
namespace poinsot::stage {

/// Returns the room between the picture's edges and its type, px.
double noteEdge_px(const Sizing& sizing);

/// Text at an instant, and the presence of each kind, 0 to 1.
struct WrittenThings {
  std::vector<ReadoutText> readouts;
  double titleThere = 1, notesThere = 1, readoutsThere = 1;
};

/// Returns a block for each place with text: title, notes, read-outs and the note on exaggerated angles, in this
/// order. That note is present all the time. Text that is absent keeps its place.
std::vector<NoteBlock> pictureBlocks(const scene::Scene& scene, const WrittenThings& things, const Sizing& sizing,
                                     double room_px, const Palette& colors);

/// Returns a panel's title and subtitle; a block without rows if both are empty.
NoteBlock headingBlock(const scene::View& view, const Sizing& sizing, double room_px, const Palette& colors);

}  // namespace poinsot::stage

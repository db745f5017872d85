// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/type/lettering.h"
#include "stage/type/note_layout.h"
#include "stage/type/readout_board.h"

/// Rows of text for a picture. A row wider than `room_px` is set smaller.
namespace poinsot::stage {

/// Returns the room between the picture's edges and its text, px.
double noteEdge_px(const Sizing& sizing);

/// Read-outs of a picture at an instant, and the presence of title, notes and read-outs, from 0 to 1.
struct WrittenThings {
  std::vector<ReadoutText> readouts;
  double titleThere = 1, notesThere = 1, readoutsThere = 1;
};

/// Returns a block of text for each position that has text. The order in a block is title, notes, read-outs and
/// the note on exaggerated angles, which is always present. Other text keeps its position while it is absent.
std::vector<NoteBlock> pictureBlocks(const scene::Scene& scene, const WrittenThings& things, const Sizing& sizing,
                                     double room_px, const Palette& colors);

/// Returns a panel's title and subtitle. The block has no rows if both are empty.
NoteBlock headingBlock(const scene::View& view, const Sizing& sizing, double room_px, const Palette& colors);

}  // namespace poinsot::stage

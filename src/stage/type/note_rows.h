// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scene/scene.h"
#include "stage/palette.h"
#include "stage/type/lettering.h"
#include "stage/type/note_layout.h"
#include "stage/type/readout_board.h"

/// What is written into a picture, as rows of type. A row wider than `room_px` is set smaller.
namespace poinsot::stage {

/// What stands between the picture's edges and its type, px.
double noteEdge_px(const Sizing& sizing);

/// What is written at an instant, and how much of each kind is there, 0 to 1.
struct WrittenThings {
  std::vector<ReadoutText> readouts;
  double titleThere = 1, notesThere = 1, readoutsThere = 1;
};

/// Title, notes and read-outs, and what is not to scale, which is said all the time: a block for each place that
/// has any, in this order. What is not there keeps its place.
std::vector<NoteBlock> pictureBlocks(const scene::Scene& scene, const WrittenThings& things, const Sizing& sizing,
                                     double room_px, const Palette& colors);

/// A panel's title and subtitle; no rows without them.
NoteBlock headingBlock(const scene::View& view, const Sizing& sizing, double room_px, const Palette& colors);

}  // namespace poinsot::stage

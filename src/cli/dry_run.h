// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "job/render_request.h"

/// Output of `render` and `sweep` with --dry-run, and lists of shards.
namespace poinsot::cli {

/// Prints what the render would make. For a shard, or with --resume, also prints the number of frames that already
/// exist.
/// @returns an exit code. @throws core::Error(kPhysics) if the scene shows something that its motion lacks.
int describe(const job::RenderRequest& request);

/// Prints the shards with missing segments, such as "2,7-9", where request.shard gives the number of shards.
/// Prints an empty line if the segments only need joining. @returns kDone if the output is complete, else kNo.
int listShardsLeft(const job::RenderRequest& request);

/// Returns whether nothing of the film or sequence is left to make or to join.
bool isComplete(const job::RenderRequest& request);

bool isShardOfFinishedFilm(const job::RenderRequest& request);

/// Returns a note if a shard cannot store its compiled shaders for the next shard. Otherwise, the text is empty.
std::string shaderCacheNote(const job::RenderRequest& request);

}  // namespace poinsot::cli

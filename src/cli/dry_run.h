// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "job/render_request.h"

/// Decisions and messages of `render` and `sweep` that concern shards only.
namespace poinsot::cli {

/// Prints what the render would make and, of a shard or with --resume, how much of it is there already.
/// @returns an exit code. @throws core::Error(kPhysics) if the motion lacks something.
int describe(const job::RenderRequest& request);

/// Prints which of the n shards of request.shard have segments to make: "2,7-9". An empty line if only the joining
/// is left. @returns kDone if the output is complete, else kNo.
int listShardsLeft(const job::RenderRequest& request);

/// Returns whether the film of this shard is there already, so that nothing is left to make.
bool isShardOfFinishedFilm(const job::RenderRequest& request);

/// Returns a line if the shard cannot keep its compiled shaders for the next one; else an empty string.
std::string shaderCacheNote(const job::RenderRequest& request);

}  // namespace poinsot::cli

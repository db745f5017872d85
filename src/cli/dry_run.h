// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "job/render_request.h"

/// Parts of `render` and `sweep` for --dry-run and shards.
namespace poinsot::cli {

/// Prints what the render would make and, for a shard or with --resume, how many frames exist already.
/// @returns an exit code. @throws core::Error(kPhysics) if the motion lacks something.
int describe(const job::RenderRequest& request);

/// Prints which of the n shards of request.shard have segments to make, such as "2,7-9", or an empty line if the
/// segments only need joining. @returns kDone if the output is complete, else kNo.
int listShardsLeft(const job::RenderRequest& request);

bool isShardOfFinishedFilm(const job::RenderRequest& request);

/// Returns a note if the shard cannot keep its compiled shaders for the next one; else an empty string.
std::string shaderCacheNote(const job::RenderRequest& request);

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/render_options.h"
#include "cli/untrusted.h"
#include "job/render_job.h"

namespace poinsot::cli {

/// How a film or a sequence is made in parts, as typed.
struct PartsOptions {
  bool resume = false, keep = false;
  std::int64_t segmentFrames = request::kSegmentFrames;
  std::string shard, manifest;
  int shardsLeft = 0;  ///< only tells which of so many shards have work left
};

/// What it touches. @param target  where it was named; else `out` is made.
FileAccess accessOf(const RenderOptions& options, const std::optional<request::OutputTarget>& target);

/// A film, a sequence or a picture to make: scene, target and frames.
struct RequestedFilm {
  request::RequestedScene scene;
  request::OutputTarget target;
  request::FrameRange frames;
};

/// What can be refused before anything is drawn: a film of no such format, files that stand where it would go.
/// Makes the folder of an output that was not named, unless this is a dry run.
/// @returns the files of the run so far: inputs, the output and its subtitles.
/// @throws core::Error
output::RunFiles checkMakeable(const RenderOptions& options, const RequestedFilm& film,
                               const request::PictureOptions& form);

/// The last part of `render`, `still` and `sweep`: checks the target, then makes it (with --dry-run prints what
/// would be made), showing progress and what was asked for besides.
/// @param choices  what the command chooses besides the options
/// @throws core::Error, process::Interrupted
int renderTo(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
             const PartsOptions& parts = {});

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "cli/render_options.h"
#include "cli/untrusted.h"
#include "job/render_job.h"

namespace poinsot::cli {

/// Options for making a film or sequence in parts, as the user typed them.
struct PartsOptions {
  bool resume = false, keep = false;
  std::int64_t segmentFrames = request::kSegmentFrames;
  std::string shard, manifest;
  int shardsLeft = 0;  ///< if not 0, only lists the unfinished of this many shards
};

/// Returns whether a render prints notes, which --quiet and --progress=json leave out.
bool printsNotes(const RenderOptions& options);

/// Returns the files that a render reads and writes. @param target  the named output; nullopt for a default in
/// out/
FileAccess accessOf(const RenderOptions& options, const std::optional<request::OutputTarget>& target);

struct RequestedFilm {
  request::RequestedScene scene;
  request::OutputTarget target;
  request::FrameRange frames;
};

/// Checks everything that can fail before drawing, such as the film's format. Creates the default folder of the
/// output, except in a dry run.
/// @returns the files of the run so far: inputs, the output and its subtitles.
/// @throws core::Error
output::RunFiles checkMakeable(const RenderOptions& options, const RequestedFilm& film,
                               const request::PictureOptions& form);

/// Returns the render that renderTo() would make. @throws core::Error
job::RenderRequest renderOf(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
                            const PartsOptions& parts);

/// Checks the target, renders and shows progress: the last part of `render`, `still` and `sweep`. With --dry-run,
/// only prints what the render would make.
/// @param choices  settings that the command makes in addition to the options
/// @throws core::Error, process::Interrupted
int renderTo(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
             const PartsOptions& parts = {});

/// Renders a film like renderTo(), but writes and prints nothing if `choices.accepted` does not contain its size.
/// @throws core::Error, process::Interrupted
job::RenderSummary renderWithin(const RenderOptions& options, RequestedFilm film, job::RenderChoices choices,
                                const PartsOptions& parts);

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::request {

/// Frames first to last, both included; numbers count from the scene's frame 0.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = 0;

  std::int64_t count() const { return last - first + 1; }
  friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// Frames of a segment, the unit of work, unless the user says otherwise. Its borders lie at absolute frame
/// numbers, so that workers, shards and resume never move them: each is encoded by itself. 30 frames are a second
/// at 30 fps: short enough that workers end together, long enough that the one key frame per segment costs little
/// (films measured 0.9 % larger than with 60).
inline constexpr std::int64_t kSegmentFrames = 30;

/// "A-B" or "A", as written after --frames.
/// @throws core::Error(kUsage) if it is neither, or if B < A.
FrameRange parseFrameRange(std::string_view text);

/// The frames to make of a film of `frameCount` frames: all, or those asked for.
/// @throws core::Error(kUsage) if the film lacks one of them.
FrameRange selectFrames(std::int64_t frameCount, const std::optional<FrameRange>& asked);

/// The segments that hold `frames`, in order; the first and the last may be cut short by the range.
std::vector<FrameRange> segmentsOf(const FrameRange& frames, std::int64_t segmentFrames = kSegmentFrames);

/// Returns how many frames the ranges have together.
std::int64_t framesIn(const std::vector<FrameRange>& ranges);

/// Which part of the work a process does: the k-th of n, from 1.
struct Shard {
  int k = 1, n = 1;
};

/// Of one film.
inline constexpr int kMostShards = 100'000;

/// "k/n". @throws core::Error(kUsage).
Shard parseShard(std::string_view text);

/// The shard's own: every n-th, so that shards are of one size wherever the film is costly.
std::vector<FrameRange> segmentsOf(const Shard& shard, const std::vector<FrameRange>& segments);

}  // namespace poinsot::request

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::request {

/// Range of frames, first to last, both included. Numbers count from the scene's frame 0.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = 0;

  std::int64_t count() const { return last - first + 1; }
  friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// Default number of frames in a segment, the unit of work. Segments are encoded separately and their borders lie
/// at absolute frame numbers, so workers, shards and resuming never move a border. At 30 fps a segment is a
/// second: short enough that workers finish together, long enough that one key frame per segment costs little
/// (films measured 0.9 % larger than with 60 frames).
inline constexpr std::int64_t kSegmentFrames = 30;

/// Parses a frame range "A-B" or a single frame "A", as written after --frames.
/// @throws core::Error(kUsage) if the text has another form, or if B < A.
FrameRange parseFrameRange(std::string_view text);

/// Returns `asked`, or all frames of the film if `asked` is empty.
/// @param frameCount  frames of the film
/// @throws core::Error(kUsage) if `asked` goes beyond the film.
FrameRange selectFrames(std::int64_t frameCount, const std::optional<FrameRange>& asked);

/// Returns the segments that cover `frames`, in order. The range may cut the first and the last segment short.
std::vector<FrameRange> segmentsOf(const FrameRange& frames, std::int64_t segmentFrames = kSegmentFrames);

std::int64_t framesIn(const std::vector<FrameRange>& ranges);

/// Share of the work that one process does: part k of n, counted from 1.
struct Shard {
  int k = 1, n = 1;
};

inline constexpr int kMostShards = 100'000;

/// Parses a shard "k/n", where 1 <= k <= n <= kMostShards.
/// @throws core::Error(kUsage) for any other text.
Shard parseShard(std::string_view text);

/// Returns the segments of one shard: every n-th. Costly parts of a film are thus spread over all shards.
std::vector<FrameRange> segmentsOf(const Shard& shard, const std::vector<FrameRange>& segments);

}  // namespace poinsot::request

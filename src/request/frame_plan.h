// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::request {

/// Range of frames from `first` to `last`, both included. The first frame of the film has the number 0.
struct FrameRange {
  std::int64_t first = 0;
  std::int64_t last = 0;

  std::int64_t count() const { return last - first + 1; }
  friend bool operator==(const FrameRange&, const FrameRange&) = default;
};

/// Default number of frames in a segment. A segment is the part of a film that a worker draws and encodes
/// separately. Segments begin at multiples of this number, so that they do not depend on workers, shards or
/// resuming. At 30 fps a segment has one second. It is short enough that workers finish at about the same time,
/// and long enough that its key frame costs little: films were measured to be 0.9 % larger than with 60 frames.
inline constexpr std::int64_t kSegmentFrames = 30;

/// Parses the value of --frames: a range "A-B" or a single frame "A".
/// @throws core::Error(kUsage) if the text has another form, or if B < A.
FrameRange parseFrameRange(std::string_view text);

/// Returns the requested frames, or all frames of the film if none are requested.
/// @param frameCount  number of frames in the film
/// @throws core::Error(kUsage) if `asked` goes beyond the film.
FrameRange selectFrames(std::int64_t frameCount, const std::optional<FrameRange>& asked);

/// Returns the segments that contain `frames`, in order. The first and the last segment are shorter if `frames`
/// does not begin or end at the border of a segment.
std::vector<FrameRange> segmentsOf(const FrameRange& frames, std::int64_t segmentFrames = kSegmentFrames);

std::int64_t framesIn(const std::vector<FrameRange>& ranges);

/// Part of a film that one of several processes makes: part k of n, counted from 1.
struct Shard {
  int k = 1, n = 1;
};

inline constexpr int kMostShards = 100'000;

/// Parses the value of --shard, "k/n" with 1 <= k <= n <= kMostShards.
/// @throws core::Error(kUsage) for any other text.
Shard parseShard(std::string_view text);

/// Returns the segments of one shard, which are every n-th segment of the film. Parts of the film that take long
/// to draw are thus divided among all shards.
std::vector<FrameRange> segmentsOf(const Shard& shard, const std::vector<FrameRange>& segments);

}  // namespace poinsot::request

// SPDX-License-Identifier: Apache-2.0
#include "request/frame_plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/expect.h"
#include "core/number.h"
#include "core/text.h"

namespace poinsot::request {
namespace {

std::optional<std::int64_t> parseFrameNumber(std::string_view text) {
  return text.starts_with('-') ? std::nullopt : core::parseInteger<std::int64_t>(text);
}

[[noreturn]] void refuseFrames(std::string_view frames, std::string_view why) {
  throw core::usageError(fmt::format("--frames '{}': {}", core::printable(frames), why));
}

}  // namespace

FrameRange parseFrameRange(std::string_view text) {
  const auto dash = text.find('-');
  const auto first = parseFrameNumber(text.substr(0, dash));
  const auto last = dash == std::string_view::npos ? first : parseFrameNumber(text.substr(dash + 1));
  if (!first || !last) refuseFrames(text, "frames are A-B, both included, such as 0-59, or one number");
  if (*last < *first)
    refuseFrames(text, fmt::format("the first frame, {}, comes after the last, {}", *first, *last));
  return FrameRange{*first, *last};
}

FrameRange selectFrames(std::int64_t frameCount, const std::optional<FrameRange>& asked) {
  POINSOT_EXPECT(frameCount > 0);
  const FrameRange frames = asked.value_or(FrameRange{0, frameCount - 1});
  if (frames.last >= frameCount)
    throw core::usageError(
        fmt::format("--frames {}-{}: the film has frames 0 to {}", frames.first, frames.last, frameCount - 1));
  return frames;
}

std::vector<FrameRange> segmentsOf(const FrameRange& frames, std::int64_t segmentFrames) {
  POINSOT_EXPECT(segmentFrames > 0);
  std::vector<FrameRange> segments;
  for (std::int64_t first = frames.first; first <= frames.last;) {
    const std::int64_t border = (first / segmentFrames + 1) * segmentFrames;
    segments.push_back({first, std::min(border - 1, frames.last)});
    first = border;
  }
  return segments;
}

std::int64_t framesIn(const std::vector<FrameRange>& ranges) {
  std::int64_t frames = 0;
  for (const FrameRange& range : ranges) frames += range.count();
  return frames;
}

Shard parseShard(std::string_view text) {
  const auto slash = text.find('/');
  const auto k = parseFrameNumber(text.substr(0, slash));
  const auto n = slash == std::string_view::npos ? std::nullopt : parseFrameNumber(text.substr(slash + 1));
  if (!k || !n || *k < 1 || *k > *n || *n > kMostShards)
    throw core::usageError(fmt::format(
        "--shard '{}': a shard is k/n, such as 2/7 for part 2 of 7; k must be from 1 to n, and n at most {}",
        core::printable(text), kMostShards));
  return {static_cast<int>(*k), static_cast<int>(*n)};
}

std::vector<FrameRange> segmentsOf(const Shard& shard, const std::vector<FrameRange>& segments) {
  std::vector<FrameRange> own;
  for (auto i = static_cast<std::size_t>(shard.k - 1); i < segments.size(); i += static_cast<std::size_t>(shard.n))
    own.push_back(segments[i]);
  return own;
}

}  // namespace poinsot::request

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "core/step_times.h"
#include "image/png_file.h"
#include "output/frame_pattern.h"
#include "output/frame_sink.h"

namespace poinsot::output {

/// Writes one picture, atomic; `dpi` as in encodePng. `steps`: where the time is entered. @throws
/// core::Error(kIo).
void writePng(const std::filesystem::path& target, const image::AnyImage& picture,
              const std::vector<image::PngText>& texts = {}, double dpi = 0, core::StepLedger* steps = nullptr,
              core::Durability durability = core::Durability::kSynced);

/// What a frame's file says of its own digest: hexadecimal.
image::PngText digestText(const std::string& digest);

/// Of a frame, in hexadecimal: equal for frames of equal bytes.
using FrameDigestText = std::function<std::string(std::int64_t k)>;

struct SequenceOptions {
  std::vector<image::PngText> texts;      ///< of every frame
  FrameDigestText digestOf;               ///< each frame's file carries it; empty: none
  bool resume = false;                    ///< a whole file with the frame's digest is the frame
  std::filesystem::path temporaryFolder;  ///< for what is not complete; empty: beside the frames
  core::StepLedger* steps = nullptr;      ///< where the time is entered
};

/// Returns the numbers, in order, of the frames of a pattern that are there and carry a digest.
std::vector<std::int64_t> framesThere(const FramePattern& pattern);

/// Frames as numbered PNG files of 8 or 16 bits a sample, each appearing under its name only when complete.
/// Frames already written stay if the sink is destroyed without finish(): each is whole, and a resumed run keeps
/// it.
class PngSequence : public FrameSink {
 public:
  /// Creates the pattern's folder if its parent exists. @throws core::Error(kIo).
  explicit PngSequence(FramePattern pattern, SequenceOptions options = {});

  bool has(std::int64_t k) const override;
  void write(const image::Frame& frame, std::int64_t k) override;
  /// Syncs files and folder once: a sync per frame would wait for the disk each time.
  void finish() override;

 private:
  FramePattern pattern_;
  SequenceOptions options_;
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace poinsot::output

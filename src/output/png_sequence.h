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

/// Writes one picture as a file that appears only when complete. `dpi` is as in encodePng(), and `steps` receives
/// the time if it is not null. @throws core::Error(kIo).
void writePng(const std::filesystem::path& target, const image::AnyImage& picture,
              const std::vector<image::PngText>& texts = {}, double dpi = 0, core::StepLedger* steps = nullptr,
              core::Durability durability = core::Durability::kSynced);

/// Returns the PNG text that stores a frame's digest, given in hexadecimal.
image::PngText digestText(const std::string& digest);

/// Function that returns the digest of frame k in hexadecimal, equal for frames of equal bytes.
using FrameDigestText = std::function<std::string(std::int64_t k)>;

struct SequenceOptions {
  std::vector<image::PngText> texts;
  FrameDigestText digestOf;               ///< the digest written into each frame's file; empty if none
  bool resume = false;                    ///< keeps files that are complete and have the frame's digest
  std::filesystem::path temporaryFolder;  ///< for incomplete files; empty: beside the frames
  core::StepLedger* steps = nullptr;
};

/// Returns the sorted numbers of the existing frames that match a pattern and carry a digest.
std::vector<std::int64_t> framesThere(const FramePattern& pattern);

/// Frames as numbered PNG files of 8 or 16 bits a sample. Each file appears under its name only when complete. If
/// the sink is destroyed without finish(), written frames stay: each is complete, and a resumed run keeps it.
class PngSequence : public FrameSink {
 public:
  /// Creates the pattern's folder if its parent exists. @throws core::Error(kIo).
  explicit PngSequence(FramePattern pattern, SequenceOptions options = {});

  bool has(std::int64_t k) const override;
  void write(const image::Frame& frame, std::int64_t k) override;
  /// Syncs the files and the folder once, because a sync for each frame would wait for the disk each time.
  void finish() override;

 private:
  FramePattern pattern_;
  SequenceOptions options_;
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace poinsot::output

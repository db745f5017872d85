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

/// Writes a picture as a PNG file, which gets its name only when it is complete.
/// @param dpi  resolution, as in encodePng()
/// @param steps  receives the time; may be null
/// @throws core::Error(kIo).
void writePng(const std::filesystem::path& target, const image::AnyImage& picture,
              const std::vector<image::PngText>& texts = {}, double dpi = 0, core::StepLedger* steps = nullptr,
              core::Durability durability = core::Durability::kSynced);

/// Returns the PNG text that stores a frame's digest, given in hexadecimal.
image::PngText digestText(const std::string& digest);

/// Callback that returns the digest of frame k in hexadecimal. Frames of equal bytes have equal digests.
using FrameDigestText = std::function<std::string(std::int64_t k)>;

struct SequenceOptions {
  std::vector<image::PngText> texts;
  FrameDigestText digestOf;               ///< returns the digest to store in each file; may be empty
  bool resume = false;                    ///< whether to keep complete files with the frame's digest
  std::filesystem::path temporaryFolder;  ///< for incomplete files; empty: the folder of the frames
  core::StepLedger* steps = nullptr;
};

/// Returns the numbers of the existing frames that match a pattern and contain a digest, in rising order.
std::vector<std::int64_t> framesThere(const FramePattern& pattern);

/// Writes frames as numbered PNG files of 8 or 16 bits a sample. Each file gets its name only when it is complete.
/// If the sink is destroyed without finish(), the written files stay, and a resumed run keeps them.
class PngSequence : public FrameSink {
 public:
  /// Creates the pattern's folder if its parent exists. @throws core::Error(kIo).
  explicit PngSequence(FramePattern pattern, SequenceOptions options = {});

  bool has(std::int64_t k) const override;
  void write(const image::Frame& frame, std::int64_t k) override;
  /// Syncs all files and their folder once. A sync for each frame would wait for the disk each time.
  void finish() override;

 private:
  FramePattern pattern_;
  SequenceOptions options_;
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace poinsot::output

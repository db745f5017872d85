// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "image/png_file.h"
#include "output/frame_pattern.h"
#include "output/frame_sink.h"

namespace poinsot::output {

/// One picture, atomic and durable; `dpi` as in encodePng. @throws core::Error(kIo).
void writePng(const std::filesystem::path& target, const image::Image& picture,
              const std::vector<image::PngText>& texts = {}, double dpi = 0);

/// Frames as numbered PNG files, each appearing under its name only when complete.
/// Frames already written stay if the sink is destroyed without finish(): each is whole, and a resumed run keeps
/// it.
class PngSequence : public FrameSink {
 public:
  /// Creates the pattern's folder if its parent exists. @throws core::Error(kIo).
  explicit PngSequence(FramePattern pattern, std::vector<image::PngText> texts = {});

  void write(const image::Image& picture, std::int64_t k) override;
  /// Syncs files and folder once: a sync per frame would wait for the disk each time.
  void finish() override;

 private:
  FramePattern pattern_;
  std::vector<image::PngText> texts_;
  std::vector<std::filesystem::path> unsynced_;
};

}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/frame_plan.h"

namespace poinsot::app {

/// A file that a segment consists of: the piece of film, or a frame's picture.
struct RecordedFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::string sha256;

  friend bool operator==(const RecordedFile&, const RecordedFile&) = default;
};

/// What is kept beside a finished segment, so that another render can tell whether it is its own.
struct SegmentRecord {
  FrameRange frames;
  std::string job;                   ///< jobDigest() of the render that made it, or last found it good
  std::string renderer;              ///< GL_RENDERER of the process that drew it
  std::vector<std::string> digests;  ///< of each frame
  std::vector<RecordedFile> files;

  friend bool operator==(const SegmentRecord&, const SegmentRecord&) = default;
};

/// The file as it is on disk. @throws core::Error(kIo) if it cannot be read.
RecordedFile recordOf(const std::filesystem::path& file);

/// How a segment stands.
enum class SegmentState {
  kDone,
  kMissing,
  kStale,    ///< whole, but made for another scene or with other settings
  kCorrupt,  ///< a file is missing, or not as it was recorded
};

/// The records of a render's segments, each a file of JSON in the work folder.
class SegmentRecords {
 public:
  explicit SegmentRecords(std::filesystem::path workFolder) : folder_(std::move(workFolder)) {}

  /// Nothing where there is none, or what is there is no record of these frames.
  std::optional<SegmentRecord> find(const FrameRange& frames) const;
  /// Durable when it returns. @throws core::Error(kIo).
  void keep(const SegmentRecord& record) const;
  /// Its files are there, byte for byte.
  static bool isWhole(const SegmentRecord& record);
  /// How the segment stands for a render with that jobDigest().
  SegmentState stateOf(const FrameRange& frames, const std::string& job) const;

  std::filesystem::path fileOf(const FrameRange& frames) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "request/frame_plan.h"
#include "request/output_target.h"

namespace poinsot::job {

/// A file that a segment consists of: the piece of film, or a frame's picture.
struct RecordedFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::string sha256;

  friend bool operator==(const RecordedFile&, const RecordedFile&) = default;
};

/// What is kept beside a finished segment, so that another render can tell whether it is its own.
struct SegmentRecord {
  request::FrameRange frames;
  std::string jobDigest;             ///< jobDigest() of the render that made it, or last found it good
  std::string renderer;              ///< GL_RENDERER of the process that drew it
  std::vector<std::string> digests;  ///< of each frame
  std::vector<RecordedFile> files;

  friend bool operator==(const SegmentRecord&, const SegmentRecord&) = default;
};

/// The file as it is on disk. @throws core::Error(kIo) if it cannot be read or is no regular file.
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
  /// `target`: of the render, by which the names of its files are known.
  SegmentRecords(std::filesystem::path workFolder, request::OutputTarget target)
      : folder_(std::move(workFolder)), target_(std::move(target)) {}

  /// Nothing where there is none, or what is there is no record of these frames and of the files that they go to.
  std::optional<SegmentRecord> find(const request::FrameRange& frames) const;
  /// The same of a record's text.
  std::optional<SegmentRecord> parse(std::string_view text, const request::FrameRange& frames) const;
  /// Durable when it returns. @throws core::Error(kIo).
  void keep(const SegmentRecord& record) const;
  /// Its files are there, byte for byte.
  static bool isWhole(const SegmentRecord& record);
  /// How the segment stands for a render with that jobDigest().
  SegmentState stateOf(const request::FrameRange& frames, const std::string& job) const;

  std::filesystem::path fileOf(const request::FrameRange& frames) const;

 private:
  std::filesystem::path folder_;
  request::OutputTarget target_;
};

}  // namespace poinsot::job

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

struct RecordedFile {
  std::filesystem::path path;
  std::uint64_t bytes = 0;
  std::string sha256;

  friend bool operator==(const RecordedFile&, const RecordedFile&) = default;
};

/// Record of a finished segment, by which a later render decides whether to reuse the segment.
struct SegmentRecord {
  request::FrameRange frames;
  std::string jobDigest;             ///< jobDigest() of the render that made the segment or reused it last
  std::string renderer;              ///< GL_RENDERER of that render
  std::vector<std::string> digests;  ///< one digest per frame
  std::vector<RecordedFile> files;

  friend bool operator==(const SegmentRecord&, const SegmentRecord&) = default;
};

/// Returns the size and the SHA-256 of a file. @throws core::Error(kIo) unless it is a readable regular file
RecordedFile recordOf(const std::filesystem::path& file);

enum class SegmentState {
  kDone,
  kMissing,
  kStale,    ///< complete, but from another scene or other settings
  kCorrupt,  ///< a file is missing, or differs from its record
};

/// Records of a render's segments. Each record is a JSON file in the work folder.
class SegmentRecords {
 public:
  /// @param target  target of the render, which determines the file names
  SegmentRecords(std::filesystem::path workFolder, request::OutputTarget target)
      : folder_(std::move(workFolder)), target_(std::move(target)) {}

  /// Returns the record of a segment. Returns nullopt if the record is missing or malformed, or if its frames or
  /// files are not those of the segment.
  std::optional<SegmentRecord> find(const request::FrameRange& frames) const;
  /// Parses the text of a record. Returns nullopt in the same cases as find().
  std::optional<SegmentRecord> parse(std::string_view text, const request::FrameRange& frames) const;
  /// Writes a record, and syncs it. @throws core::Error(kIo).
  void keep(const SegmentRecord& record) const;
  /// Returns whether all files of the record exist and have the recorded bytes.
  static bool isWhole(const SegmentRecord& record);
  /// Returns the state of a segment.
  /// @param job  jobDigest() of the current render
  SegmentState stateOf(const request::FrameRange& frames, const std::string& job) const;

  std::filesystem::path fileOf(const request::FrameRange& frames) const;

 private:
  std::filesystem::path folder_;
  request::OutputTarget target_;
};

}  // namespace poinsot::job

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

/// Record beside a finished segment, from which another render decides whether it can reuse the segment.
struct SegmentRecord {
  request::FrameRange frames;
  std::string jobDigest;             ///< jobDigest() of the render that made or last reused the segment
  std::string renderer;              ///< GL_RENDERER of that render
  std::vector<std::string> digests;  ///< one per frame
  std::vector<RecordedFile> files;

  friend bool operator==(const SegmentRecord&, const SegmentRecord&) = default;
};

/// Returns the size and the SHA-256 of a file. @throws core::Error(kIo) if it cannot be read or is no regular
/// file.
RecordedFile recordOf(const std::filesystem::path& file);

enum class SegmentState {
  kDone,
  kMissing,
  kStale,    ///< whole, but made for another scene or with other settings
  kCorrupt,  ///< a file is missing, or differs from its record
};

/// Records of a render's segments, each a JSON file in the work folder.
class SegmentRecords {
 public:
  /// @param target  the render's target, which determines the names of the files
  SegmentRecords(std::filesystem::path workFolder, request::OutputTarget target)
      : folder_(std::move(workFolder)), target_(std::move(target)) {}

  /// Returns the record of a segment. Returns nullopt if the record is missing or malformed, or names other frames
  /// or files than the segment has.
  std::optional<SegmentRecord> find(const request::FrameRange& frames) const;
  /// Parses the text of a record. Returns nullopt as find().
  std::optional<SegmentRecord> parse(std::string_view text, const request::FrameRange& frames) const;
  /// Writes a record, which is durable when the function returns. @throws core::Error(kIo).
  void keep(const SegmentRecord& record) const;
  /// Returns whether all files of the record exist and have the recorded bytes.
  static bool isWhole(const SegmentRecord& record);
  /// Returns the state of a segment for a render.
  /// @param job  the render's jobDigest()
  SegmentState stateOf(const request::FrameRange& frames, const std::string& job) const;

  std::filesystem::path fileOf(const request::FrameRange& frames) const;

 private:
  std::filesystem::path folder_;
  request::OutputTarget target_;
};

}  // namespace poinsot::job

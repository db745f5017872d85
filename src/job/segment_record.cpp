// SPDX-License-Identifier: Apache-2.0
#include "job/segment_record.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <span>

#include "core/atomic_file.h"
#include "core/file_error.h"
#include "core/json.h"
#include "core/regular_file.h"
#include "core/sha256.h"
#include "core/text.h"
#include "job/job_record.h"

namespace poinsot::job {
namespace {

using Json = nlohmann::ordered_json;
using std::filesystem::path;

[[noreturn]] void cannotRead(const path& file) {
  const int code = errno;
  throw core::FileError(
      core::ErrorKind::kIo,
      fmt::format("cannot read {}: {}", core::printable(file.native()), core::systemReason(code)), file, code);
}

// Returns a path relative to the work folder, because a user may move or mount the folder and the frames
// elsewhere.
std::string nameOf(const path& file, const path& folder) {
  return core::utf8FromBytes(file.lexically_relative(folder).native());
}

Json toJson(const SegmentRecord& record, const path& folder) {
  Json files = Json::array();
  for (const RecordedFile& file : record.files)
    files.push_back({{"path", nameOf(file.path, folder)}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return {{"frames", {record.frames.first, record.frames.last}},
          {"job", record.jobDigest},
          {"renderer", record.renderer},
          {"digests", record.digests},
          {"files", std::move(files)}};
}

/// Reads a record from JSON. Does not read the file paths; parse() checks them.
SegmentRecord fromJson(const Json& json) {
  SegmentRecord record;
  record.frames = {core::wholeNumber(json.at("frames").at(0)), core::wholeNumber(json.at("frames").at(1))};
  record.jobDigest = json.at("job").get<std::string>();
  record.renderer = json.at("renderer").get<std::string>();
  record.digests = json.at("digests").get<std::vector<std::string>>();
  for (const Json& file : json.at("files"))
    record.files.push_back({{},
                            static_cast<std::uint64_t>(core::wholeNumber(file.at("bytes"))),
                            file.at("sha256").get<std::string>()});
  return record;
}

}  // namespace

RecordedFile recordOf(const path& file) {
  const core::FileHandle handle = core::openForReading(file);
  struct stat status {};
  if (!handle || ::fstat(handle.get(), &status) != 0) cannotRead(file);
  if (!S_ISREG(status.st_mode)) throw core::ioError(core::printable(file.native()) + " is not a regular file");
  core::Sha256 sum;
  RecordedFile record;
  record.path = file;
  std::array<std::byte, 64 << 10> buffer{};
  for (;;) {
    const ssize_t count = ::read(handle.get(), buffer.data(), buffer.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) cannotRead(file);
    if (count == 0) break;
    sum.add(std::span(buffer).first(static_cast<std::size_t>(count)));
    record.bytes += static_cast<std::uint64_t>(count);
  }
  record.sha256 = core::toHex(sum.finish());
  return record;
}

path SegmentRecords::fileOf(const request::FrameRange& frames) const {
  return folder_ / fmt::format("segment-{:09}-{:09}.json", frames.first, frames.last);
}

std::optional<SegmentRecord> SegmentRecords::parse(std::string_view text, const request::FrameRange& frames) const
    try {
  const Json json = core::parseJson(text);
  SegmentRecord record = fromJson(json);
  if (record.frames != frames || static_cast<std::int64_t>(record.digests.size()) != frames.count())
    return std::nullopt;
  const std::vector<path> files = segmentFiles(folder_, target_, frames);
  if (record.files.size() != files.size()) return std::nullopt;
  // A record may come from an untrusted source. Rejects paths of files outside the segment.
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (json.at("files").at(i).at("path").get<std::string>() != nameOf(files[i], folder_)) return std::nullopt;
    record.files[i].path = files[i];
  }
  return record;
} catch (const core::Error&) {
  return std::nullopt;
} catch (const nlohmann::json::exception&) {
  return std::nullopt;
}

std::optional<SegmentRecord> SegmentRecords::find(const request::FrameRange& frames) const try {
  return parse(core::readRegularFile(fileOf(frames), core::kMostJsonBytes, core::ErrorKind::kIo), frames);
} catch (const core::Error&) {
  return std::nullopt;
}

void SegmentRecords::keep(const SegmentRecord& record) const {
  const std::string text = toJson(record, folder_).dump() + "\n";
  core::writeFileAtomically(fileOf(record.frames), text);
}

bool SegmentRecords::isWhole(const SegmentRecord& record) {
  for (const RecordedFile& file : record.files) {
    try {
      if (recordOf(file.path) != file) return false;
    } catch (const core::Error&) {
      return false;
    }
  }
  return true;
}

SegmentState SegmentRecords::stateOf(const request::FrameRange& frames, const std::string& job) const {
  const auto record = find(frames);
  if (!record) return SegmentState::kMissing;
  if (!isWhole(*record)) return SegmentState::kCorrupt;
  return record->jobDigest == job ? SegmentState::kDone : SegmentState::kStale;
}

}  // namespace poinsot::job

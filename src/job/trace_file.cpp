// SPDX-License-Identifier: Apache-2.0
#include "job/trace_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/version.h"

namespace poinsot::job {
namespace {

constexpr std::size_t kEnough_bytes = 64 << 10;

enum class Row { kJob = 1, kSegments, kPictures, kFiles };

// Returns the row of a worker's span in the trace. The main process uses only the row kJob.
Row rowOf(std::string_view name) {
  using core::Step;
  constexpr std::array kFileSteps{Step::kConvert, Step::kEncode, Step::kWrite};
  const auto isIt = [&](Step step) { return name == core::nameOf(step); };
  if (name == "segment") return Row::kSegments;
  return std::ranges::any_of(kFileSteps, isIt) ? Row::kFiles : Row::kPictures;
}

std::string us(std::int64_t ns) { return fmt::format("{}.{:03}", ns / 1000, ns % 1000); }

std::string metadata(int process, const char* what, Row row, std::string_view name) {
  return fmt::format(R"({{"ph":"M","pid":{},"tid":{},"name":"{}","args":{{"name":"{}"}}}})", process,
                     static_cast<int>(row), what, name);
}

constexpr const char* kMark = R"({"otherData":{"program":"poinsot )";

}  // namespace

output::FileKind traceKind() { return output::textKind("a trace", kMark); }

TraceFile::TraceFile(const std::filesystem::path& target, const std::filesystem::path& folder)
    : start_ns_(core::monotonic_ns()),
      file_(target, core::folderOf(target) == core::folderOf(folder) ? folder : std::filesystem::path()),
      text_(kMark + std::string(core::version()) + R"("},"traceEvents":[)") {}

void TraceFile::add(int process, const core::Span& span) {
  introduce(process);
  const Row row = process == kParentProcess ? Row::kJob : rowOf(span.name);
  const std::string frame = span.frame ? fmt::format(R"("frame":{})", *span.frame) : "";
  addEvent(fmt::format(R"({{"ph":"X","pid":{},"tid":{},"ts":{},"dur":{},"name":"{}","args":{{{}}}}})", process,
                       static_cast<int>(row), us(span.begin_ns - start_ns_), us(span.end_ns - span.begin_ns),
                       span.name, frame));
}

void TraceFile::introduce(int process) {
  if (!introduced_.insert(process).second) return;
  const bool parent = process == kParentProcess;
  addEvent(metadata(process, "process_name", Row::kJob, parent ? "render" : fmt::format("worker {}", process)));
  if (parent) return addEvent(metadata(process, "thread_name", Row::kJob, "job"));
  addEvent(metadata(process, "thread_name", Row::kSegments, "segments"));
  addEvent(metadata(process, "thread_name", Row::kPictures, "pictures"));
  addEvent(metadata(process, "thread_name", Row::kFiles, "files"));
}

void TraceFile::addEvent(const std::string& event) {
  text_ += empty_ ? "\n" : ",\n";
  text_ += event;
  empty_ = false;
  if (text_.size() >= kEnough_bytes) flush();
}

void TraceFile::flush() {
  file_.write({reinterpret_cast<const std::uint8_t*>(text_.data()), text_.size()});
  text_.clear();
}

core::AtomicFile TraceFile::finish() {
  text_ += "\n]}\n";
  flush();
  return std::move(file_);
}

}  // namespace poinsot::job

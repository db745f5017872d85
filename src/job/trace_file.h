// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>

#include "core/atomic_file.h"
#include "core/step_times.h"
#include "output/file_kind.h"

namespace poinsot::job {

output::FileKind traceKind();

/// Number of the parent process in a trace; workers have numbers from 1.
inline constexpr int kParentProcess = 0;

/// Trace of a render's processes in Chrome's trace format, which chrome://tracing and ui.perfetto.dev show. Events
/// are written as they arrive, so a long trace needs no more memory.
class TraceFile {
 public:
  /// Starts a trace; times count from this call. Until complete, the file lies in `folder` if that is beside the
  /// target.
  /// @throws core::Error(kIo), as do the members below.
  TraceFile(const std::filesystem::path& target, const std::filesystem::path& folder);

  void add(int process, const core::Span& span);
  /// Completes the file. @returns the file, which still has its temporary name
  core::AtomicFile finish();

 private:
  void addEvent(const std::string& event);
  void introduce(int process);
  void flush();

  std::int64_t start_ns_;
  core::AtomicFile file_;
  std::string text_;
  bool empty_ = true;
  std::set<int> introduced_;
};

}  // namespace poinsot::job

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

/// Number of the main process in a trace. Workers are numbered from 1.
inline constexpr int kParentProcess = 0;

/// Trace of the processes of a render, in Chrome's trace format. Open the file in chrome://tracing or
/// ui.perfetto.dev. Events are written as they arrive, so the memory does not grow with the trace.
class TraceFile {
 public:
  /// Starts a trace, whose times count from this call. The temporary file is in `folder` if that is beside the
  /// target, otherwise in the target's folder.
  /// @throws core::Error(kIo); all members below throw the same.
  TraceFile(const std::filesystem::path& target, const std::filesystem::path& folder);

  void add(int process, const core::Span& span);
  /// Completes the trace. @returns the file, still under its temporary name
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

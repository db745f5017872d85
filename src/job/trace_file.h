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

/// Traces of this program.
output::FileKind traceKind();

/// The process that hands out the work; workers have numbers from 1.
inline constexpr int kParentProcess = 0;

/// What each process of a render did when, as a Chrome trace, which chrome://tracing and ui.perfetto.dev show.
/// Written as it comes, so that it takes no memory.
class TraceFile {
 public:
  /// Times are told from now on. It lies in `folder` until it is complete, where that is beside it.
  /// @throws core::Error(kIo), as do the members below.
  TraceFile(const std::filesystem::path& target, const std::filesystem::path& folder);

  void add(int process, const core::Span& span);
  /// Writes the end. @returns the complete file, which has no name yet.
  core::AtomicFile finish();

 private:
  void addEvent(const std::string& event);
  /// Says what the rows of this process are called, once.
  void introduce(int process);
  void flush();

  std::int64_t start_ns_;
  core::AtomicFile file_;
  std::string text_;  // not yet written
  bool empty_ = true;
  std::set<int> introduced_;
};

}  // namespace poinsot::job

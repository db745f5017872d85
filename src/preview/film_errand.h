// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/file_handle.h"

namespace poinsot::preview {

struct FilmState {
  enum class Stage { kNone, kMaking, kReady, kFailed };
  Stage stage = Stage::kNone;
  std::int64_t done = 0, total = 0;  ///< frames
  std::string text;                  ///< messages of the program
  std::vector<std::string> changes;  ///< changes that the page made to the scene, as the page lists them
};

/// Makes a film with `poinsot` in a process of its own, so that a failure does not end the preview. Makes one film
/// at a time. The destructor stops the process, which keeps its completed segments for --resume.
class FilmErrand {
 public:
  FilmErrand() = default;
  ~FilmErrand();
  FilmErrand(const FilmErrand&) = delete;
  FilmErrand& operator=(const FilmErrand&) = delete;

  /// @param words  arguments after "poinsot"
  /// @param changes  value of FilmState::changes
  /// @returns false if a film is being made already
  /// @throws core::Error(kGraphics) if no process can be started.
  bool start(const std::vector<std::string>& words, std::vector<std::string> changes);
  /// Interrupts the process with SIGINT, like Ctrl-C.
  void stop();
  FilmState state() const;

 private:
  void follow(const core::FileHandle& errors);

  mutable std::mutex mutex_;
  FilmState state_;
  pid_t process_ = -1;
  std::thread follower_;
};

}  // namespace poinsot::preview

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

/// Where the making of a film is.
struct FilmState {
  enum class Stage { kNone, kMaking, kReady, kFailed };
  Stage stage = Stage::kNone;
  std::int64_t done = 0, total = 0;  ///< frames
  std::string text;                  ///< once it ended: the program's last words
  std::vector<std::string> changes;  ///< that the page made to the scene, in the user's words
};

/// Makes a film by `poinsot` in a process of its own, so that the preview goes on whatever becomes of it.
/// One at a time. Destroying it asks the process to stop, which keeps what is complete for --resume.
class FilmErrand {
 public:
  FilmErrand() = default;
  ~FilmErrand();
  FilmErrand(const FilmErrand&) = delete;
  FilmErrand& operator=(const FilmErrand&) = delete;

  /// @param words  after "poinsot"
  /// @param changes  for FilmState
  /// @returns false where a film is being made.
  /// @throws core::Error(kGraphics) if no process can be started.
  bool start(const std::vector<std::string>& words, std::vector<std::string> changes);
  /// Like Ctrl-C in its terminal.
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

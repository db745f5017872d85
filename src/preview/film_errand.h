// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "preview/program_run.h"

namespace poinsot::preview {

struct FilmState {
  enum class Stage { kNone, kMaking, kReady, kFailed };
  Stage stage = Stage::kNone;
  std::int64_t done = 0, total = 0;  ///< number of frames
  std::string text;                  ///< messages that the program printed
  std::vector<std::string> changes;  ///< changes that the user made on the page, as text for the page
};

/// Maker of films for the preview, one film at a time. Runs `poinsot` in a separate process, so that a failure
/// does not end the preview. The destructor stops the process, which keeps its completed segments for --resume.
class FilmErrand {
 public:
  FilmErrand() = default;
  ~FilmErrand();
  FilmErrand(const FilmErrand&) = delete;
  FilmErrand& operator=(const FilmErrand&) = delete;

  /// @param words  arguments for poinsot
  /// @param changes  value of FilmState::changes
  /// @returns false if another film is still in progress
  /// @throws core::Error(kGraphics) if no process can be started.
  bool start(const std::vector<std::string>& words, std::vector<std::string> changes);
  /// Sends SIGINT to the process, as Ctrl-C does.
  void stop();
  FilmState state() const;

 private:
  void follow();

  mutable std::mutex mutex_;
  FilmState state_;
  std::unique_ptr<ProgramRun> run_;
  std::thread follower_;
};

}  // namespace poinsot::preview

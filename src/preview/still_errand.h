// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "preview/program_run.h"

namespace poinsot::preview {

/// Maker of single pictures and figures that the browser saves, one at a time. Runs `poinsot` in a separate
/// process and removes its files, so that nothing remains on this machine.
class StillErrand {
 public:
  /// Function that returns the arguments for poinsot, with `target` as the value of -o.
  using Words = std::function<std::vector<std::string>(const std::string& target)>;

  /// Makes a picture and returns the bytes of a file. @param target  name of the picture, without a folder
  /// @param file  name of the file to return: `target`, or another file of the same figure
  /// @returns nullopt if another picture is still in progress
  /// @throws core::Error(kUsage) with the messages of poinsot if the run fails; core::Error(kIo, kGraphics)
  std::optional<std::string> make(const std::string& target, const std::string& file, const Words& wordsFor);
  /// Interrupts the picture in progress. All later calls of make() fail. Any thread may call this function.
  void stop();

 private:
  std::shared_ptr<ProgramRun> start(const std::vector<std::string>& words);

  std::mutex turn_;   // held during make()
  std::mutex mutex_;  // of the members below
  std::shared_ptr<ProgramRun> run_;
  bool stopped_ = false;
};

}  // namespace poinsot::preview

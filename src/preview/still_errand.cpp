// SPDX-License-Identifier: Apache-2.0
#include "preview/still_errand.h"

#include "core/error.h"
#include "core/regular_file.h"
#include "core/temporary_folder.h"
#include "core/text.h"
#include "request/picture_options.h"

namespace poinsot::preview {

std::optional<std::string> StillErrand::make(const std::string& target, const std::string& file,
                                             const Words& wordsFor) {
  const std::unique_lock turn(turn_, std::try_to_lock);
  if (!turn) return std::nullopt;
  const core::TemporaryFolder folder;
  std::vector<std::string> words = wordsFor((folder.path() / target).string()), messages;
  words.insert(words.begin() + 1, "--quiet");
  const bool good =
      start(words)->wait([&](const std::string& line) { messages.push_back(core::printable(line)); });
  if (!good) throw core::usageError(core::joined(messages, "\n"));
  return core::readRegularFile(folder.path() / file, request::kMostPicture, core::ErrorKind::kIo);
}

std::shared_ptr<ProgramRun> StillErrand::start(const std::vector<std::string>& words) {
  const std::scoped_lock lock(mutex_);
  if (stopped_) throw core::usageError("the preview has ended");
  return run_ = std::make_shared<ProgramRun>(words);
}

void StillErrand::stop() {
  const std::scoped_lock lock(mutex_);
  stopped_ = true;
  if (run_) run_->interrupt();
}

}  // namespace poinsot::preview

// SPDX-License-Identifier: Apache-2.0
#include "preview/watched_scene.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <exception>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "stage/stage.h"

namespace poinsot::preview {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPause{40};
// A file that a scene names and that was missing may come: while there is a mistake, all is tried again.
constexpr int kPausesToTryAgain = 25;

/// Of files by name: changes when one is written, replaced or removed.
std::string fingerprint(const std::vector<std::filesystem::path>& files) {
  std::string all;
  for (const auto& file : files) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0)
      all += fmt::format("{}.{} {} {};", status.st_mtim.tv_sec, status.st_mtim.tv_nsec, status.st_size,
                         status.st_ino);
    else
      all += "none;";
  }
  return all;
}

std::vector<std::filesystem::path> filesOf(const std::string& fileName, const SceneVersion& version) {
  std::vector<std::filesystem::path> files{fileName};
  if (version.scene)
    for (const scene::InputFile& input : version.scene->inputs) files.push_back(input.place);
  return files;
}

}  // namespace

WatchedScene::WatchedScene(std::string fileName, std::vector<std::string> overrides, scene::Allowance allowance)
    : fileName_(std::move(fileName)), overrides_(std::move(overrides)), allowance_(std::move(allowance)) {
  read();
  watcher_ = std::jthread([this](const std::stop_token& stop) { watch(stop); });
}

WatchedScene::~WatchedScene() { stop(); }

void WatchedScene::stop() {
  watcher_.request_stop();
  changed_.notify_all();
}

SceneVersion WatchedScene::now() const {
  const std::scoped_lock lock(mutex_);
  return version_;
}

SceneVersion WatchedScene::after(int known, milliseconds most) const {
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, watcher_.get_stop_token(), most, [&] { return version_.number > known; });
  return version_;
}

void WatchedScene::read() {
  SceneVersion next;
  try {
    next.request = app::readSceneRequest(fileName_, overrides_, allowance_);
    auto scene = std::make_shared<const scene::Scene>(app::loadRequested(next.request));
    const stage::Stage stage(*scene);  // what the motion lacks is found here
    next.scene = std::move(scene);
  } catch (const core::Error& error) {
    next.error = core::printableLines(error.what());
  }
  const std::scoped_lock lock(mutex_);
  if (!next.scene && next.error == version_.error) return;  // tried again in vain
  next.number = version_.number + 1;
  if (!next.scene) {
    next.request = version_.request;
    next.scene = version_.scene;
  }
  version_ = std::move(next);
  changed_.notify_all();
}

void WatchedScene::watch(const std::stop_token& stop) {
  std::string seen = fingerprint(filesOf(fileName_, now()));
  for (int pauses = 0; !stop.stop_requested(); ++pauses) {
    std::this_thread::sleep_for(kPause);
    const SceneVersion version = now();
    std::string current = fingerprint(filesOf(fileName_, version));
    const bool again = !version.error.empty() && pauses % kPausesToTryAgain == 0;
    if (current == seen && !again) continue;
    // Taken before the files are read: what changes meanwhile is seen next time.
    seen = std::move(current);
    read();
    if (const SceneVersion read = now(); read.scene != version.scene) seen = fingerprint(filesOf(fileName_, read));
  }
}

}  // namespace poinsot::preview

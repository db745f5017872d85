// SPDX-License-Identifier: Apache-2.0
#include "preview/watched_scene.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "request/requested_scene.h"
#include "request/sweep_cells.h"
#include "stage/stage.h"

namespace poinsot::preview {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kPause{40};
// Time without changes after which a file is read, because an editor may write a file in pieces. The time is
// longer than the resolution of a file system's clock. If a file keeps changing, it is read after kMostCalms
// checks.
constexpr milliseconds kCalm{15};
constexpr int kMostCalms = 20;
// Number of pauses after which a scene with an error is read again, because a missing file may have appeared.
constexpr int kPausesToTryAgain = 25;

/// Returns a text that changes if a file is written, replaced or removed. Includes the change time (ctime),
/// because an editor may restore the size and the modification time.
std::string fingerprint(const std::vector<std::filesystem::path>& files) {
  std::string all;
  for (const auto& file : files) {
    struct stat status {};
    if (::stat(file.c_str(), &status) == 0)
      all += fmt::format("{}.{} {}.{} {} {};", status.st_mtim.tv_sec, status.st_mtim.tv_nsec,
                         status.st_ctim.tv_sec, status.st_ctim.tv_nsec, status.st_size, status.st_ino);
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
    : fileName_(std::move(fileName)),
      overrides_(std::move(overrides)),
      allowance_(std::move(allowance)),
      files_{fileName_} {
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

SceneVersion WatchedScene::load() const {
  SceneVersion loaded;
  try {
    loaded.request = request::readSceneRequest(fileName_, overrides_, allowance_);
    request::askForSweep(loaded.request);
    auto requested = request::requestedScene(loaded.request);
    // The stage throws if the scene shows something that its motion lacks.
    if (!loaded.request.sweep) const stage::Stage stage(requested.scene);
    loaded.scene = std::make_shared<const scene::Scene>(std::move(requested.scene));
  } catch (const core::Error& error) {
    loaded.error = core::printableLines(error.what());
  }
  return loaded;
}

void WatchedScene::read() {
  // Takes the fingerprint before reading, so that a change during reading is noticed later. If this version names
  // new files, takes the fingerprint again with these files, and reads the scene again.
  const auto look = [this] { seen_ = fingerprint(files_); };
  look();
  SceneVersion next = load();
  if (std::vector<std::filesystem::path> files = filesOf(fileName_, next); next.scene && files != files_) {
    files_ = std::move(files);
    look();
    next = load();
  }
  publish(std::move(next));
}

void WatchedScene::publish(SceneVersion next) {
  const std::scoped_lock lock(mutex_);
  if (!next.scene && next.error == version_.error) return;  // reading again gave the same error
  next.number = version_.number + 1;
  if (!next.scene) {
    next.request = version_.request;
    next.scene = version_.scene;
  }
  version_ = std::move(next);
  changed_.notify_all();
}

void WatchedScene::waitUntilCalm(std::string current) const {
  std::string before;
  for (int calms = 0; before != current && calms < kMostCalms; ++calms) {
    before = std::move(current);
    std::this_thread::sleep_for(kCalm);
    current = fingerprint(files_);
  }
}

void WatchedScene::watch(const std::stop_token& stop) {
  for (int pauses = 0; !stop.stop_requested(); ++pauses) {
    std::this_thread::sleep_for(kPause);
    std::string current = fingerprint(files_);
    const bool again = !now().error.empty() && pauses % kPausesToTryAgain == 0;
    if (current == seen_ && !again) continue;
    waitUntilCalm(std::move(current));
    read();
  }
}

}  // namespace poinsot::preview

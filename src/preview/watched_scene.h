// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "request/scene_request.h"
#include "scene/scene.h"

namespace poinsot::preview {

struct SceneVersion {
  int number = 0;  ///< grows with each change
  request::SceneRequest request;
  std::shared_ptr<const scene::Scene> scene;  ///< last scene without errors; null if there was none yet
  std::string error;  ///< error of the newest files, with its place; empty if there is none
};

/// Scene file that an editor changes. Reads the file again if it, or a file that it names, changes. Polls the
/// files every few hundredths of a second, which works on every file system and costs little compared with
/// drawing.
class WatchedScene {
 public:
  WatchedScene(std::string fileName, std::vector<std::string> overrides, scene::Allowance allowance);
  ~WatchedScene();
  WatchedScene(const WatchedScene&) = delete;
  WatchedScene& operator=(const WatchedScene&) = delete;

  /// Ends all waiting: after() returns at once.
  void stop();

  SceneVersion now() const;
  /// Waits for a version with a number above `known`, but not longer than `most`. Returns the newest version.
  SceneVersion after(int known, std::chrono::milliseconds most) const;

 private:
  void watch(const std::stop_token& stop);
  void waitUntilCalm(std::string current) const;
  void read();
  SceneVersion load() const;
  void publish(SceneVersion next);

  const std::string fileName_;
  const std::vector<std::string> overrides_;
  const scene::Allowance allowance_;
  std::vector<std::filesystem::path> files_;  // files of the newest scene without errors
  std::string seen_;                          // fingerprint() of files_ before they were read
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  SceneVersion version_;
  std::jthread watcher_;  // declared last, because the thread uses the other members
};

}  // namespace poinsot::preview

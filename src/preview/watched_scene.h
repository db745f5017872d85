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
  int number = 0;  ///< number of changes so far
  request::SceneRequest request;
  std::shared_ptr<const scene::Scene> scene;  ///< last scene without errors; null if there has been none
  std::string error;                          ///< error of the newest files, with its position; empty if none
};

/// Scene that is read again when its file, or a file that it names, changes. Checks the files for changes every
/// few hundredths of a second. Such polling works on every file system, and costs little compared with drawing.
class WatchedScene {
 public:
  WatchedScene(std::string fileName, std::vector<std::string> overrides, scene::Allowance allowance);
  ~WatchedScene();
  WatchedScene(const WatchedScene&) = delete;
  WatchedScene& operator=(const WatchedScene&) = delete;

  /// Makes all waiting calls of after() return immediately.
  void stop();

  SceneVersion now() const;
  /// Waits for a version with a number above `known`, at most for the time `most`. Returns the newest version.
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
  std::vector<std::filesystem::path> files_;  // files of the last scene without errors
  std::string seen_;                          // fingerprint() of files_, taken just before the scene was last read
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  SceneVersion version_;
  std::jthread watcher_;  // declared last, because the thread uses the other members
};

}  // namespace poinsot::preview

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

/// What a scene's files said when they last changed.
struct SceneVersion {
  int number = 0;                             ///< grows with each change
  request::SceneRequest request;              ///< of `scene`
  std::shared_ptr<const scene::Scene> scene;  ///< the last one without a mistake; null before there was one
  std::string error;                          ///< of the newest, with its place; empty where it is `scene`
};

/// A scene file under an editor: read again whenever it, or a file that it names, changes. Looks every few
/// hundredths of a second, which works on every file system, and costs nothing beside a picture.
class WatchedScene {
 public:
  WatchedScene(std::string fileName, std::vector<std::string> overrides, scene::Allowance allowance);
  ~WatchedScene();
  WatchedScene(const WatchedScene&) = delete;
  WatchedScene& operator=(const WatchedScene&) = delete;

  /// Nobody waits any longer: after() returns at once.
  void stop();

  SceneVersion now() const;
  /// The newest, as soon as its number is above `known`; after `most` in any case.
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
  std::vector<std::filesystem::path> files_;  // that the newest scene without a mistake was read from
  std::string seen_;                          // what they were like when it was
  mutable std::mutex mutex_;
  mutable std::condition_variable_any changed_;
  SceneVersion version_;
  std::jthread watcher_;  // last: it uses the others
};

}  // namespace poinsot::preview

// SPDX-License-Identifier: Apache-2.0
#include "loaded_scene.h"

#include <atomic>

#include "app/frame_clock.h"
#include "app/user_limits.h"
#include "stage/picture_motion.h"

namespace poinsot::python {
namespace {

std::uint64_t nextNumber() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

scene::Allowance allowance(const LoadedScene::Words& limits, const LoadedScene::Words& assetRoots) {
  scene::Allowance allowed{app::limitsOf(app::userLimitsFile()), {assetRoots.begin(), assetRoots.end()}};
  for (const std::string& word : limits) allowed.limits.setByWord(word);
  return allowed;
}

}  // namespace

LoadedScene LoadedScene::ofFile(const std::string& fileName, Words overrides, const Words& limits,
                                const Words& assetRoots) {
  return LoadedScene(app::readSceneRequest(fileName, std::move(overrides), allowance(limits, assetRoots)));
}

LoadedScene LoadedScene::ofText(std::string text, const std::string& fileName, Words overrides,
                                const Words& limits, const Words& assetRoots) {
  return LoadedScene(app::SceneRequest{fileName, std::move(text), std::move(overrides), std::nullopt,
                                       allowance(limits, assetRoots)});
}

LoadedScene::LoadedScene(app::SceneRequest request)
    : request_(std::move(request)), scene_(app::loadRequested(request_)), number_(nextNumber()) {}

std::int64_t LoadedScene::frameCount() const { return app::frameCount(scene_.time.duration_s, scene_.time.fps); }

scene::FilmClock LoadedScene::clock() const { return stage::filmClock(scene_); }

}  // namespace poinsot::python

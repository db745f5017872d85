// SPDX-License-Identifier: Apache-2.0
#include "loaded_scene.h"

#include <atomic>

#include "core/frame_clock.h"
#include "stage/picture_motion.h"

namespace poinsot::python {
namespace {

std::uint64_t nextNumber() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

scene::Allowance allowance(const LoadedScene::Words& limits, const LoadedScene::Words& assetRoots) {
  scene::Allowance allowed{{}, {assetRoots.begin(), assetRoots.end()}};
  for (const std::string& word : limits) allowed.limits.setByWord(word);
  return allowed;
}

}  // namespace

LoadedScene LoadedScene::ofFile(const std::string& fileName, Words overrides, const Words& limits,
                                const Words& assetRoots) {
  return LoadedScene(request::readSceneRequest(fileName, std::move(overrides), allowance(limits, assetRoots)));
}

LoadedScene LoadedScene::ofText(std::string text, const std::string& fileName, Words overrides,
                                const Words& limits, const Words& assetRoots) {
  return LoadedScene(request::SceneRequest{fileName, std::move(text), std::move(overrides), std::nullopt,
                                           allowance(limits, assetRoots)});
}

LoadedScene::LoadedScene(request::SceneRequest request)
    : requested_(request::requestedScene(std::move(request))), number_(nextNumber()) {}

std::int64_t LoadedScene::frameCount() const {
  return core::frameCount(scene().time.duration_s, scene().time.fps);
}

scene::FilmClock LoadedScene::clock() const { return stage::filmClock(scene()); }

}  // namespace poinsot::python

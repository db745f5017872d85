// SPDX-License-Identifier: Apache-2.0
#include "stage/stage.h"

#include "stage/lettering.h"
#include "stage/picture_motion.h"

namespace poinsot::stage {

Stage::Stage(scene::Scene scene) : scene_(std::move(scene)), colors_(palette(scene_.style.theme)) {
  views_.emplace_back(scene_, drawnMotion(scene_));
}

draw::Picture Stage::compose(double filmTime_s, glm::ivec2 size_px) const {
  draw::Picture picture;
  picture.size_px = size_px;
  picture.background = colors_.paper;
  picture.panels.push_back({{0, 0}, views_.front().compose(filmTime_s, size_px)});
  addTitle(picture, scene_, colors_);
  return picture;
}

}  // namespace poinsot::stage

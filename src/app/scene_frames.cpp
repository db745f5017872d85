// SPDX-License-Identifier: Apache-2.0
#include "app/scene_frames.h"

#include "app/frame_clock.h"
#include "app/statistics.h"

namespace poinsot::app {

SceneFrames::SceneFrames(const scene::Scene& scene, gl::OffscreenContext& context, std::optional<double> time_s)
    : size_{scene.output.width, scene.output.height},
      fps_(scene.time.fps),
      time_s_(time_s),
      stage_(scene),
      renderer_(context) {}

image::Image SceneFrames::frame(std::int64_t k) {
  const double before_s = processCpu_s();
  const double time_s = time_s_.value_or(filmTime_s(k, fps_));
  const draw::Picture picture = stage_.compose(time_s, {size_.width, size_.height});
  compose_s_ += processCpu_s() - before_s;
  return renderer_.render(picture);
}

FrameTimes SceneFrames::times() const {
  const render::RenderTimes& spent = renderer_.times();
  return {compose_s_, spent.draw_s, spent.read_s, spent.text_s};
}

}  // namespace poinsot::app

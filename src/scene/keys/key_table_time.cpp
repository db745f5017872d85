// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/key_tables.h"
#include "scene/keys/put.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using enum ValueType;
using enum Dimension;

}  // namespace

std::vector<Key> timeKeys() {
  return {
      {.path = "time.start",
       .dimension = kTime,
       .range = kInstants,
       .fallback = "0",
       .example = "\"2 h\"",
       .help = "Motion time at the first frame.",
       .put = into([](Draft& d) { return &d.scene.time.start_s; })},
      {.path = "time.duration",
       .dimension = kTime,
       .range = {.least = 1e-3, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
       .fallback = "10",
       .example = "12.5",
       .help = "Length of the film. The film has the frames k = 0, 1, 2 and so on, as long as k/fps is below this "
               "length. A film has at most 36000 frames.",
       .put = into([](Draft& d) { return &d.scene.time.duration_s; })},
      {.path = "time.fps",
       .type = kFrameRate,
       .range = {.least = 1e-3, .most = usual(Limit::kFps), .limit = Limit::kFps},
       .fallback = "30",
       .example = "\"30000/1001\"",
       .help = "Frames per second of film, kept as an exact fraction.",
       .put = into([](Draft& d) { return &d.scene.time.fps; })},
      {.path = "time.speed",
       .range = kInstants,
       .words = {"auto"},
       .fallback = "\"auto\"",
       .example = "0.5",
       .help =
           "Seconds of motion per second of film. A negative speed plays the motion backwards. `auto` chooses a "
           "speed that the eye can follow. For a heavy top, `auto` chooses a speed that shows the precession.",
       .put = into([](Draft& d) { return &d.scene.time.speed; })},
      {.path = "time.loop",
       .type = kBool,
       .fallback = "false",
       .example = "true",
       .help = "Whether the film repeats without a jump. If true, the start of the motion is moved as little as "
               "possible, at the same |L|, so that the motion returns to its start. The film ends when the motion "
               "has returned. A top in steady precession keeps its lean, and its rates are changed. The speed "
               "changes slightly, so that the film has a whole number of frames; `info` "
               "prints the change. Free motion and the steady precession of a top can loop.",
       .put = into([](Draft& d) { return &d.loop; })},
      {.path = "time.still",
       .dimension = kTime,
       .range = {.least = 0, .most = usual(Limit::kDuration), .limit = Limit::kDuration},
       .words = {"auto"},
       .fallback = "\"auto\"",
       .example = "\"3.2 s\"",
       .help = "Film time of the frame that the commands `still` and `gallery` draw, usually the frame that shows "
               "most of the motion. `auto` is a third of the film's length. A time after the end of the film "
               "counts as the end.",
       .put = into([](Draft& d) { return &d.scene.time.still_s; })},
  };
}

}  // namespace poinsot::scene

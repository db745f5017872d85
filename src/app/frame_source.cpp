// SPDX-License-Identifier: Apache-2.0
#include "app/frame_source.h"

namespace poinsot::app {

FrameTimes& FrameTimes::operator+=(const FrameTimes& other) {
  compose_s += other.compose_s;
  render_s += other.render_s;
  read_s += other.read_s;
  text_s += other.text_s;
  return *this;
}

FrameTimes& FrameTimes::operator-=(const FrameTimes& other) {
  compose_s -= other.compose_s;
  render_s -= other.render_s;
  read_s -= other.read_s;
  text_s -= other.text_s;
  return *this;
}

}  // namespace poinsot::app

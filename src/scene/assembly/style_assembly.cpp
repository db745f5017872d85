// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

namespace poinsot::scene {
namespace {

// A press or a laser printer reproduces thinner lines than a projector.
constexpr double kPrintLineWidth = 0.65;

}  // namespace

void finishStyle(Style& style) {
  if (style.theme == Theme::kPrint) style.lineWidth *= kPrintLineWidth;
}

}  // namespace poinsot::scene

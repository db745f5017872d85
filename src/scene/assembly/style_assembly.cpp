// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

namespace poinsot::scene {
namespace {

// A press and a laser printer hold a thinner line than a projector shows.
constexpr double kPrintLineWidth = 0.65;

}  // namespace

void finishStyle(Style& style) {
  if (style.theme == Theme::kPrint) style.lineWidth *= kPrintLineWidth;
}

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#include "scene/assembly/parts.h"

namespace poinsot::scene {
namespace {

// Factor on the line width of the print theme. Printers reproduce thinner lines than projectors do.
constexpr double kPrintLineWidth = 0.65;

}  // namespace

void finishStyle(Style& style) {
  if (style.theme == Theme::kPrint) style.lineWidth *= kPrintLineWidth;
}

}  // namespace poinsot::scene

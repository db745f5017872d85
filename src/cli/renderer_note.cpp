// SPDX-License-Identifier: Apache-2.0
#include "cli/renderer_note.h"

#include "core/text.h"
#include "gl/offscreen_context.h"

namespace poinsot::cli {

std::string rendererNotes(const std::set<std::string>& renderers) {
  std::string notes;
  for (const std::string& renderer : renderers) {
    const std::string doubt = renderer.empty() ? "" : gl::rendererDoubt(renderer);
    if (!doubt.empty()) notes += "poinsot: note: " + core::printable(doubt) + "\n";
  }
  return notes;
}

}  // namespace poinsot::cli

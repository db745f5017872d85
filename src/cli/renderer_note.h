// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

namespace poinsot::cli {

/// Why pictures of these renderers are slow and not quite those of other machines: a note for each such renderer.
/// @param renderers  GL_RENDERER of those that drew; an empty one is no renderer
std::string rendererNotes(const std::set<std::string>& renderers);

}  // namespace poinsot::cli

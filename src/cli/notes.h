// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "job/render_request.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// What the file says and may be a slip: "file:line:column: note: ...", a line each.
std::string doubtNotes(const scene::Scene& scene);

/// These, and what was decided where the scene says nothing of it, and what its author can hardly have wanted; a
/// line each.
/// @param film  more than one frame is made
std::string choiceNotes(const scene::Scene& scene, bool film);

/// Of a grid of films in the pixels of one, or of a figure on paper, whose type nobody can read; else empty.
std::string smallTypeNote(const job::RenderRequest& render);

/// Why pictures of these renderers are slow and not quite those of other machines: a note for each such renderer.
/// @param renderers  GL_RENDERER of those that drew; an empty one is no renderer
std::string rendererNotes(const std::set<std::string>& renderers);

}  // namespace poinsot::cli

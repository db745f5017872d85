// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "job/render_request.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// Returns notes on likely mistakes in the scene file, one per line: "file:line:column: note: ...".
std::string doubtNotes(const scene::Scene& scene);

/// Returns doubtNotes(), and notes on choices of the program and on results that the author hardly wants; one per
/// line.
/// @param film  whether more than one frame is made
std::string choiceNotes(const scene::Scene& scene, bool film);

/// Returns a note if type is too small to read, in a sweep or in a picture on paper; else an empty string.
std::string smallTypeNote(const job::RenderRequest& render);

/// Returns a note for each renderer that is slow and whose pictures differ from those of other machines.
/// @param renderers  GL_RENDERER of the processes that drew; empty texts are ignored
std::string rendererNotes(const std::set<std::string>& renderers);

}  // namespace poinsot::cli

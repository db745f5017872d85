// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "job/render_request.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// Returns notes on likely mistakes in the scene file, one per line: "file:line:column: note: TEXT".
std::string doubtNotes(const scene::Scene& scene);

/// Returns doubtNotes(), and notes on choices of the program and on results that users rarely want, one per line.
/// @param film  whether the output has more than one frame
std::string choiceNotes(const scene::Scene& scene, bool film);

/// Returns notes on a picture of the request: text that is too small to read, in a sweep, on paper or in a lecture
/// hall; text that does not fit in its fixed size; lines that are too thin for print; and a camera that cuts off a
/// part of the motion.
std::string pictureNotes(const job::RenderRequest& render);

/// Returns a note for each slow renderer whose pictures differ from those of other machines.
/// @param renderers  GL_RENDERER of the processes that drew; empty texts are ignored
std::string rendererNotes(const std::set<std::string>& renderers);

}  // namespace poinsot::cli

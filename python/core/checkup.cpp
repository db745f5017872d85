// SPDX-License-Identifier: Apache-2.0
#include "checkup.h"

#include "core/error.h"
#include "request/memory.h"
#include "scene/document/problem.h"
#include "stage/stage.h"

namespace poinsot::python {
namespace {

Remark remarkOf(const core::SourceLocation& where, const std::string& message) {
  return {where.file, where.line, where.column, message};
}

/// Makes a stage, which throws if the motion lacks something.
std::vector<Remark> problemsOf(const LoadedScene& loaded) {
  try {
    const stage::Stage stage(loaded.scene());
    return {};
  } catch (const core::Error& error) {
    return {
        remarkOf(error.where().value_or(core::SourceLocation{loaded.request().fileName, 0, 0}), error.message())};
  }
}

double memory_bytes(const scene::Scene& scene, const std::optional<output::FilmFormat>& film) {
  return request::workerMemory_bytes({scene.output.width, scene.output.height}, film) +
         request::meshMemory_bytes(scene);
}

}  // namespace

Checkup checkupOf(const LoadedScene& loaded) {
  const scene::Scene& scene = loaded.scene();
  Checkup checkup{problemsOf(loaded), {}, memory_bytes(scene, output::FilmFormat{}), memory_bytes(scene, {})};
  for (const scene::Doubt& doubt : scene.doubts) checkup.notes.push_back(remarkOf(doubt.where, doubt.message));
  return checkup;
}

}  // namespace poinsot::python

// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_options.h"

#include "cli/command.h"
#include "request/scene_request.h"

namespace poinsot::cli {

void addOverrides(const Command& command, SceneOptions& options) {
  command.option("-D", options.overrides, "set a key of the scene; overrides the file")
      .type("KEY=VALUE")
      .repeats();
  addAllowance(command, options);
}

void addSceneOptions(const Command& command, SceneOptions& options) {
  command.option("SCENE", options.scene, "scene file (TOML)").required();
  addOverrides(command, options);
}

scene::Scene loadScene(const SceneOptions& options, const scene::Allowance& allowance) {
  return request::loadRequested(request::readSceneRequest(options.scene, options.overrides, allowance));
}

scene::Scene loadScene(const SceneOptions& options) { return loadScene(options, granted(options)); }

void enterInputs(output::RunFiles& files, const SceneOptions& options, const scene::Scene& scene) {
  files.reads(options.scene, "SCENE");
  for (const scene::InputFile& input : scene.inputs) files.reads(input.place, "the scene's file");
}

output::RunFiles enteredInputs(const SceneOptions& options, const scene::Scene& scene, bool force) {
  output::RunFiles files(force);
  enterInputs(files, options, scene);
  return files;
}

}  // namespace poinsot::cli

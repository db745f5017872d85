// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_options.h"

#include <CLI/CLI.hpp>

#include "request/scene_request.h"
#include "request/user_files.h"

namespace poinsot::cli {

void addOverrides(CLI::App& command, SceneOptions& options) {
  command.add_option("-D", options.overrides, "set a key of the scene, above what the file says")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  addAllowance(command, options);
}

void addSceneOptions(CLI::App& command, SceneOptions& options) {
  command.add_option("SCENE", options.scene, "scene file (TOML)")->required();
  addOverrides(command, options);
}

CLI::Validator notEmpty(const std::vector<std::string>& words) {
  return {[](std::string& word) -> std::string { return word.empty() ? "is empty" : ""; },
          words.empty() ? "" : CLI::detail::generate_set(words), ""};
}

scene::Scene loadScene(const SceneOptions& options, const scene::Allowance& allowance) {
  return request::loadRequested(request::readSceneRequest(options.scene, options.overrides, allowance));
}

scene::Scene loadScene(const SceneOptions& options) { return loadScene(options, granted(options)); }

void enterInputs(output::RunFiles& files, const SceneOptions& options, const scene::Scene& scene) {
  files.reads(options.scene, "SCENE");
  for (const scene::InputFile& input : scene.inputs) files.reads(input.place, "the scene's file");
  files.reads(request::userLimitsFile(), "your limits");
}

output::RunFiles enteredInputs(const SceneOptions& options, const scene::Scene& scene, bool force) {
  output::RunFiles files(force);
  enterInputs(files, options, scene);
  return files;
}

}  // namespace poinsot::cli

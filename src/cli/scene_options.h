// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/allowance.h"
#include "output/run_files.h"
#include "scene/scene.h"

namespace CLI {
class App;
class Validator;
}  // namespace CLI

namespace poinsot::cli {

/// Words of the command line common to every command that reads one scene, as typed.
struct SceneOptions : AllowanceOptions {
  std::string scene;
  std::vector<std::string> overrides;
};

/// Declares -D and what may be allowed.
void addOverrides(CLI::App& command, SceneOptions& options);

/// Declares SCENE, -D and what may be allowed.
void addSceneOptions(CLI::App& command, SceneOptions& options);

/// Refuses '' as a value, most often a shell variable without one, which would else count as not given. `words`
/// are the values there are, for the help; what reads the value refuses others.
CLI::Validator notEmpty(const std::vector<std::string>& words = {});

/// Reads and checks the scene file, with -D above it.
/// @throws scene::SceneErrors, core::Error(kScene, kLimit, kUsage)
scene::Scene loadScene(const SceneOptions& options, const scene::Allowance& allowance);
/// The same with what the options allow.
scene::Scene loadScene(const SceneOptions& options);

/// Enters what a run reads: the scene, the files that it names, and the user's limits.toml.
/// @throws core::Error(kUsage) if an output is one of these files.
void enterInputs(output::RunFiles& files, const SceneOptions& options, const scene::Scene& scene);

/// The files of a run with these inputs.
/// @param force  whether the run may replace files that this program did not write
output::RunFiles enteredInputs(const SceneOptions& options, const scene::Scene& scene, bool force);

}  // namespace poinsot::cli

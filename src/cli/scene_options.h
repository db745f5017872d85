// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/allowance.h"
#include "output/run_files.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// Options of the commands that read one scene, as the user typed them.
struct SceneOptions : AllowanceOptions {
  std::string scene;
  std::vector<std::string> overrides;
};

/// Declares -D and the options of addAllowance().
void addOverrides(const Command& command, SceneOptions& options);

/// Declares SCENE, -D and the options of addAllowance().
void addSceneOptions(const Command& command, SceneOptions& options);

/// Reads and checks the scene file, with the overrides of -D.
/// @throws scene::SceneErrors, core::Error(kScene, kLimit, kUsage)
scene::Scene loadScene(const SceneOptions& options, const scene::Allowance& allowance);
scene::Scene loadScene(const SceneOptions& options);

/// Registers the inputs of a run: the scene and the files that it names.
/// @throws core::Error(kUsage) if an output is one of these files.
void enterInputs(output::RunFiles& files, const SceneOptions& options, const scene::Scene& scene);

/// Returns a register of the files of a run, with the inputs of enterInputs().
/// @param force  whether the run may replace files of other programs
output::RunFiles enteredInputs(const SceneOptions& options, const scene::Scene& scene, bool force);

}  // namespace poinsot::cli

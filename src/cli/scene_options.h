// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cli/allowance.h"
#include "output/run_files.h"
#include "scene/scene.h"

namespace poinsot::cli {

/// Words of the command line common to every command that reads one scene, as typed.
struct SceneOptions : AllowanceOptions {
  std::string scene;
  std::vector<std::string> overrides;
};

/// Declares -D and what may be allowed.
void addOverrides(const Command& command, SceneOptions& options);

/// Declares SCENE, -D and what may be allowed.
void addSceneOptions(const Command& command, SceneOptions& options);

/// Reads and checks the scene file, with -D above it.
/// @throws scene::SceneErrors, core::Error(kScene, kLimit, kUsage)
scene::Scene loadScene(const SceneOptions& options, const scene::Allowance& allowance);
/// The same with what the options allow.
scene::Scene loadScene(const SceneOptions& options);

/// Enters what a run reads: the scene and the files that it names.
/// @throws core::Error(kUsage) if an output is one of these files.
void enterInputs(output::RunFiles& files, const SceneOptions& options, const scene::Scene& scene);

/// The files of a run with these inputs.
/// @param force  whether the run may replace files that this program did not write
output::RunFiles enteredInputs(const SceneOptions& options, const scene::Scene& scene, bool force);

}  // namespace poinsot::cli

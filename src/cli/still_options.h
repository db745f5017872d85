// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/rendering.h"

namespace poinsot::cli {

class Command;

/// Options of the commands that make one picture, as the user typed them.
struct StillOptions {
  std::optional<std::string> time;
  std::string width;
  std::optional<double> dpi;
  std::string type;  ///< one size for all small text
  bool svgText = false;

  bool any() const { return time || !width.empty() || dpi || !type.empty(); }
};

void addStillOptions(const Command& command, StillOptions& options);

/// Function that returns the target of the picture for a scene name. @throws core::Error(kUsage)
using StillTarget = std::function<request::OutputTarget(const std::string& sceneName)>;

/// Makes a picture. @param form  properties of the picture, except its size on paper
/// @returns the exit code. @throws core::Error, scene::SceneErrors, process::Interrupted
int makeStill(const RenderOptions& options, const StillOptions& still, request::PictureOptions form,
              const StillTarget& targetOf);

}  // namespace poinsot::cli

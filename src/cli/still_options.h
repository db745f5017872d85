// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/rendering.h"

namespace poinsot::cli {

class Command;

/// Words of the command line common to all that make one picture, as typed.
struct StillOptions {
  std::optional<std::string> time;
  std::string width;
  std::optional<double> dpi;

  bool any() const { return time || !width.empty() || dpi; }
};

/// Declares --time, --width and --dpi.
void addStillOptions(const Command& command, StillOptions& options);

/// Where the picture of a scene of that name goes. @throws core::Error(kUsage)
using StillTarget = std::function<request::OutputTarget(const std::string& sceneName)>;

/// Makes it. @param form  what it is besides its size on paper
/// @returns the exit status. @throws core::Error, scene::SceneErrors, process::Interrupted
int makeStill(const RenderOptions& options, const StillOptions& still, request::PictureOptions form,
              const StillTarget& targetOf);

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

#include "cli/commands.h"
#include "cli/rendering.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

struct StillOptions : RenderOptions {
  double time_s = 0;
};

[[noreturn]] void refuse(const std::string& message) { throw core::Error(core::ErrorKind::kUsage, message); }

void checkIsPicture(const std::string& name) {
  if (app::parseTarget(name).kind == app::OutputKind::kPicture) return;
  refuse(fmt::format("output '{}': a still is one NAME.png", core::printable(name)));
}

int still(const StillOptions& options) {
  if (!options.output.empty()) checkIsPicture(options.output);
  auto request = requestedScene(options);
  const scene::Scene scene = app::loadRequested(request);
  if (!(options.time_s >= 0 && options.time_s <= scene.time.duration_s))
    refuse(fmt::format("--time {}: the film lasts from 0 to {} s", options.time_s, scene.time.duration_s));
  const auto target = requestedTarget(options, scene.name, ".png");
  return renderTo(options, target, std::move(request), scene, app::FrameRange{0, 0}, options.time_s);
}

}  // namespace

void addStill(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<StillOptions>();
  CLI::App* command = program.add_subcommand("still", "make one picture of a scene");
  addRenderOptions(*command, *options);
  command->add_option("-o,--output", options->output, "NAME.png (default: out/SCENE.png)")->type_name("FILE");
  command->add_option("--time", options->time_s, "film time in seconds (default: 0)")->type_name("T");
  command->footer(
      "Example:\n"
      "  poinsot still scenes/tennis_racket.toml --time 1.25 --size 2400x1800 -o out/fig.png");
  command->callback([options, &chosen] { chosen = [options] { return still(*options); }; });
}

}  // namespace poinsot::cli

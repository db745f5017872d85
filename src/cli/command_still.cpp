// SPDX-License-Identifier: Apache-2.0
#include <memory>

#include "cli/commands.h"
#include "cli/option_values.h"
#include "cli/still_options.h"

namespace poinsot::cli {
namespace {

struct Options : RenderOptions {
  StillOptions still;
  bool transparent = false, crop = false;
  int bits = 8;
};

request::OutputTarget targetOf(const Options& options, const std::string& sceneName) {
  return request::parseStillTarget(options.output.empty() ? "out/" + sceneName + ".png" : options.output);
}

int still(const Options& options) {
  return makeStill(options, options.still, {std::nullopt, options.transparent, options.bits, options.crop},
                   [&](const std::string& sceneName) { return targetOf(options, sceneName); });
}

}  // namespace

void addStill(const Command& program) {
  auto options = std::make_shared<Options>();
  const Command command = program.command("still", "make one picture of a scene");
  addRenderOptions(command, *options);
  command
      .option("-o,--output", options->output, "NAME.png, NAME.pdf, NAME.svg or NAME.tex (default: out/SCENE.png)")
      .type("FILE")
      .notEmpty();
  addStillOptions(command, options->still);
  command.flag("--transparent", options->transparent, "transparent background instead of paper");
  command.flag("--crop", options->crop,
               "leave out the empty borders; --size and --width are those of the picture before");
  addBitsOption(command, options->bits);
  command.footer(
      "Examples:\n"
      "  poinsot still scenes/tennis_racket.toml --time 1.25 --size 2400x1800 -o out/fig.png\n"
      "  poinsot still scenes/tennis_racket.toml --time 1.25 --width 86mm -o out/fig.pdf\n"
      "  poinsot still scenes/tennis_racket.toml --time 1.25 --width 86mm --type 8pt -o out/fig.tex");
  command.does({[options] { return still(*options); }, options.get(),
                [options] { return accessOf(*options, targetOf(*options, "SCENE")); }});
}

}  // namespace poinsot::cli

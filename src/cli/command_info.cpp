// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "describe/alt_text.h"
#include "describe/report.h"
#include "describe/report_units.h"

namespace poinsot::cli {
namespace {

struct InfoOptions : SceneOptions {
  bool json = false, alt = false, all = false;
  int digits = describe::kUsualDigits;
};

int info(const InfoOptions& options) {
  if (options.alt) {
    writeOut(wrapped(describe::altText(loadScene(options))) + '\n');
    return kDone;
  }
  const describe::Report report = describe::sceneReport(loadScene(options));
  if (options.json)
    writeOut(describe::reportJson(report));
  else
    writeOut(describe::reportTable(
        describe::inUnits(report, request::defaultsOf(request::userDefaultsFile()).units), options.digits,
        options.all ? describe::TableExtent::kAll : describe::TableExtent::kPage));
  return kDone;
}

}  // namespace

void addInfo(const Command& program) {
  auto options = std::make_shared<InfoOptions>();
  const Command command =
      program.command("info", "print what one would work out by hand: moments, periods, cones, rates");
  addSceneOptions(command, *options);
  const Option json = command.flag(
      "--json", options->json, "print a JSON object, in SI units with full precision; infinite numbers are null");
  const Option alt =
      command.flag("--alt", options->alt, "print a paragraph in words, for readers who do not see the picture")
          .excludes(json);
  command.flag("--all", options->all, "print all quantities; by default, a page of the most important ones")
      .excludes(alt);
  command
      .option("--digits", options->digits,
              fmt::format(
                  "significant digits of each number; with {}, different numbers are always printed differently",
                  describe::kAllDigits))
      .range(1, describe::kAllDigits)
      .showDefault()
      .excludes(json);
  command.footer(
      "Examples:\n"
      "  poinsot info scenes/football.toml\n"
      "  poinsot info scenes/football.toml --all\n"
      "  poinsot info scenes/football.toml --alt\n"
      "Equation numbers refer to the lecture that docs/physics.md follows.");
  command.does({[options] { return info(*options); }, options.get(),
                [options] {
                  return FileAccess{{options->scene}, options->assetRoots};
                }});
}

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "app/alt_text.h"
#include "app/report_scene.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"

namespace poinsot::cli {
namespace {

constexpr std::size_t kColumns = 100;

struct InfoOptions : SceneOptions {
  bool json = false, alt = false;
};

/// Broken at spaces to lines of so many characters, for a terminal.
std::string wrapped(const std::string& paragraph, std::size_t width) {
  std::string text;
  std::size_t column = 0;
  for (std::size_t from = 0; from < paragraph.size();) {
    const std::size_t to = std::min(paragraph.find(' ', from), paragraph.size());
    const std::string word = paragraph.substr(from, to - from);
    const auto length = static_cast<std::size_t>(
        std::ranges::count_if(word, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
    if (column > 0) text += column + 1 + length > width ? '\n' : ' ';
    column = column > 0 && column + 1 + length <= width ? column + 1 + length : length;
    text += word;
    from = to + 1;
  }
  return text + '\n';
}

int info(const InfoOptions& options) {
  if (options.alt) {
    writeOut(wrapped(app::altText(loadScene(options)), kColumns));
    return kDone;
  }
  const app::Report report = app::sceneReport(loadScene(options));
  writeOut(options.json ? app::reportJson(report) : app::reportTable(report));
  return kDone;
}

}  // namespace

void addInfo(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<InfoOptions>();
  CLI::App* command =
      program.add_subcommand("info", "print what one would work out by hand: moments, periods, cones, rates");
  addSceneOptions(*command, *options);
  CLI::Option* json = command->add_flag("--json", options->json,
                                        "as a JSON object, SI units, full precision; infinite numbers are null");
  command->add_flag("--alt", options->alt, "as a paragraph in words, for readers who do not see the picture")
      ->excludes(json);
  command->footer(
      "Examples:\n"
      "  poinsot info scenes/football.toml\n"
      "  poinsot info scenes/football.toml --alt\n"
      "Equation numbers are those of the lecture that docs/physics.md follows.");
  command->callback([options, &chosen] {
    chosen = [options] {
      return confined(
          *options,
          [&] {
            return Reach{{options->scene}, options->assetRoots};
          },
          [&] { return info(*options); });
    };
  });
}

}  // namespace poinsot::cli

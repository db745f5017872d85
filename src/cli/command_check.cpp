// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/notes.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "core/error.h"
#include "core/text.h"
#include "request/scene_request.h"
#include "scene/document/problem.h"
#include "stage/stage.h"

namespace poinsot::cli {
namespace {

struct CheckOptions : SceneOptions {
  std::vector<std::string> scenes;
};

/// Checks a scene and its motion without drawing. Returns notes on likely mistakes.
std::string checkScene(const std::string& fileName, const CheckOptions& options,
                       const scene::Allowance& allowance) {
  const scene::Scene scene =
      request::loadRequested(request::readSceneRequest(fileName, options.overrides, allowance));
  const stage::Stage stage(scene);
  return doubtNotes(scene);
}

/// Prints "ok" or all problems. Returns whether the scene is valid.
bool report(const std::string& fileName, const CheckOptions& options, const scene::Allowance& allowance) {
  try {
    writeErr(checkScene(fileName, options, allowance));
  } catch (const scene::SceneErrors& errors) {
    writeErr(fmt::format("{}\n", errors.what()));
    return false;
  } catch (const core::Error& error) {
    writeError(error.where() ? error.what() : fmt::format("{}: {}", core::printable(fileName), error.what()));
    return false;
  }
  writeOut(fmt::format("{}: ok\n", core::printable(fileName)));
  return true;
}

int check(const CheckOptions& options) {
  const scene::Allowance allowance = granted(options);
  bool allGood = true;
  for (const std::string& fileName : options.scenes) allGood &= report(fileName, options, allowance);
  return allGood ? kDone : kBadInput;
}

}  // namespace

void addCheck(const Command& program) {
  auto options = std::make_shared<CheckOptions>();
  const Command command = program.command("check", "check scene files and report all errors at once");
  command.option("SCENE", options->scenes, "scene files (TOML)").required();
  addOverrides(command, *options);
  command.footer(
      "Example:\n"
      "  poinsot check scenes/*.toml");
  command.does({[options] { return check(*options); }, options.get(),
                [options] {
                  return FileAccess{options->scenes, options->assetRoots};
                }});
}

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/new_scene.h"
#include "cli/scene_options.h"
#include "cli/scenes_place.h"
#include "core/error.h"
#include "core/file_batch.h"
#include "core/regular_file.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "output/run_files.h"
#include "scene/keys/reference.h"
#include "scene/limits.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;
using core::ErrorKind;

constexpr std::string_view kSchemaName = "poinsot.schema.json";

struct NewOptions {
  std::string name, from;
  bool force = false;
};

fs::path galleryFile(const std::string& name) {
  const std::vector<fs::path> scenes = scenesIn(scenesPlace());
  std::vector<std::string> names;
  for (const fs::path& scene : scenes) names.push_back(scene.stem().string());
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return scenes[static_cast<std::size_t>(found - names.begin())];
  const auto near = core::closest(name.substr(0, 64), names);
  throw core::usageError(
      fmt::format("--from: the gallery has no scene '{}'; {}", core::printable(name),
                  near ? fmt::format("did you mean '{}'?", core::printable(*near))
                       : core::printableLines(fmt::format("it has {}", core::joined(names, ", ")))));
}

std::string galleryText(const fs::path& file) {
  return core::readRegularFile(file, scene::Limits().bytes(scene::Limit::kSceneBytes), ErrorKind::kIo);
}

/// Registers the files that are read and written. An existing scene is never replaced without --force, not even if
/// poinsot wrote it, because users edit their scenes.
void enterFiles(const NewOptions& options, const fs::path& from, const fs::path& file, const fs::path& schema) {
  output::RunFiles files(options.force);
  files.reads(from, "--from");
  files.reads(request::userDefaultsFile(), "your defaults");
  files.writes(file, "NAME", {});
  const std::string text = scene::schemaJson();
  files.writes(schema, "schema", output::textKind("a schema", text.substr(0, text.find("\"type\""))));
}

int makeNew(const NewOptions& options) {
  fs::path file = options.name;
  if (file.extension() != ".toml") file += ".toml";
  const fs::path from = options.from.empty() ? fs::path() : galleryFile(options.from);
  const fs::path schema = core::folderOf(file) / kSchemaName;
  enterFiles(options, from, file, schema);
  const request::UserDefaults defaults = request::defaultsOf(request::userDefaultsFile());
  const std::string scene = options.from.empty() ? blankScene(file.stem().string(), defaults)
                                                 : galleryScene(galleryText(from), defaults);
  core::FileBatch results;
  results.write(schema, scene::schemaJson());
  // The first line names the schema. Editors with Taplo read it (VS Code with Even Better TOML, Helix, Neovim).
  results.write(file, fmt::format("#:schema ./{}\n{}", kSchemaName, scene));
  results.commit();
  const std::string word = core::shellWord(file.string());
  writeOut(
      fmt::format("{0} is ready to edit; {1} beside the scene lets your editor complete keys.\n"
                  "  poinsot preview {2}      shows it in a browser while you write\n"
                  "  poinsot check {2}\n"
                  "  poinsot still {2}\n"
                  "  poinsot render {2}\n",
                  core::printable(file.string()), kSchemaName, word));
  return kDone;
}

}  // namespace

void addNew(const Command& program) {
  auto options = std::make_shared<NewOptions>();
  const Command command = program.command("new", "write a scene with comments to start from");
  command.option("NAME", options->name, "file to write; .toml is added if it is missing").required().notEmpty();
  command.option("--from", options->from, "start from a scene of the gallery: football, tennis_racket, ...")
      .type("SCENE")
      .notEmpty();
  command.flag("--force", options->force, "replace an existing scene");
  command.footer(
      "Examples:\n"
      "  poinsot new my_scene\n"
      "  poinsot new phone\n"
      "  poinsot new throw --from football\n"
      "If NAME is a body of the catalogue, such as phone or book, the scene begins with this body.\n"
      "~/.config/poinsot/defaults.toml sets the defaults of new scenes (docs/defaults.md).");
  command.does({[options] { return makeNew(*options); }});
}

}  // namespace poinsot::cli

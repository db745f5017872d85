// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <set>
#include <system_error>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/contact_sheet.h"
#include "cli/exit_code.h"
#include "cli/notes.h"
#include "cli/render_options.h"
#include "cli/scenes_place.h"
#include "cli/untrusted.h"
#include "cli/worker_count.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/text.h"
#include "image/png_file.h"
#include "job/still_batch.h"
#include "output/run_files.h"
#include "process/interrupt.h"
#include "scene/document/problem.h"
#include "stage/stage.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSheetName = "contact_sheet";

struct GalleryOptions : RenderOptions {
  std::vector<std::string> places, only;
  bool sheet = true;
};

struct Item {
  std::string name;
  fs::path target;
  job::RenderRequest request;
};

std::vector<fs::path> sceneFiles(const GalleryOptions& options) {
  std::vector<fs::path> files;
  std::error_code ignored;  // if the path is not a folder, it is read as a scene, which reports errors
  const auto places = options.places.empty() ? std::vector{scenesPlace()} : options.places;
  for (const fs::path place : places)
    if (fs::is_directory(place, ignored))
      std::ranges::copy(scenesIn(place), std::back_inserter(files));
    else
      files.push_back(place);
  return files;
}

void checkOnly(const std::vector<std::string>& only, const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.stem());
  for (const std::string& word : only) {
    if (std::find(names.begin(), names.end(), word) != names.end()) continue;
    const auto near = core::closest(word, names);
    throw core::usageError(fmt::format("--only {}: no such scene{}", core::printable(word),
                                       near ? fmt::format("; did you mean '{}'?", core::printable(*near)) : ""));
  }
}

/// Rejects scenes whose pictures would have the same name as another scene's picture, or as the contact sheet.
void checkNames(const std::vector<fs::path>& files) {
  std::set<std::string> seen{kSheetName};
  for (const fs::path& file : files)
    if (!seen.insert(file.stem()).second)
      throw core::usageError(
          fmt::format("{}: another picture of the gallery has that name", core::printable(file.native())));
}

std::vector<fs::path> chosenFiles(const GalleryOptions& options) {
  std::vector<fs::path> files = sceneFiles(options);
  checkOnly(options.only, files);
  const auto unwanted = [&](const fs::path& file) {
    return !options.only.empty() &&
           std::find(options.only.begin(), options.only.end(), file.stem().string()) == options.only.end();
  };
  std::erase_if(files, unwanted);
  checkNames(files);
  return files;
}

/// Returns the folder of the pictures. Creates it if missing, together with the parent of the default folder.
fs::path preparedFolder(const GalleryOptions& options) {
  fs::path folder = options.output.empty() ? fs::path("out") / "gallery" : fs::path(options.output);
  std::error_code ignored;  // ignored: a later check of the targets reports a missing folder
  if (options.dryRun) return folder;
  if (options.output.empty()) fs::create_directory("out", ignored);
  fs::create_directory(folder, ignored);
  return folder;
}

void enterTarget(output::RunFiles& files, const GalleryOptions& options, const fs::path& target) {
  std::error_code ignored;
  if (!options.dryRun || fs::exists(target.parent_path(), ignored)) files.writes(target, "-o");
}

Item itemOf(const GalleryOptions& options, const scene::Allowance& allowance, const fs::path& file,
            const fs::path& folder, output::RunFiles& files) {
  RenderOptions one = options;
  one.scene = file;
  auto requested = requestedScene(one, allowance);
  const scene::Scene& scene = requested.scene;
  const stage::Stage stage(scene);  // throws if the scene shows something that its motion lacks
  const fs::path target = folder / (scene.name + ".png");
  enterInputs(files, one, scene);
  enterTarget(files, options, target);
  const std::string name = scene.name;
  const double time_s = scene.time.stillTime_s();
  job::RenderRequest request = job::renderRequest(
      std::move(requested), {request::OutputKind::kPicture, target}, {0, 0},
      {.time_s = time_s, .backend = requestedBackend(options), .reproducible = options.reproducible});
  job::expectWithinMemory(request);
  return {name, target, std::move(request)};
}

void say(const GalleryOptions& options, const std::string& line) {
  if (!options.quiet) writeErr(fmt::format("poinsot: {}\n", line));
}

/// Gallery of pictures of several scenes. After an error in one scene, continues with the others.
class Gallery {
 public:
  explicit Gallery(const GalleryOptions& options)
      : options_(options), allowance_(granted(options)), files_(options.force) {}

  int make() {
    const auto files = chosenFiles(options_);
    folder_ = preparedFolder(options_);
    if (options_.sheet) enterTarget(files_, options_, sheet());
    for (const fs::path& file : files) addItem(file);
    if (options_.dryRun) return describe();
    process::watchInterrupts();
    makePictures();
    if (options_.sheet) makeSheet();
    return exitCode_;
  }

 private:
  fs::path sheet() const { return folder_ / (std::string(kSheetName) + ".png"); }

  void fail(core::ErrorKind kind) {
    if (exitCode_ == kDone) exitCode_ = exitCodeOf(kind);
  }

  void addItem(const fs::path& file) {
    try {
      items_.push_back(itemOf(options_, allowance_, file, folder_, files_));
    } catch (const scene::SceneErrors& errors) {
      writeErr(fmt::format("{}\n", errors.what()));
      fail(errors.kind());
    } catch (const core::Error& error) {
      writeError(fmt::format("{}: {}", core::printable(file.native()), error.what()));
      fail(error.kind());
    }
  }

  int describe() const {
    for (const Item& item : items_)
      writeOut(fmt::format("{}: {} at {} s of film\n", core::printable(item.target.native()),
                           core::printable(item.request.scene.request.fileName), *item.request.time_s));
    if (options_.sheet && !items_.empty()) writeOut(fmt::format("{}\n", core::printable(sheet().native())));
    return exitCode_;
  }

  void makePictures() {
    const int workers = workersOf();
    std::vector<job::RenderRequest> requests;
    for (Item& item : items_) requests.push_back(std::move(item.request));
    const auto listener = [&](std::size_t i, const std::optional<core::Error>& failure) {
      const std::string target = core::printable(items_[i].target.native());
      if (failure) writeError(fmt::format("{}: {}", target, failure->what()));
      if (!failure) say(options_, target + " is ready");
    };
    made_ = job::makeStills(std::move(requests), workers, listener);
    std::set<std::string> renderers;
    for (const job::MadeStill& still : made_) {
      if (still.failure) fail(still.failure->kind());
      renderers.insert(still.summary.renderer);
    }
    if (!options_.quiet) writeErr(rendererNotes(renderers));
  }

  /// Returns the number of workers that fit into memory if each draws the largest picture.
  int workersOf() const {
    const auto bytes = [](const Item& item) { return item.request.worker_bytes; };
    const auto largest = std::ranges::max_element(items_, {}, bytes);
    if (largest == items_.end()) return 1;
    return workerCount(options_, static_cast<int>(items_.size()), largest->request);
  }

  /// Writes the contact sheet of this run's pictures. Writes nothing if there are no pictures.
  void makeSheet() const {
    std::vector<SheetEntry> entries;
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (!made_[i].failure) entries.push_back({items_[i].name, image::readPng(items_[i].target)});
    if (entries.empty()) return;
    core::writeFileAtomically(sheet(), image::encodePng(contactSheet(entries)));
    say(options_, core::printable(sheet().native()) + " is ready");
  }

  const GalleryOptions& options_;
  scene::Allowance allowance_;
  output::RunFiles files_;
  fs::path folder_;
  std::vector<Item> items_;
  std::vector<job::MadeStill> made_;
  int exitCode_ = kDone;
};

FileAccess accessOf(const GalleryOptions& options) {
  FileAccess access{{}, options.assetRoots};
  for (const fs::path& file : sceneFiles(options)) access.scenes.push_back(file);
  if (!options.dryRun) access.made.push_back(preparedFolder(options));
  access.outputs.push_back(options.trace);
  access.reproducible = options.reproducible;
  return access;
}

}  // namespace

void addGallery(const Command& program) {
  auto options = std::make_shared<GalleryOptions>();
  const Command command = program.command("gallery", "make a picture of every scene, and a contact sheet");
  command
      .option("SCENE", options->places,
              "scene files, or folders of scene files (default: the scenes that come with poinsot)")
      .notEmpty();
  addOverrides(command, *options);
  addPictureOptions(command, *options);
  command.option("-o,--output", options->output, "folder of the pictures (default: out/gallery)")
      .type("FOLDER")
      .notEmpty();
  command.option("--only", options->only, "only the scenes with these names").type("NAME").notEmpty();
  command.flag("!--no-sheet", options->sheet, "do not make the contact sheet");
  command.footer(
      "Each picture is taken at the scene's time.still. If a scene fails, its error is reported and the others\n"
      "are still made.\n"
      "Examples:\n"
      "  poinsot gallery\n"
      "  poinsot gallery lectures/ -q preview -o out/lectures\n"
      "  poinsot gallery --only football tennis_racket -D style.theme=dark");
  command.does(
      {[options] { return Gallery(*options).make(); }, options.get(), [options] { return accessOf(*options); }});
}

}  // namespace poinsot::cli

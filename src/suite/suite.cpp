// SPDX-License-Identifier: Apache-2.0
#include "suite/suite.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <span>
#include <system_error>

#include <nlohmann/json.hpp>

#include "compare/file_diff.h"
#include "compare/memory.h"
#include "core/atomic_file.h"
#include "core/json.h"
#include "core/parallel.h"
#include "core/text.h"
#include "core/wildcard.h"
#include "image/png_file.h"
#include "job/job_identity.h"
#include "job/still_batch.h"
#include "output/film_reader.h"
#include "output/target_check.h"
#include "request/memory.h"
#include "request/sweep_cells.h"
#include "scene/limits.h"
#include "suite/approval.h"
#include "suite/strays.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;

/// Returns the names of a test's pictures: the test's name, or one name for each of several times ("racket_t1.5").
std::vector<std::string> caseNames(const GoldenTest& test) {
  if (test.times_s.size() <= 1) return {test.name};
  std::vector<std::string> names;
  for (const double t_s : test.times_s) names.push_back(fmt::format("{}_t{}", test.name, t_s));
  return names;
}

std::vector<GoldenCase> casesOf(const GoldenTest& test, const fs::path& output) {
  std::vector<GoldenCase> cases;
  for (const std::string& name : caseNames(test)) {
    const std::size_t i = cases.size();
    const auto time_s = i < test.times_s.size() ? std::optional(test.times_s[i]) : std::nullopt;
    cases.push_back({name, test, time_s, test.scene.empty() ? test.image : output / (name + ".png"), {}});
  }
  return cases;
}

/// If a case is named NAME@X, records this in the case NAME, so that the file NAME@X does not count as a reference
/// of NAME for a renderer X.
void giveTakenStems(std::vector<GoldenCase>& cases) {
  std::map<std::string, GoldenCase*> byName;
  for (GoldenCase& one : cases) byName[one.name] = &one;
  for (const GoldenCase& one : cases)
    if (const auto other = byName.find(splitStem(one.name).name); other != byName.end())
      if (other->second != &one) other->second->taken.insert(fs::path(one.name).filename());
}

std::string listText(const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 8;
  std::vector<std::string> all;
  for (const std::string& name : names)
    if (std::ranges::find(all, name) == all.end()) all.push_back(name);
  const std::size_t shown = std::min(all.size(), kMost);
  return core::joined(std::span(all).first(shown), ", ") + (shown < all.size() ? ", ..." : "");
}

bool isAskedFor(const GoldenCase& one, const std::string& word) {
  const std::string only = word.starts_with("./") ? word.substr(2) : word;  // ./-x stands for the name -x
  return only == one.test.file || core::matchesWildcard(only, one.name) ||
         core::matchesWildcard(only, one.test.name);
}

/// Returns the cases that match any of the given names. @throws core::Error(kUsage) if a name matches no case
std::vector<GoldenCase> chosen(const std::vector<GoldenCase>& all, const std::vector<std::string>& only) {
  for (const std::string& name : only) {
    if (std::ranges::any_of(all, [&](const GoldenCase& one) { return isAskedFor(one, name); })) continue;
    std::vector<std::string> names;
    for (const GoldenCase& one : all) names.insert(names.end(), {one.name, one.test.name});
    const auto near = core::closest(name, names);
    throw core::usageError(fmt::format("{}: no such test{}", core::printable(name),
                                       near ? fmt::format("; did you mean '{}'?", *near)
                                            : fmt::format("; known tests: {}", core::printable(listText(names)))));
  }
  std::vector<GoldenCase> wanted;
  for (const GoldenCase& one : all)
    if (std::ranges::any_of(only, [&](const std::string& name) { return isAskedFor(one, name); }))
      wanted.push_back(one);
  return wanted;
}

image::PixelSize sizeOf(const GoldenTest& test, const scene::Scene& scene, const scene::Limits& limits) {
  if (test.size) return *test.size;
  const image::PixelSize own{scene.output.width, scene.output.height};
  if (!test.height) return own;
  const std::int64_t width = std::int64_t{own.width} * *test.height / own.height;
  const std::int64_t most = limits[scene::Limit::kSide];
  if (width < scene::kLeastSide || width > most)
    throw core::Error(
        core::ErrorKind::kLimit,
        fmt::format("height: {} pixels would make this scene of {}x{} {} pixels wide; sides must be from {} to {} "
                    "pixels; {}",
                    *test.height, own.width, own.height, width, scene::kLeastSide, most,
                    howToRaise(scene::Limit::kSide)),
        test.heightAt);
  return {static_cast<int>(width), *test.height};
}

double timeOf(const GoldenCase& one, const scene::Scene& scene) {
  const double t_s = one.time_s.value_or(scene.time.stillTime_s());
  if (t_s >= 0 && t_s <= scene.time.duration_s) return t_s;
  throw core::Error(core::ErrorKind::kScene,
                    fmt::format("times: the film lasts from 0 to {} s, got {} s", scene.time.duration_s, t_s),
                    one.test.timesAt);
}

struct Drawing {
  std::size_t place = 0;  ///< index of the case
  job::RenderRequest request;
  std::string scene;  ///< digest of the scene
};

Drawing drawingOf(const GoldenCase& one, std::size_t place, const GoldenRequest& golden) {
  request::SceneRequest asked = request::readSceneRequest(one.test.scene, one.test.overrides, golden.allowance);
  request::askForSweep(asked);
  request::RequestedScene requested = request::requestedScene(std::move(asked));
  if (one.time_s && requested.request.sweep && request::SweepGrid(requested.request).variesInstant())
    throw core::Error(core::ErrorKind::kScene,
                      fmt::format("times: the range of {} gives each cell its own time; leave out one of the two",
                                  scene::kInstantKey),
                      one.test.timesAt);
  requested.resize(sizeOf(one.test, requested.scene, golden.allowance.limits));
  const job::RenderChoices choices{.time_s = timeOf(one, requested.scene),
                                   .backend = golden.backend,
                                   .reproducible = golden.reproducible,
                                   .digestsPixels = true};
  job::RenderRequest render =
      job::renderRequest(std::move(requested), {request::OutputKind::kPicture, one.actual}, {0, 0}, choices);
  job::expectWithinMemory(render);
  const image::PixelSize size = render.scene.size();
  request::expectWithinMemory(compare::compareMemory_bytes(size), request::pictureText(size),
                              golden.allowance.limits);
  std::string digest = core::toHex(job::sceneDigest(render.scene));
  return {place, std::move(render), std::move(digest)};
}

/// Returns the digest of a picture or film. @throws core::Error(kIo) if the PNG or the film's first frame is
/// unreadable
std::string pixelsOf(const fs::path& picture) {
  const bool isFilm = output::isFilm(picture);
  if (isFilm) output::FilmReader(picture).next();
  return pixelDigestOf(picture, isFilm);
}

/// Checks that the picture file of a case still has the pixels that its scene drew.
void expectDrawn(const fs::path& picture, const std::string& read, const std::string& drawn) {
  if (read != drawn)
    throw core::ioError(
        fmt::format("{}: was changed after it was drawn; make sure that no other program writes to it, "
                    "and run again",
                    core::printable(picture.native())));
}

/// Adds software and renderer to a picture's origin. They are read from the PNG's texts; a variant replaces the
/// renderer.
compare::PictureOrigin completed(compare::PictureOrigin origin, const GoldenCase& one) {
  origin.renderer = one.variant();
  for (const auto& [key, value] : image::textsOfWholePng(one.actual).value_or(std::vector<image::PngText>{})) {
    if (key == "Software") origin.software = value;
    if (key == "Renderer" && origin.renderer.empty()) origin.renderer = value;
  }
  return origin;
}

bool isReadable(const fs::path& picture) try {
  pixelsOf(picture);
  return true;
} catch (const core::Error&) {
  return false;
}

/// Checks that an image of another program is not its own reference, because the comparison would always pass.
void expectApart(const fs::path& actual, const std::vector<GoldenReference>& references) {
  for (const GoldenReference& reference : references) {
    std::error_code ignored;
    if (fs::equivalent(actual, reference.picture, ignored))
      throw core::sceneError(
          fmt::format("{}: is its own reference and would always pass; name another folder in "
                      "references, or let the program write into another folder",
                      core::printable(actual.native())));
  }
}

/// Explains why a picture is near or different, and what changed in its origin since the reference was made.
std::string messageOf(const compare::Outcome& outcome) {
  if (outcome.status == compare::OutcomeStatus::kIdentical) return compare::reasonOf(outcome.diff);
  const std::string change = compare::originChange(outcome.approved, outcome.origin);
  std::string message =
      outcome.status == compare::OutcomeStatus::kNear ? outcome.rule.reason : compare::reasonOf(outcome.diff);
  if (!message.empty() && !change.empty()) message += "; ";
  return message + change;
}

class Comparing {
 public:
  Comparing(const GoldenCase& one, const fs::path& references, const GoldenRequest& golden)
      : one_(one), references_(references), output_(golden.output), limits_(golden.allowance.limits) {}

  void into(compare::Outcome& outcome) const {
    outcome.actual = one_.actual;
    compare::forgetMaps(places());
    const auto all = referencesOf(references_, one_.reference());
    if (all.empty()) {
      outcome.status = compare::OutcomeStatus::kNew;
      outcome.message = "nothing was approved yet";
      return;
    }
    expectApart(one_.actual, all);
    const compare::ComparedPictures nearest = nearestOf(relevant(all, outcome.origin.renderer), outcome);
    outcome.diff = nearest.diff;
    outcome.status = statusOf(outcome.diff.verdict);
    outcome.message = messageOf(outcome);
    if (outcome.status != compare::OutcomeStatus::kIdentical && outcome.diff.hasFigures) draw(nearest, outcome);
  }

 private:
  compare::ComparedPictures nearestOf(const std::vector<GoldenReference>& references,
                                      compare::Outcome& outcome) const {
    compare::ComparedPictures nearest;
    for (const GoldenReference& reference : references) {
      compare::ComparedPictures compared = compareWith(reference.picture);
      if (!outcome.reference.empty() && compare::badness(compared.diff) >= compare::badness(nearest.diff))
        continue;
      outcome.reference = reference.picture;
      outcome.approved = reference.origin;
      nearest = std::move(compared);
    }
    return nearest;
  }

  compare::ComparedPictures compareWith(const fs::path& reference) const try {
    return compare::compareFiles(reference, one_.actual, places());
  } catch (const core::Error& error) {
    if (error.kind() != core::ErrorKind::kIo || isReadable(reference)) throw;
    throw core::Error(error.kind(), fmt::format("{}; remove {} and approve again", error.message(),
                                                core::printable(reference.native())));
  }

  compare::DiffRequest places() const {
    compare::DiffRequest request{one_.test.rule};
    request.limits = limits_;
    request.map = one_.fileIn(output_, kMapEnding);
    request.difference = one_.fileIn(output_, kDifferenceEnding);
    return request;
  }

  void draw(const compare::ComparedPictures& nearest, compare::Outcome& outcome) const {
    const compare::DiffRequest request = places();
    core::makeFolders(request.map->parent_path());
    compare::writeMaps(nearest, request);
    outcome.map = *request.map;
    outcome.difference = *request.difference;
  }

  const GoldenCase& one_;
  const fs::path &references_, &output_;
  const scene::Limits& limits_;
};

/// Run of a suite: first draws all cases, then compares them.
class Run {
 public:
  Run(const GoldenManifest& manifest, const GoldenRequest& request)
      : manifest_(manifest),
        request_(request),
        cases_(suite::casesOf(manifest, request)),
        outcomes_(cases_.size()) {}

  std::vector<compare::Outcome> outcomes() {
    for (std::size_t i = 0; i < cases_.size(); ++i) prepare(i);
    enterInputs();
    draw();
    core::forEachIndex(cases_.size(), request_.jobs, [&](std::size_t i) { compare(i); });
    // If a scene failed to load, a stray reference may belong to it.
    const bool allMade =
        std::ranges::count(outcomes_, compare::OutcomeStatus::kError, &compare::Outcome::status) == 0;
    for (compare::Outcome& stray : strayOutcomes(manifest_, cases_, request_.only, allMade))
      outcomes_.push_back(std::move(stray));
    return std::move(outcomes_);
  }

 private:
  void fail(std::size_t place, const core::Error& error) {
    outcomes_[place].status = compare::OutcomeStatus::kError;
    outcomes_[place].message = error.what();
    failed_.insert(place);
  }

  void prepare(std::size_t place) {
    const GoldenCase& one = cases_[place];
    if (one.test.isUnmatched) {
      outcomes_[place] = unmatchedOutcome(one);
      failed_.insert(place);
      return;
    }
    outcomes_[place].name = one.name;
    outcomes_[place].rule = one.test.rule;
    try {
      if (one.test.scene.empty()) return;
      drawings_.push_back(drawingOf(one, place, request_));
    } catch (const core::Error& error) {  // the error lists all errors of the scene
      fail(place, error);
    }
  }

  /// Registers the scenes' inputs, so that reports do not replace them. @throws core::Error(kUsage) if a report
  /// would
  void enterInputs() const {
    if (request_.files == nullptr) return;
    for (const Drawing& drawing : drawings_)
      for (const scene::InputFile& input : drawing.request.scene.scene.inputs)
        request_.files->reads(input.place, "the scene's file");
  }

  void draw() {
    std::vector<job::RenderRequest> requests;
    for (Drawing& drawing : drawings_) {
      const fs::path& picture = cases_[drawing.place].actual;
      core::makeFolders(picture.parent_path());
      std::error_code ignored;
      fs::remove(picture, ignored);  // remove the picture of an earlier run
      requests.push_back(std::move(drawing.request));
    }
    const int workers = jobsThatFit(requests);
    const auto made = job::makeStills(std::move(requests), workers, [](std::size_t, const auto&) {});
    for (std::size_t i = 0; i < drawings_.size(); ++i) {
      const std::size_t place = drawings_[i].place;
      if (made[i].failure) fail(place, *made[i].failure);
      outcomes_[place].origin.scene = drawings_[i].scene;
      outcomes_[place].origin.driver = made[i].summary.driver;
      outcomes_[place].pixels = made[i].summary.pixels;
    }
  }

  /// Returns how many workers fit into free memory if each worker draws the largest picture.
  int jobsThatFit(const std::vector<job::RenderRequest>& requests) const {
    double most_bytes = 0;
    for (const job::RenderRequest& request : requests) most_bytes = std::max(most_bytes, request.worker_bytes);
    const int fit = request::workersThatFit(request_.jobs, most_bytes, request::freeMemory());
    if (fit > 0) return fit;
    throw core::graphicsError(fmt::format("the largest picture needs about {} of memory, but less is free",
                                          request::memoryText(most_bytes)));
  }

  void compare(std::size_t place) {
    compare::Outcome& outcome = outcomes_[place];
    if (failed_.contains(place)) return showApproved(place);
    const auto start = std::chrono::steady_clock::now();
    try {
      const std::string pixels = pixelsOf(cases_[place].actual);  // throws if the picture is unreadable
      if (!cases_[place].test.scene.empty()) expectDrawn(cases_[place].actual, pixels, outcome.pixels);
      outcome.pixels = pixels;
      outcome.origin = completed(outcome.origin, cases_[place]);
      Comparing(cases_[place], manifest_.references, request_).into(outcome);
    } catch (const core::Error& error) {
      outcome.status = compare::OutcomeStatus::kError;
      outcome.message = error.what();
      outcome.actual = cases_[place].actual;
      showApproved(place);
    }
    outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }

  /// Stores the reference's path in the outcome of a case that has no new picture.
  void showApproved(std::size_t place) try {
    const auto all = referencesOf(manifest_.references, cases_[place].reference());
    if (!all.empty()) outcomes_[place].reference = all.front().picture;
  } catch (const core::Error&) {  // the outcome already has an error
  }

  const GoldenManifest& manifest_;
  const GoldenRequest& request_;
  std::vector<GoldenCase> cases_;
  std::vector<compare::Outcome> outcomes_;
  std::vector<Drawing> drawings_;
  std::set<std::size_t> failed_;
};

}  // namespace

std::vector<GoldenCase> casesOf(const GoldenManifest& manifest, const GoldenRequest& request) {
  std::vector<GoldenCase> all;
  for (const GoldenTest& test : manifest.tests)
    for (GoldenCase& one : casesOf(test, request.output)) {
      if (!request.variant.empty()) one.test.variant = request.variant;
      all.push_back(std::move(one));
    }
  giveTakenStems(all);
  return request.only.empty() ? all : chosen(all, request.only);
}

void enterFilesMade(output::RunFiles& files, const GoldenCase& one, const fs::path& output) {
  for (const std::string_view map : {kMapEnding, kDifferenceEnding})
    files.writesInNewFolder(one.fileIn(output, map), "-o", compare::mapKind());
  if (!one.test.scene.empty()) files.writesInNewFolder(one.actual, "-o", output::drawnKind());
}

std::vector<compare::Outcome> runGoldens(const GoldenManifest& manifest, const GoldenRequest& request) {
  return Run(manifest, request).outcomes();
}

std::string casesJson(const std::vector<GoldenCase>& cases) {
  nlohmann::ordered_json tests = nlohmann::ordered_json::array();
  for (const GoldenCase& one : cases)
    tests.push_back({{"name", one.name}, {one.test.scene.empty() ? "image" : "scene", one.test.file}});
  return core::jsonText({{"tests", std::move(tests)}});
}

}  // namespace poinsot::suite

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "app/diff_curve.h"
#include "app/diff_json.h"
#include "app/diff_report.h"
#include "app/diff_text.h"
#include "app/file_diff.h"
#include "app/junit.h"
#include "app/markdown.h"
#include "app/outcome.h"
#include "app/pair_approval.h"
#include "app/picture_rule.h"
#include "app/render_job.h"
#include "cli/approval.h"
#include "cli/ci_environment.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "output/atomic_file.h"
#include "output/film_reader.h"
#include "output/target_check.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;
using core::Error;
using core::ErrorKind;

struct DiffOptions : AllowanceOptions {
  std::string reference, test, rule, mask, map, difference, curve, report, junit, markdown;
  std::vector<std::string> limits =
      std::vector<std::string>(app::ruleLimits().size());  ///< words; empty: not given
  std::vector<std::string> ignore, update;
  double pixelsPerDegree = image::kFlipPixelsPerDegree;
  int jobs = 0;
  bool json = false, exact = false, quiet = false, force = false;
};

enum class Kind { kPicture, kFolder, kFilm };

/// Kind of a file or folder, by its content. @throws Error(kIo) if there is none.
Kind kindOf(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status))
    throw Error(ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()),
                                            failure ? failure.message() : "No such file or directory"));
  if (fs::is_directory(status)) return Kind::kFolder;
  return output::isFilm(path) ? Kind::kFilm : Kind::kPicture;
}

/// A film beside a picture is a difference; a folder beside a file is a slip.
Kind commonKind(const DiffOptions& options) {
  const Kind reference = kindOf(options.reference), test = kindOf(options.test);
  if (reference == test) return reference;
  if (reference != Kind::kFolder && test != Kind::kFolder) return Kind::kPicture;
  throw Error(ErrorKind::kUsage, "both must be files, or both folders");
}

app::PictureRule ruleOf(const DiffOptions& options) {
  app::PictureRule rule;
  if (!options.rule.empty()) rule.limits = app::namedLimits("--rule", options.rule);
  for (std::size_t i = 0; i < options.limits.size(); ++i)
    if (const app::RuleLimit& limit = app::ruleLimits()[i]; !options.limits[i].empty())
      limit.set(rule.limits, limit.option, options.limits[i]);
  app::expectCanRefuse(rule.limits, "these limits");
  for (const std::string& box : options.ignore) rule.ignore.push_back(app::ignoredBox("--ignore", box));
  rule.mask = options.mask;
  return rule;
}

/// A place for a picture; of folders a folder.
std::optional<fs::path> place(const DiffOptions& options, const std::string& word, Kind kind) {
  if (word.empty()) return std::nullopt;
  if (kind != Kind::kFolder) output::checkTarget(word, options.force);
  return word;
}

app::DiffRequest requestOf(const DiffOptions& options, Kind kind) {
  return {ruleOf(options), options.pixelsPerDegree, place(options, options.map, kind),
          place(options, options.difference, kind), granted(options).limits};
}

/// Nothing is written over what is compared, or over what else is written.
void checkApart(const DiffOptions& options) {
  const auto placeOf = [](const std::string& word) {
    std::error_code failure;  // said of it where it is opened
    const fs::path place = fs::weakly_canonical(fs::absolute(word), failure);
    return failure ? fs::path(word) : place;
  };
  std::vector<fs::path> places{placeOf(options.reference), placeOf(options.test)};
  for (const std::string& written :
       {options.curve, options.report, options.map, options.difference, options.junit, options.markdown}) {
    if (written.empty()) continue;
    const fs::path place = placeOf(written);
    const auto taken = std::ranges::find(places, place);
    if (taken != places.end())
      throw Error(
          ErrorKind::kUsage,
          fmt::format("{}: {}", core::printable(written),
                      taken - places.begin() < 2 ? "is what is compared" : "two things would be written there"));
    places.push_back(place);
  }
}

/// Before anything is compared.
void checkTargets(const DiffOptions& options, Kind kind) {
  checkApart(options);
  if (!options.curve.empty() && kind != Kind::kFilm) throw Error(ErrorKind::kUsage, "--curve: needs two films");
  if (!options.curve.empty()) app::checkCurveTarget(options.curve, options.force);
  if (!options.report.empty()) {
    if (!fs::path(options.report).extension().native().starts_with(".htm"))
      throw Error(ErrorKind::kUsage,
                  fmt::format("report '{}': works: NAME.html{}", core::printable(options.report),
                              core::smallLettersHint(options.report, {".html", ".htm"})));
    output::checkTarget(options.report, options.force);
  }
  if (!options.junit.empty())
    output::checkTarget(options.junit, options.force || output::beginsWith(options.junit, app::kJunitMark));
}

/// Compares in one of the three ways, and writes what was asked for about it.
class Diff {
 public:
  explicit Diff(const DiffOptions& options)
      : options_(options), kind_(commonKind(options)), request_(requestOf(options, kind_)) {
    checkTargets(options, kind_);
  }

  /// @returns the exit code.
  int run() const {
    switch (kind_) {
      case Kind::kFolder:
        return finish(app::diffFolders(options_.reference, options_.test, request_, jobs()));
      case Kind::kFilm:
        return finish(app::diffFilms(options_.reference, options_.test, request_, jobs()));
      case Kind::kPicture:
        break;
    }
    return finishPictures();
  }

 private:
  int jobs() const { return options_.jobs > 0 ? options_.jobs : app::availableCpus(); }
  app::DiffNames names() const { return {options_.reference, options_.test}; }
  void say(const std::string& text) const {
    if (!options_.quiet) writeOut(text);
  }

  std::string approveCommand() const {
    std::vector<std::string> words{"poinsot", "diff", options_.reference, options_.test};
    const std::vector<std::string> allowance = allowanceWords(options_);
    words.insert(words.end(), allowance.begin(), allowance.end());
    if (options_.exact) words.emplace_back("--exact");
    words.emplace_back("--update");
    return core::shellWords(words);
  }

  app::OutcomePageHead headOf(image::Verdict verdict) const {
    app::OutcomePageHead head{options_.test, std::string(image::toString(verdict)),
                              "compared with " + options_.reference};
    head.page = options_.report;
    head.place = options_.reference;
    head.approve = approveCommand();
    head.pixelsPerDegree = request_.pixelsPerDegree;
    head.exact = options_.exact;
    return head;
  }

  app::Outcome outcomeOf(const app::PictureDiff& diff) const {
    app::Outcome outcome = app::outcomeOf(diff, options_.reference, options_.test, request_);
    if (diff.hasFigures) outcome.map = options_.map;
    return outcome;
  }

  int finishPictures() const {
    std::optional<Error> unreadable;
    app::ComparedPictures compared;
    try {
      compared = app::compareFiles(options_.reference, options_.test, request_);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kIo) throw;
      unreadable = error;
      compared.diff = app::unreadablePair(error);
    }
    app::writeMaps(compared, request_);
    const app::Outcome outcome = outcomeOf(compared.diff);
    writeReport([&] { return app::diffReport(compared, outcome, headOf(compared.diff.verdict)); });
    const std::string text = options_.json ? app::diffJson(compared.diff, names(), request_)
                             : unreadable  ? ""
                                           : app::diffText(compared.diff, request_);
    const int code = finish({outcome}, text);
    if (unreadable) throw *unreadable;  // after what could be told
    return code;
  }

  template <class Page>
  void writeReport(Page page) const {
    if (!options_.report.empty()) output::writeFileAtomically(options_.report, page());
  }

  int finish(const app::FolderDiff& diff) const {
    const auto outcomes = app::outcomesOf(diff, options_.reference, options_.test, request_);
    writeReport([&] { return app::outcomePage(outcomes, headOf(diff.verdict()), jobs()); });
    const int code = finish(outcomes, options_.json ? app::diffJson(outcomes, names(), request_)
                                                    : app::diffText(outcomes, diff.linkedFolders));
    if (diff.firstError) throw *diff.firstError;  // after what could be told
    return code;
  }

  /// Writes the maps of the worst frame.
  void writeMaps(const app::FilmDiff& diff) const {
    if (diff.frames.empty() || (!request_.map && !request_.difference)) return;
    app::forFrames(options_.reference, options_.test, {diff.worst()}, request_,
                   [&](std::size_t, const app::ComparedPictures& frame) { app::writeMaps(frame, request_); });
  }

  int finish(const app::FilmDiff& diff) const {
    writeMaps(diff);
    if (!options_.curve.empty()) app::writeCurve(options_.curve, diff, request_.rule.limits);
    writeReport([&] {
      return app::diffReport(diff, options_.reference, options_.test, request_, headOf(diff.verdict()));
    });
    return finish({outcomeOf(app::summaryOf(diff))},
                  options_.json ? app::diffJson(diff, names(), request_) : app::diffText(diff));
  }

  int finish(const std::vector<app::Outcome>& outcomes, const std::string& text) const {
    writeReports(outcomes);
    if (!options_.update.empty()) return approve(outcomes);
    say(text);
    const bool passes = app::countFailures(outcomes, options_.exact) == 0;
    if (!passes && !options_.quiet && !options_.json && app::countFailures(outcomes, false) == 0)
      writeErr("poinsot: not all pixels and not all ways of storing them are identical, as --exact asks\n");
    return passes ? kDone : kNo;
  }

  void writeReports(const std::vector<app::Outcome>& outcomes) const {
    const app::OutcomeReport head{fmt::format("{} and {}", options_.reference, options_.test),
                                  options_.exact,
                                  options_.report,
                                  approveCommand(),
                                  "",
                                  attachmentRoot()};
    if (!options_.junit.empty()) output::writeFileAtomically(options_.junit, app::junitXml(outcomes, head));
    if (!options_.markdown.empty()) output::appendToFile(options_.markdown, app::markdownOf(outcomes, head));
  }

  int approve(const std::vector<app::Outcome>& outcomes) const {
    const app::PairApproval approval =
        app::approvePairs(outcomes, options_.update, options_.reference, options_.exact);
    say(approval.text);
    return approval.complete ? kDone : kNo;
  }

  const DiffOptions& options_;
  Kind kind_;
  app::DiffRequest request_;
};

Reach reachOf(const DiffOptions& options) {
  Reach reach{{},
              {options.reference, options.test},
              {options.map, options.difference, options.curve, options.report, options.junit, options.markdown}};
  if (!options.mask.empty()) reach.inputs.push_back(options.mask);
  return reach;
}

int diff(const DiffOptions& options) {
  if (!options.update.empty()) {
    expectMayApprove(options);
    app::expectReplaceable(options.reference);
  }
  return Diff(options).run();
}

void addLimits(CLI::App& command, DiffOptions& options) {
  constexpr const char* kGroup = "What is \"near\"";
  const auto add = [&](const char* name, auto& value, const char* form, const std::string& help) {
    return command.add_option(name, value, help)->type_name(form)->check(notEmpty())->group(kGroup);
  };
  add("--rule", options.rule, "NAME",
      fmt::format("limits by name: {} (default: near); those below change it", app::ruleNames()));
  for (std::size_t i = 0; i < options.limits.size(); ++i) {
    const app::RuleLimit& limit = app::ruleLimits()[i];
    add(limit.option, options.limits[i], limit.form, limit.help);
  }
  add("--ignore", options.ignore, "X,Y,W,H", "a box of pixels that is not compared; may be given again")
      ->allow_extra_args(false);
  add("--mask", options.mask, "FILE", "PNG of the pictures' size; where it is painted, pixels are not compared");
}

}  // namespace

void addDiff(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<DiffOptions>();
  CLI::App* command = program.add_subcommand("diff", "compare two pictures, folders of them, or films");
  command->add_option("REFERENCE", options->reference, "PNG file, folder or film")->required()->check(notEmpty());
  command->add_option("TEST", options->test, "what is compared with it")->required()->check(notEmpty());
  command->add_flag("--exact", options->exact, "exit 0 only for identical pictures that are stored alike");
  command->add_flag("--json", options->json, "the figures as a JSON object");
  command->add_flag("--quiet", options->quiet, "only the exit code");
  command
      ->add_option(
          "--map", options->map,
          "write what FLIP has of each pixel, in the colours of magma: PNG; of folders a folder; of films "
          "that of the worst frame")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--diff-image", options->difference, "likewise the difference, 16 times amplified")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option("--curve", options->curve, "write the figures of two films over time: CSV, or SVG as a picture")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--report", options->report, "write a page of HTML that shows what changed")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("--junit", options->junit, "write the outcome as JUnit XML")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option("--markdown", options->markdown,
                   "add a table in Markdown to a file, such as $GITHUB_STEP_SUMMARY")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option(
          "--update", options->update,
          "approve: copy the pictures of these names, * for any characters, over the reference; not in CI")
      ->type_name("NAME")
      ->check(notEmpty());
  command->add_option("--ppd", options->pixelsPerDegree, "pixels per degree of view, for FLIP (default: 67.02)")
      ->type_name("N")
      ->check(CLI::Range(1.0, 1000.0));
  command->add_option("-j,--jobs", options->jobs, "pairs at a time (default: one for each CPU)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_flag("--force", options->force, "replace files that poinsot did not write");
  addLimits(*command, *options);
  addLimitOptions(*command, *options);
  command->footer(
      "Identical pictures exit 0; near ones, within all the limits, exit 0, with --exact 1; different ones 1.\n"
      "Pictures of another size are different: nothing is resized. How pixels are stored (grey, palette, 16 "
      "bits,\n"
      "opaque alpha) is no difference, except with --exact.\n"
      "Examples:\n"
      "  poinsot diff approved.png new.png --map flip.png\n"
      "  poinsot diff approved/ new/ --report out/diff.html\n"
      "  poinsot diff a.mp4 b.mp4 --curve out/curve.svg --json");
  command->callback([options, &chosen] {
    chosen = [options] {
      return confined(
          *options, [&] { return reachOf(*options); }, [&] { return diff(*options); });
    };
  });
}

}  // namespace poinsot::cli

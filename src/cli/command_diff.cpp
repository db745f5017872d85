// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "cli/approval.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "compare/diff_curve.h"
#include "compare/diff_json.h"
#include "compare/diff_report.h"
#include "compare/diff_text.h"
#include "compare/file_diff.h"
#include "compare/junit.h"
#include "compare/markdown.h"
#include "compare/outcome.h"
#include "compare/pair_approval.h"
#include "compare/picture_rule.h"
#include "core/atomic_file.h"
#include "core/file_error.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "job/render_job.h"
#include "output/film_reader.h"
#include "output/run_files.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;
using core::Error;
using core::ErrorKind;

struct DiffOptions : AllowanceOptions {
  std::string reference, test, rule, mask, map, difference, curve, report, junit, markdown;
  std::vector<std::string> limits =
      std::vector<std::string>(compare::ruleLimits().size());  ///< as typed; empty if not given
  std::vector<std::string> ignore, update;
  double pixelsPerDegree = compare::kFlipPixelsPerDegree;
  int jobs = 0;
  bool json = false, exact = false, quiet = false, force = false;
};

enum class Kind { kPicture, kFolder, kFilm };

/// Returns whether a path is a folder, a film or a picture, judged by its content. @throws Error(kIo) if the path
/// does not exist.
Kind kindOf(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) {
    if (!failure) failure = std::make_error_code(std::errc::no_such_file_or_directory);
    throw core::FileError(ErrorKind::kIo, fmt::format("{}: {}", core::printable(path.native()), failure.message()),
                          path, failure.value());
  }
  if (fs::is_directory(status)) return Kind::kFolder;
  return output::isFilm(path) ? Kind::kFilm : Kind::kPicture;
}

/// Returns how to compare the two paths. A film and a picture are compared as pictures, which differ. A folder and
/// a file are an error.
Kind commonKind(const DiffOptions& options) {
  const Kind reference = kindOf(options.reference), test = kindOf(options.test);
  if (reference == test) return reference;
  if (reference != Kind::kFolder && test != Kind::kFolder) return Kind::kPicture;
  throw core::usageError("REFERENCE and TEST must both be files or both be folders");
}

compare::PictureRule ruleOf(const DiffOptions& options) {
  compare::PictureRule rule;
  if (!options.rule.empty()) rule.limits = compare::namedLimits("--rule", options.rule);
  for (std::size_t i = 0; i < options.limits.size(); ++i)
    if (const compare::RuleLimit& limit = compare::ruleLimits()[i]; !options.limits[i].empty())
      limit.set(rule.limits, limit.option, options.limits[i]);
  compare::expectCanRefuse(rule.limits, "these limits");
  for (const std::string& box : options.ignore) rule.ignore.push_back(compare::ignoredBox("--ignore", box));
  rule.mask = options.mask;
  return rule;
}

std::optional<fs::path> place(const std::string& word) {
  return word.empty() ? std::nullopt : std::optional<fs::path>(word);
}

compare::DiffRequest requestOf(const DiffOptions& options) {
  return {ruleOf(options), options.pixelsPerDegree, place(options.map), place(options.difference),
          granted(options).limits};
}

void enterMaps(output::RunFiles& files, const compare::DiffRequest& request, const compare::FolderNames* names) {
  if (names == nullptr) {
    files.writes(request.map.value_or(""), "--map", compare::mapKind());
    files.writes(request.difference.value_or(""), "--diff-image", compare::mapKind());
    return;
  }
  files.claims(request.map.value_or(""), "--map");
  files.claims(request.difference.value_or(""), "--diff-image");
  for (const std::string& name : names->inBoth) {
    const compare::DiffRequest own = compare::requestForPair(request, name);
    files.writesInNewFolder(own.map.value_or(""), "--map", compare::mapKind());
    files.writesInNewFolder(own.difference.value_or(""), "--diff-image", compare::mapKind());
  }
}

void expectNamesOfReports(const DiffOptions& options, Kind kind) {
  if (!options.curve.empty() && kind != Kind::kFilm) throw core::usageError("--curve: needs two films");
  if (!options.report.empty() && !fs::path(options.report).extension().native().starts_with(".htm"))
    throw core::usageError(fmt::format("report '{}': must be named NAME.html{}", core::printable(options.report),
                                       core::smallLettersHint(options.report, {".html", ".htm"})));
}

/// Registers the files of a run. @param names  file names in the two folders; null for other kinds
void enterFiles(const DiffOptions& options, const compare::DiffRequest& request,
                const compare::FolderNames* names) {
  output::RunFiles files(options.force);
  files.reads(options.reference, "REFERENCE");
  files.reads(options.test, "TEST");
  files.reads(options.mask, "--mask");
  if (names != nullptr) {
    for (const auto* ofReference : {&names->inBoth, &names->onlyInReference})
      for (const std::string& name : *ofReference) files.reads(fs::path(options.reference) / name, "REFERENCE");
    for (const auto* ofTest : {&names->inBoth, &names->onlyInTest})
      for (const std::string& name : *ofTest) files.reads(fs::path(options.test) / name, "TEST");
  }
  enterMaps(files, request, names);
  if (!options.curve.empty()) files.writes(options.curve, "--curve", compare::curveKind(options.curve));
  files.writes(options.report, "--report", compare::reportKind());
  files.writes(options.junit, "--junit", compare::junitKind());
  files.addsTo(options.markdown, "--markdown", compare::markdownKind());
}

/// Comparison of pictures, folders or films, with its reports.
class Diff {
 public:
  explicit Diff(const DiffOptions& options)
      : options_(options), kind_(commonKind(options)), request_(requestOf(options)) {
    if (kind_ == Kind::kFolder) names_ = compare::namesInFolders(options.reference, options.test);
    enterFiles(options, request_, names_ ? &*names_ : nullptr);
    expectNamesOfReports(options, kind_);
  }

  int run() {
    switch (kind_) {
      case Kind::kFolder:
        return finish(
            compare::diffFolders(options_.reference, options_.test, *names_, request_, jobs(), results_));
      case Kind::kFilm:
        return finish(compare::diffFilms(options_.reference, options_.test, request_, jobs()));
      case Kind::kPicture:
        break;
    }
    return finishPictures();
  }

 private:
  int jobs() const { return options_.jobs > 0 ? options_.jobs : job::availableCpus(); }
  compare::DiffNames names() const { return {options_.reference, options_.test}; }
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

  compare::OutcomePageHead headOf(compare::Verdict verdict) const {
    compare::OutcomePageHead head{options_.test, std::string(compare::toString(verdict)),
                                  "compared with " + options_.reference};
    head.page = options_.report;
    head.place = options_.reference;
    head.approve = approveCommand();
    head.pixelsPerDegree = request_.pixelsPerDegree;
    head.exact = options_.exact;
    head.unnamed = &results_;
    return head;
  }

  compare::Outcome outcomeOf(const compare::PictureDiff& diff) const {
    compare::Outcome outcome = compare::outcomeOf(diff, options_.reference, options_.test, request_);
    if (diff.hasFigures) outcome.map = options_.map;
    outcome.approval = compare::approvalOf(outcome, options_.reference);
    return outcome;
  }

  int finishPictures() {
    std::optional<Error> unreadable;
    compare::ComparedPictures compared;
    try {
      compared = compare::compareFiles(options_.reference, options_.test, request_);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kIo) throw;
      unreadable = error;
      compared.diff = compare::unreadablePair(error);
    }
    compare::addMaps(results_, compared, request_);
    const compare::Outcome outcome = outcomeOf(compared.diff);
    addReport([&] { return compare::diffReport(compared, outcome, headOf(compared.diff.verdict)); });
    const std::string text = options_.json ? compare::diffJson(compared.diff, names(), request_)
                             : unreadable  ? ""
                                           : compare::diffText(compared.diff, request_);
    const int code = finish({outcome}, text);
    if (unreadable) throw *unreadable;  // thrown after the reports are written
    return code;
  }

  template <class Page>
  void addReport(Page page) {
    if (!options_.report.empty()) results_.write(options_.report, page());
  }

  int finish(const compare::FolderDiff& diff) {
    auto outcomes = compare::outcomesOf(diff, options_.reference, options_.test, request_);
    for (compare::Outcome& outcome : outcomes) outcome.approval = compare::approvalOf(outcome, options_.reference);
    addReport([&] { return compare::outcomePage(outcomes, headOf(diff.verdict()), jobs()); });
    const int code = finish(outcomes, options_.json ? compare::diffJson(outcomes, names(), request_)
                                                    : compare::diffText(outcomes, diff.names.linkedFolders));
    if (diff.firstError) throw *diff.firstError;  // thrown after the reports are written
    return code;
  }

  void addMaps(const compare::FilmDiff& diff) {
    if (diff.frames.empty() || (!request_.map && !request_.difference)) return;
    compare::forFrames(
        options_.reference, options_.test, {diff.worst()}, request_,
        [&](std::size_t, const compare::ComparedPictures& frame) { compare::addMaps(results_, frame, request_); });
  }

  int finish(const compare::FilmDiff& diff) {
    addMaps(diff);
    if (!options_.curve.empty())
      results_.write(options_.curve, compare::curveText(options_.curve, diff, request_.rule.limits));
    addReport([&] {
      return compare::diffReport(diff, options_.reference, options_.test, request_, headOf(diff.verdict()));
    });
    return finish({outcomeOf(compare::summaryOf(diff))},
                  options_.json ? compare::diffJson(diff, names(), request_) : compare::diffText(diff));
  }

  int finish(const std::vector<compare::Outcome>& outcomes, const std::string& text) {
    addReports(outcomes);
    if (!options_.update.empty()) return approve(outcomes);
    results_.commit();
    say(text);
    const bool passes = compare::countFailures(outcomes, options_.exact) == 0;
    if (!passes && !options_.quiet && !options_.json && compare::countFailures(outcomes, false) == 0)
      writeErr(
          "poinsot: the pixels or the ways of storing them differ, but --exact requires both to be identical\n");
    return passes ? kDone : kNo;
  }

  void addReports(const std::vector<compare::Outcome>& outcomes) {
    const compare::OutcomeReport head{fmt::format("{} and {}", options_.reference, options_.test),
                                      options_.exact,
                                      options_.report,
                                      approveCommand(),
                                      "",
                                      attachmentRoot()};
    if (!options_.junit.empty()) results_.write(options_.junit, compare::junitXml(outcomes, head));
    if (!options_.markdown.empty()) results_.append(options_.markdown, compare::markdownOf(outcomes, head));
  }

  int approve(const std::vector<compare::Outcome>& outcomes) {
    const compare::PairApproval approval =
        compare::addApprovals(results_, outcomes, options_.update, options_.reference, options_.exact);
    results_.commit();
    say(approval.text);
    return approval.complete ? kDone : kNo;
  }

  const DiffOptions& options_;
  Kind kind_;
  compare::DiffRequest request_;
  std::optional<compare::FolderNames> names_;  ///< only for folders
  core::FileBatch results_;
};

FileAccess accessOf(const DiffOptions& options) {
  FileAccess access{
      {},
      {options.reference, options.test},
      {options.map, options.difference, options.curve, options.report, options.junit, options.markdown}};
  if (!options.mask.empty()) access.inputs.push_back(options.mask);
  return access;
}

int diff(const DiffOptions& options) {
  if (!options.update.empty()) {
    expectMayApprove(options);
    compare::expectReplaceable(options.reference);
  }
  return Diff(options).run();
}

void addLimits(const Command& command, DiffOptions& options) {
  constexpr const char* kGroup = "Limits of \"near\"";
  const auto add = [&](const char* name, auto& value, const char* form, const std::string& help) {
    return command.option(name, value, help).type(form).notEmpty().group(kGroup);
  };
  add("--rule", options.rule, "NAME",
      fmt::format("named set of limits: {} (default: near); the options below override single limits",
                  compare::ruleNames()));
  for (std::size_t i = 0; i < options.limits.size(); ++i) {
    const compare::RuleLimit& limit = compare::ruleLimits()[i];
    add(limit.option, options.limits[i], limit.form, limit.help);
  }
  add("--ignore", options.ignore, "X,Y,W,H", "a box of pixels that is not compared; may be given again").repeats();
  add("--mask", options.mask, "FILE", "PNG of the pictures' size; where it is painted, pixels are not compared");
}

}  // namespace

void addDiff(const Command& program) {
  auto options = std::make_shared<DiffOptions>();
  const Command command = program.command("diff", "compare two pictures, folders of them, or films");
  command.option("REFERENCE", options->reference, "PNG file, folder or film").required().notEmpty();
  command.option("TEST", options->test, "PNG file, folder or film to compare with REFERENCE")
      .required()
      .notEmpty();
  command.flag("--exact", options->exact, "exit 0 only for identical pictures that are stored alike");
  command.flag("--json", options->json, "print the figures as a JSON object");
  command.flag("--quiet", options->quiet, "print nothing; only set the exit code");
  command
      .option("--map", options->map,
              "write the FLIP error of each pixel as a PNG in the colours of magma; for folders, a folder of "
              "maps; for films, the map of the worst frame")
      .type("FILE")
      .notEmpty();
  command.option("--diff-image", options->difference, "like --map, but write the difference, amplified 16 times")
      .type("FILE")
      .notEmpty();
  command.option("--curve", options->curve, "write the figures of two films over time, as CSV or as a plot in SVG")
      .type("FILE")
      .notEmpty();
  command.option("--report", options->report, "write a page of HTML that shows what changed")
      .type("FILE")
      .notEmpty();
  command.option("--junit", options->junit, "write the outcome as JUnit XML").type("FILE").notEmpty();
  command
      .option("--markdown", options->markdown, "add a table in Markdown to a NAME.md, or to $GITHUB_STEP_SUMMARY")
      .type("FILE")
      .notEmpty();
  command
      .option(
          "--update", options->update,
          "approve: copy the pictures with these names (* matches any characters) over the reference; not in CI")
      .type("NAME")
      .notEmpty();
  command.option("--ppd", options->pixelsPerDegree, "pixels per degree of view, for FLIP (default: 67.02)")
      .type("N")
      .range(1.0, 1000.0);
  command.option("-j,--jobs", options->jobs, "pairs at a time (default: one for each CPU)")
      .type("N")
      .range(1, 1024);
  command.flag("--force", options->force, "replace files that poinsot did not write");
  addLimits(command, *options);
  addLimitOptions(command, *options);
  command.footer(
      "Exit code 0 if the pictures are identical or near, that is, within all limits; 1 if they are different,\n"
      "or near with --exact. Pictures of different size are different: nothing is resized. How pixels are stored\n"
      "(grey, palette, 16 bits, opaque alpha) counts as a difference only with --exact.\n"
      "Examples:\n"
      "  poinsot diff approved.png new.png --map flip.png\n"
      "  poinsot diff approved/ new/ --report out/diff.html\n"
      "  poinsot diff a.mp4 b.mp4 --curve out/curve.svg --json");
  command.does({[options] { return diff(*options); }, options.get(), [options] { return accessOf(*options); }});
}

}  // namespace poinsot::cli

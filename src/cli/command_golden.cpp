// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

#include "cli/approval.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "cli/golden_options.h"
#include "cli/notes.h"
#include "cli/scene_options.h"
#include "cli/untrusted.h"
#include "compare/diff_json.h"
#include "compare/junit.h"
#include "compare/markdown.h"
#include "compare/outcome_page.h"
#include "compare/outcome_script.h"
#include "compare/page_approval.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/folder.h"
#include "core/shell_word.h"
#include "core/text.h"
#include "job/render_job.h"
#include "output/run_files.h"
#include "process/interrupt.h"
#include "suite/approval.h"
#include "suite/checks.h"
#include "suite/strays.h"
#include "suite/suite.h"
#include "suite/values.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;
using compare::Outcome;
using compare::OutcomeStatus;
using core::Error;

gl::Backend backendOf(const std::string& word) {
  return word == "osmesa" ? gl::Backend::kOsMesa : word == "egl" ? gl::Backend::kEgl : gl::Backend::kAuto;
}

suite::GoldenRequest requestOf(const GoldenOptions& options, scene::Allowance allowance) {
  return {options.only,
          options.output,
          options.jobs > 0 ? options.jobs : job::availableCpus(),
          backendOf(options.backend),
          !options.native,
          std::move(allowance),
          options.variant};
}

std::string lineOf(const Outcome& outcome, const std::string& message) {
  return fmt::format("{:<10} {}{}{}\n", toString(outcome.status), core::printable(outcome.name),
                     message.empty() ? "" : ": ", message);
}

/// Returns why an outcome has its status. For a picture within tolerance (kNear), returns only the reason of its
/// rule.
std::string lineReason(const Outcome& outcome) {
  return outcome.status == OutcomeStatus::kNear ? outcome.message : compare::reasonOf(outcome);
}

/// Returns a line for each outcome that `wanted` selects. If several pictures of one scene have the same error,
/// prints the error once.
template <typename Wanted>
std::string linesOf(const std::vector<Outcome>& outcomes, Wanted wanted) {
  std::string lines, lastError;
  for (const Outcome& outcome : outcomes) {
    if (!wanted(outcome)) continue;
    const bool again = outcome.status == OutcomeStatus::kError && outcome.message == lastError;
    lines += lineOf(outcome, again ? "same error as above" : lineReason(outcome));
    if (outcome.status == OutcomeStatus::kError) lastError = outcome.message;
  }
  return lines;
}

void enterReports(output::RunFiles& files, const GoldenOptions& options) {
  if (!options.outcome.empty() && fs::path(options.outcome).extension() != ".js")
    throw core::usageError(fmt::format("outcome '{}': must be named NAME.js{}", core::printable(options.outcome),
                                       core::smallLettersHint(options.outcome, {".js"})));
  files.writes(options.report, "--report", compare::reportKind());
  files.writes(options.junit, "--junit", compare::junitKind());
  files.writes(options.outcome, "--outcome", compare::outcomeScriptKind());
  files.addsTo(options.markdown, "--markdown", compare::markdownKind());
}

class Golden {
 public:
  explicit Golden(const GoldenOptions& options)
      : options_(options),
        request_(requestOf(options, granted(options))),
        manifest_(suite::readGoldenManifest(options.manifest, request_.allowance, options.images)),
        files_(options.force) {}

  int run() {
    if (!options_.images.empty() && !fs::is_directory(options_.images))
      throw core::ioError(fmt::format("--images {}: no such folder", core::printable(options_.images)));
    suite::expectFilesApart(manifest_, allCases(), request_.output);
    if (options_.list) return list();
    checkOptions();
    checkPlaces();
    process::watchInterrupts();
    outcomes_ = options_.unused ? suite::unusedReferences(manifest_) : suite::runGoldens(manifest_, request_);
    const auto isError = [](const Outcome& o) { return o.status == OutcomeStatus::kError; };
    writeErr(options_.quiet ? linesOf(outcomes_, isError) : rendererNotes(renderers()));
    if (options_.update) return update();
    writeReports();
    tell();
    return failures() == 0 ? kDone : kNo;
  }

 private:
  std::vector<suite::GoldenCase> allCases() const {
    suite::GoldenRequest all = request_;
    all.only.clear();
    return suite::casesOf(manifest_, all);
  }

  /// Returns the renderers that drew the scenes. Omits pictures from other programs, whose renderers are unknown.
  std::set<std::string> renderers() const {
    std::set<std::string> all;
    for (const Outcome& outcome : outcomes_)
      if (!outcome.origin.scene.empty()) all.insert(outcome.origin.renderer);
    return all;
  }

  int list() const {
    const std::vector<suite::GoldenCase> cases = suite::casesOf(manifest_, request_);
    if (options_.json) writeOut(suite::casesJson(cases));
    if (!options_.json)
      for (const suite::GoldenCase& one : cases) writeOut(one.name + "\n");
    return kDone;
  }

  void checkOptions() const {
    if (options_.update) expectMayApprove(options_);
    if (options_.beside && !options_.update) throw core::usageError("--beside: needs --update");
    if (options_.unused && (options_.update || !options_.only.empty()))
      throw core::usageError("--unused: looks at all tests and approves nothing; leave out --only and --update");
    if (!options_.update && !options_.unused)
      suite::expectKnownVariants(manifest_, request_,
                                 options_.approveBy.empty() ? "--update --beside" : options_.approveBy);
    if (options_.beside && !namesVariants()) expectOnlyScenes();
  }

  /// Returns whether images belong to named variants. If any do, images without a name share one unnamed variant.
  bool namesVariants() const {
    return !options_.variant.empty() || std::ranges::any_of(manifest_.tests, [](const suite::GoldenTest& test) {
      return test.scene.empty() && !test.variant.empty();
    });
  }

  void expectOnlyScenes() const {
    for (const suite::GoldenCase& one : suite::casesOf(manifest_, request_))
      if (one.test.scene.empty())
        throw core::usageError(
            fmt::format("--beside: {}: another program made this picture, so its renderer is unknown; name the "
                        "renderer with --variant, or choose other tests with --only",
                        core::printable(one.name)));
  }

  /// Checks that all outputs can be written, and that no output replaces a file of another program.
  void checkPlaces() {
    enterFiles(suite::casesOf(manifest_, request_));
    if (options_.unused) return;
    core::makeFolders(request_.output);
    core::expectWritableFolder(request_.output);
  }

  void enterFiles(const std::vector<suite::GoldenCase>& cases) {
    files_.reads(options_.manifest, "MANIFEST");
    for (const suite::GoldenCase& one : cases) {
      files_.reads(one.test.scene.empty() ? one.actual : one.test.scene, "the suite's file");
      files_.reads(one.test.rule.mask, "the suite's file");
    }
    suite::enterPatterns(files_, manifest_);
    enterReferences(cases);
    for (const suite::GoldenCase& one : cases)
      if (!one.test.isUnmatched && !options_.unused) suite::enterFilesMade(files_, one, request_.output);
    enterReports(files_, options_);
    request_.files = &files_;
  }

  void enterReferences(const std::vector<suite::GoldenCase>& cases) {
    std::set<fs::path> folders;
    for (const suite::GoldenCase& one : cases) {
      const fs::path usual = suite::usualFile(manifest_.references, one.reference());
      if (options_.update && !one.test.isUnmatched) suite::enterApproval(files_, usual);
      folders.insert(usual.parent_path());
    }
    if (options_.update) return;  // an update writes no reports; expectFilesApart() checks the other files
    for (const fs::path& folder : folders)
      for (const fs::path& file : core::filesIn(folder)) files_.reads(file, "the reference");
  }

  void say(const std::string& text) const {
    if (!options_.quiet) writeOut(text);
  }

  std::ptrdiff_t failures() const { return compare::countFailures(outcomes_, options_.exact); }

  /// Returns whether the run would pass without --exact.
  bool onlyNear() const {
    return options_.exact && failures() > 0 &&
           std::ranges::all_of(outcomes_, [](const Outcome& o) { return o.passes(false); });
  }

  void tell() const {
    if (options_.json) return say(compare::suiteJson(outcomes_, {manifest_.references, options_.output}));
    say(linesOf(outcomes_, [&](const Outcome& o) {
      return o.status != OutcomeStatus::kIdentical || !o.passes(options_.exact);
    }));
    say(fmt::format("{}{}\n", outcomes_.empty() ? "no unused references" : compare::countsText(outcomes_),
                    onlyNear() ? ": not all identical, as --exact requires" : ""));
    if (failures() == 0) return;
    if (!options_.unused) say(fmt::format("new pictures and maps: {}\n", core::printable(options_.output)));
    if (!options_.report.empty()) say(fmt::format("page: {}\n", core::printable(options_.report)));
    const std::string approve = compare::approveCommand(outcomes_, reportHead());
    if (!approve.empty())
      say(fmt::format("if the new {}: {}\n",
                      failures() == 1 ? "picture is right, approve it" : "pictures are right, approve them",
                      approve));
  }

  std::string suite() const { return fs::absolute(manifest_.file).lexically_normal().parent_path().filename(); }

  compare::OutcomeReport reportHead() const {
    return {suite(), options_.exact, options_.report, approveCommand(), options_.approveBy, attachmentRoot()};
  }

  /// Returns a command that approves tests under the conditions of this run. The caller appends the names of the
  /// tests.
  std::string approveCommand() const {
    std::vector<std::string> words{"poinsot", "golden", options_.manifest};
    const std::vector<std::string> allowance = allowanceWords(options_);
    words.insert(words.end(), allowance.begin(), allowance.end());
    if (options_.backend != "auto") words.insert(words.end(), {"--backend", options_.backend});
    if (options_.native) words.emplace_back("--native");
    if (!options_.images.empty()) words.insert(words.end(), {"--images", options_.images});
    if (options_.output != GoldenOptions().output) words.insert(words.end(), {"-o", options_.output});
    if (!options_.variant.empty()) words.insert(words.end(), {"--variant", options_.variant});
    if (options_.exact) words.emplace_back("--exact");
    if (failsForAVariant()) words.emplace_back("--beside");
    words.insert(words.end(), {"--update", "--only"});
    return core::shellWords(words);
  }

  /// Returns whether an image to approve has a variant. The references of its other variants must then stay.
  bool failsForAVariant() const {
    std::set<std::string> ofVariants;
    for (const suite::GoldenCase& one : suite::casesOf(manifest_, request_))
      if (!one.variant().empty()) ofVariants.insert(one.name);
    return std::ranges::any_of(outcomes_, [&](const Outcome& outcome) {
      return compare::isToApprove(outcome, options_.exact) && ofVariants.contains(outcome.name);
    });
  }

  void writeReports() const {
    core::FileBatch reports;
    const auto add = [&](const std::string& file, const auto& text) {
      if (!file.empty()) reports.write(file, text());
    };
    add(options_.junit, [&] { return compare::junitXml(outcomes_, reportHead()); });
    add(options_.report, [&] { return compare::outcomePage(withApprovals(), pageHead(), request_.jobs); });
    add(options_.outcome, [&] { return compare::outcomeScript(outcomes_, reportHead(), options_.outcome); });
    if (!options_.markdown.empty())
      reports.append(options_.markdown, compare::markdownOf(outcomes_, reportHead()));
    reports.commit();
  }

  /// Returns the outcomes with the files that approve them. A picture that --update would refuse has none.
  std::vector<Outcome> withApprovals() const {
    std::vector<Outcome> outcomes = outcomes_;
    const suite::GoldenApproval approval(manifest_.references, failsForAVariant());
    const std::vector<suite::GoldenCase> cases = suite::casesOf(manifest_, request_);
    for (std::size_t i = 0; i < cases.size() && !options_.unused; ++i) try {
        if (compare::isToApprove(outcomes[i], options_.exact))
          outcomes[i].approval = approval.filesOf(cases[i].reference(), outcomes[i]);
      } catch (const Error&) {  // --update would print the reason
      }
    return outcomes;
  }

  compare::OutcomePageHead pageHead() const {
    compare::OutcomePageHead head{suite(), failures() == 0 ? "passed" : "failed", "", "approved", "new", "Test"};
    head.page = options_.report;
    head.place = manifest_.file;
    head.approve = approveCommand();
    head.exact = options_.exact;
    return head;
  }

  /// Approves all changed pictures. Approves nothing if any picture could not be drawn or read.
  /// @returns kNo if a picture had an error or is missing, or if a reference is unused
  int update() const {
    const auto isThere = [](const Outcome& o) {
      return o.status != OutcomeStatus::kError && o.status != OutcomeStatus::kUnused &&
             o.status != OutcomeStatus::kMissing;
    };
    const bool allMade = std::ranges::count(outcomes_, OutcomeStatus::kError, &Outcome::status) == 0;
    if (allMade) say(approve());
    say(linesOf(outcomes_, std::not_fn(isThere)));
    if (!allMade) say("nothing was approved: fix the errors, or choose the other tests with --only\n");
    return std::ranges::all_of(outcomes_, isThere) ? kDone : kNo;
  }

  /// Returns whether a picture needs its own reference although it equals an existing one. Reasons are: the
  /// existing reference has no description, or belongs to another variant.
  bool lacksOwn(const Outcome& outcome) const {
    const bool isImage = outcome.origin.scene.empty();
    return !hasOrigin(outcome) || (options_.beside && isImage && !isOfOwnRenderer(outcome));
  }

  static bool isOfOwnRenderer(const Outcome& outcome) {
    return outcome.approved.renderer == outcome.origin.renderer;
  }

  static bool hasOrigin(const Outcome& outcome) {
    return suite::isDescription(suite::descriptionOf(outcome.reference));
  }

  std::string approve() const {
    suite::GoldenApproval approval(manifest_.references, options_.beside, options_.force);
    const std::vector<suite::GoldenCase> cases = suite::casesOf(manifest_, request_);
    std::string lines = fmt::format("nothing to approve: {}\n", compare::countsText(outcomes_));
    bool isFirst = true;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (!compare::isToApprove(outcomes_[i], options_.exact) && !lacksOwn(outcomes_[i])) continue;
      if (std::exchange(isFirst, false)) lines.clear();
      lines += approvalLines(outcomes_[i], approval.add(cases[i].reference(), outcomes_[i]));
    }
    approval.commit();
    return lines;
  }

  std::string approvalLines(const Outcome& outcome, const suite::Approval& approval) const {
    std::string lines;
    for (const fs::path& file : approval.removed)
      lines += fmt::format("{}: removed: it was approved for an earlier scene or picture\n",
                           core::printable(file.native()));
    if (compare::isToApprove(outcome, options_.exact) || !isOfOwnRenderer(outcome))
      lines += fmt::format("{}: {}\n", core::printable(approval.place.native()), compare::approvalText(outcome));
    return lines;
  }

  const GoldenOptions& options_;
  suite::GoldenRequest request_;
  suite::GoldenManifest manifest_;
  output::RunFiles files_;
  std::vector<Outcome> outcomes_;
};

/// Runs `golden approve REPORT NAME ...`: approves pictures of a page that --report wrote, without drawing again.
int approvePage(const GoldenOptions& options) {
  if (options.approved.size() < 2)
    throw core::usageError(
        "golden approve: needs a report and the names of tests: poinsot golden approve REPORT NAME ...");
  expectMayApprove(options, "golden approve");
  core::FileBatch batch;
  const std::vector<std::string> names(options.approved.begin() + 1, options.approved.end());
  const std::string text =
      compare::approveOnPage(batch, options.approved.front(), names, compare::approvalRoot(fs::current_path()));
  batch.commit();
  if (!options.quiet) writeOut(text);
  return kDone;
}

/// Rejects options for reports together with --update, because an update writes no reports.
void expectNoReports(const GoldenOptions& options) {
  const auto expectNone = [](const char* option, bool given) {
    if (given)
      throw core::usageError(fmt::format("--update: approves, and writes no reports; leave out {}", option));
  };
  expectNone("--junit", !options.junit.empty());
  expectNone("--report", !options.report.empty());
  expectNone("--markdown", !options.markdown.empty());
  expectNone("--outcome", !options.outcome.empty());
  expectNone("--json", options.json);
}

/// Removes the reports of an earlier run, because this run may stop before it writes its own.
void removeReports(const GoldenOptions& options) {
  const auto remove = [](const std::string& file, const output::FileKind& kind) {
    std::error_code ignored;
    if (!file.empty() && kind.isOwn(file)) fs::remove(file, ignored);
  };
  remove(options.report, compare::reportKind());
  remove(options.junit, compare::junitKind());
}

/// Returns whether the outcome file is missing or was written by poinsot, so that it may be replaced at once. With
/// --force, the name may belong to a file of another kind, such as a scene.
bool isOurs(const std::string& outcome) {
  std::error_code ignored;
  return !outcome.empty() && (!fs::exists(outcome, ignored) || compare::outcomeScriptKind().isOwn(outcome));
}

/// Runs the suite. First marks the outcome file as unfinished. Without the mark, an index page would show the
/// outcome of an earlier run if this run stops early.
int runGolden(const GoldenOptions& options) {
  if (options.manifest == "approve") return approvePage(options);
  if (!options.approved.empty())
    throw core::usageError(fmt::format("golden: {}: only one manifest is possible; choose tests with --only",
                                       core::printable(options.approved.front())));
  if (options.list) return Golden(options).run();
  if (options.update) expectNoReports(options);
  output::RunFiles files(options.force);
  files.reads(options.manifest, "MANIFEST");
  enterReports(files, options);
  removeReports(options);
  if (!isOurs(options.outcome)) return Golden(options).run();
  const auto write = [&](const std::string& message) {
    core::writeFileAtomically(options.outcome, compare::brokenOutcomeScript(message));
  };
  write("did not finish");
  try {
    return Golden(options).run();
  } catch (const Error& error) {
    try {
      write(error.what());
    } catch (const Error&) {  // the file keeps the text "did not finish"
    }
    throw;
  }
}

FileAccess accessOf(const GoldenOptions& options) {
  FileAccess access{{options.manifest},
                    options.assetRoots,
                    {options.junit, options.report, options.markdown, options.outcome},
                    {options.output},
                    !options.native};
  if (!options.images.empty()) access.inputs.push_back(options.images);
  return access;
}

}  // namespace

void addGolden(const Command& program) {
  auto options = std::make_shared<GoldenOptions>();
  const Command command =
      program.command("golden", "make the pictures of a golden.toml and compare them with the approved ones");
  addGoldenOptions(command, *options);
  command.footer(
      "Exit code 0 if all pictures are identical or near; 1 if a picture is different, missing, new, or cannot\n"
      "be made or read, or if no test makes an approved picture.\n"
      "Examples:\n"
      "  poinsot golden tests/golden.toml --report out/golden.html --junit out/golden.xml\n"
      "  poinsot golden tests/golden.toml --update --only racket\n"
      "  poinsot golden approve out/golden.html racket");
  command.does(
      {[options] { return runGolden(*options); }, options.get(), [options] { return accessOf(*options); }});
}

}  // namespace poinsot::cli

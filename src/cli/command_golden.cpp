// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <system_error>

#include "app/diff_json.h"
#include "app/golden_strays.h"
#include "app/golden_suite.h"
#include "app/interrupt.h"
#include "app/junit.h"
#include "app/markdown.h"
#include "app/outcome_page.h"
#include "app/outcome_script.h"
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
#include "output/target_check.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;
using app::Outcome;
using app::OutcomeStatus;
using core::Error;
using core::ErrorKind;

struct GoldenOptions : AllowanceOptions {
  std::string manifest = "golden.toml", output = "out/golden", images, junit, report, markdown, outcome, variant,
              approveBy, backend = "auto";
  std::vector<std::string> only;
  int jobs = 0;
  bool force = false, update = false, beside = false, exact = false, native = false, list = false, unused = false,
       quiet = false, json = false;
};

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorKind::kUsage, message); }

gl::Backend backendOf(const std::string& word) {
  return word == "osmesa" ? gl::Backend::kOsMesa : word == "egl" ? gl::Backend::kEgl : gl::Backend::kAuto;
}

app::GoldenRequest requestOf(const GoldenOptions& options, scene::Allowance allowance) {
  return {options.only,
          options.output,
          options.jobs > 0 ? options.jobs : app::availableCpus(),
          backendOf(options.backend),
          !options.native,
          std::move(allowance),
          options.variant};
}

std::string lineOf(const Outcome& outcome, const std::string& message) {
  return fmt::format("{:<10} {}{}{}\n", toString(outcome.status), core::printable(outcome.name),
                     message.empty() ? "" : ": ", message);
}

/// What a near picture is near by stands alone.
std::string lineReason(const Outcome& outcome) {
  return outcome.status == OutcomeStatus::kNear ? outcome.message : app::reasonOf(outcome);
}

/// A line for each outcome that is wanted. What is wrong with a scene is said once, at the first of its pictures.
template <typename Wanted>
std::string linesOf(const std::vector<Outcome>& outcomes, Wanted wanted) {
  std::string lines, lastError;
  for (const Outcome& outcome : outcomes) {
    if (!wanted(outcome)) continue;
    const bool again = outcome.status == OutcomeStatus::kError && outcome.message == lastError;
    lines += lineOf(outcome, again ? "the same" : lineReason(outcome));
    if (outcome.status == OutcomeStatus::kError) lastError = outcome.message;
  }
  return lines;
}

/// One run of a suite.
class Golden {
 public:
  explicit Golden(const GoldenOptions& options)
      : options_(options),
        request_(requestOf(options, granted(options))),
        manifest_(app::readGoldenManifest(options.manifest, request_.allowance, options.images)) {}

  int run() {
    if (options_.list) return list();
    checkOptions();
    checkPlaces();
    app::watchInterrupts();
    outcomes_ = options_.unused ? app::unusedReferences(manifest_) : app::runGoldens(manifest_, request_);
    if (options_.update) return update();
    writeReports();
    tell();
    return failures() == 0 ? kDone : kNo;
  }

 private:
  int list() const {
    const std::vector<app::GoldenCase> cases = app::casesOf(manifest_, request_);
    if (options_.json) writeOut(app::listJson(cases));
    if (!options_.json)
      for (const app::GoldenCase& one : cases) writeOut(one.name + "\n");
    return kDone;
  }

  void checkOptions() const {
    if (options_.update) expectMayApprove(options_);
    if (options_.beside && !options_.update) refuse("--beside: goes with --update");
    if (options_.unused && (options_.update || !options_.only.empty()))
      refuse("--unused: looks at all tests and approves nothing; leave out --only and --update");
    const std::vector<app::GoldenCase> cases = app::casesOf(manifest_, request_);
    if (!options_.update && !options_.unused)
      app::expectKnownVariants(manifest_, cases,
                               options_.approveBy.empty() ? "--update --beside" : options_.approveBy);
    if (!options_.beside) return;
    for (const app::GoldenCase& one : cases)
      if (one.test.scene.empty() && one.variant().empty())
        refuse(fmt::format(
            "--beside: {}: of a picture that another program made, the renderer is not known: name it by "
            "--variant, or choose tests with --only",
            core::printable(one.name)));
  }

  /// New pictures may not come to lie on approved ones, nor reports on what somebody else wrote.
  void checkPlaces() const {
    std::error_code ignored;
    if (!options_.unused) {
      output::makeFolders(request_.output);
      output::expectWritableFolder(request_.output);
    }
    if (fs::equivalent(request_.output, manifest_.references, ignored))
      refuse(fmt::format("-o {}: there are the approved pictures", core::printable(options_.output)));
    if (!options_.report.empty()) output::checkTarget(options_.report, options_.force);
    if (!options_.junit.empty())
      output::checkTarget(options_.junit, options_.force || output::beginsWith(options_.junit, app::kJunitMark));
  }

  void say(const std::string& text) const {
    if (!options_.quiet) writeOut(text);
  }

  std::ptrdiff_t failures() const { return app::countFailures(outcomes_, options_.exact); }

  /// Whether nothing but --exact makes it fail.
  bool onlyNear() const {
    return options_.exact && failures() > 0 &&
           std::ranges::all_of(outcomes_, [](const Outcome& o) { return o.passes(false); });
  }

  void tell() const {
    if (options_.json) return say(app::suiteJson(outcomes_, {manifest_.references, options_.output}));
    say(linesOf(outcomes_, [](const Outcome& o) { return o.status != OutcomeStatus::kIdentical; }));
    say(fmt::format("{}{}\n", outcomes_.empty() ? "nothing approved is unused" : app::countsText(outcomes_),
                    onlyNear() ? ": not all identical, as --exact asks" : ""));
    if (failures() == 0) return;
    if (!options_.unused) say(fmt::format("new pictures and maps: {}\n", core::printable(options_.output)));
    if (!options_.report.empty()) say(fmt::format("page: {}\n", core::printable(options_.report)));
    const std::string approve = app::approveCommand(outcomes_, reportHead());
    if (!approve.empty())
      say(fmt::format("if the new {}: {}\n",
                      failures() == 1 ? "picture is right, approve it" : "pictures are right, approve them",
                      approve));
  }

  std::string suite() const { return fs::absolute(manifest_.file).parent_path().filename(); }

  app::OutcomeReport reportHead() const {
    return {suite(), options_.exact, options_.report, approveCommand(), options_.approveBy, attachmentRoot()};
  }

  /// The command that approves tests, drawn and compared in the same way; their names follow.
  std::string approveCommand() const {
    std::vector<std::string> words{"poinsot", "golden", options_.manifest};
    for (const std::string& root : options_.assetRoots) words.insert(words.end(), {"--asset-root", root});
    if (options_.backend != "auto") words.insert(words.end(), {"--backend", options_.backend});
    if (options_.native) words.emplace_back("--native");
    if (!options_.images.empty()) words.insert(words.end(), {"--images", options_.images});
    if (!options_.variant.empty()) words.insert(words.end(), {"--beside", "--variant", options_.variant});
    words.insert(words.end(), {"--update", "--only"});
    return core::shellWords(words);
  }

  void writeReports() const {
    if (!options_.junit.empty())
      output::writeFileAtomically(options_.junit, app::junitXml(outcomes_, reportHead()));
    if (!options_.markdown.empty())
      output::appendToFile(options_.markdown, app::markdownOf(outcomes_, reportHead()));
    if (!options_.report.empty())
      output::writeFileAtomically(options_.report, app::outcomePage(outcomes_, pageHead(), request_.jobs));
    if (!options_.outcome.empty())
      output::writeFileAtomically(options_.outcome, app::outcomeScript(outcomes_, reportHead(), options_.outcome));
  }

  app::OutcomePageHead pageHead() const {
    app::OutcomePageHead head{suite(), failures() == 0 ? "passed" : "failed", "", "approved", "new", "Test"};
    head.page = options_.report;
    head.place = manifest_.file;
    head.approve = approveCommand();
    return head;
  }

  /// Approves what is not as it was; exit 1 only where there is no picture to approve.
  int update() const {
    const auto isThere = [](const Outcome& o) {
      return o.status != OutcomeStatus::kError && o.status != OutcomeStatus::kUnused;
    };
    for (const Outcome& outcome : outcomes_)
      if (isThere(outcome) && (outcome.status != OutcomeStatus::kIdentical || !hasOrigin(outcome)))
        approve(outcome);
    say(linesOf(outcomes_, std::not_fn(isThere)));
    return std::ranges::all_of(outcomes_, isThere) ? kDone : kNo;
  }

  /// Whether it is written down what the reference was made with.
  static bool hasOrigin(const Outcome& outcome) {
    std::error_code ignored;
    return fs::exists(fs::path(outcome.reference).replace_extension(".json"), ignored);
  }

  void approve(const Outcome& outcome) const {
    const app::Approval approval = app::approve(outcome.actual, outcome.origin, manifest_.references,
                                                {outcome.name, outcome.actual.extension()}, options_.beside);
    for (const fs::path& file : approval.removed)
      say(fmt::format("{}: removed, as it was approved for what is no more\n", core::printable(file.native())));
    if (outcome.status == OutcomeStatus::kIdentical) return;
    say(fmt::format("{}: {}\n", core::printable(approval.place.native()), app::approvalText(outcome)));
  }

  const GoldenOptions& options_;
  app::GoldenRequest request_;
  app::GoldenManifest manifest_;
  std::vector<Outcome> outcomes_;
};

/// Runs the suite. An index page shows the last outcome that it finds, so that of an earlier run goes first: this
/// one may end before it has one.
int runGolden(const GoldenOptions& options) {
  if (options.outcome.empty() || options.list) return Golden(options).run();
  const auto write = [&](const std::string& message) {
    output::writeFileAtomically(options.outcome, app::brokenOutcomeScript(message));
  };
  output::checkTarget(options.outcome,
                      options.force || output::beginsWith(options.outcome, app::kOutcomeScriptMark));
  write("did not finish");
  try {
    return Golden(options).run();
  } catch (const Error& error) {
    write(error.what());
    throw;
  }
}

Reach reachOf(const GoldenOptions& options) {
  Reach reach{{options.manifest},
              options.assetRoots,
              {options.junit, options.report, options.markdown, options.outcome},
              {options.output},
              !options.native};
  if (!options.images.empty()) reach.inputs.push_back(options.images);
  return reach;
}

}  // namespace

void addGolden(CLI::App& program, Action& chosen) {
  auto options = std::make_shared<GoldenOptions>();
  CLI::App* command = program.add_subcommand("golden", "make the pictures of a golden.toml and compare them");
  command->add_option("MANIFEST", options->manifest, "what to make and compare (default: golden.toml)")
      ->check(notEmpty());
  command
      ->add_option("--only", options->only,
                   "only the tests of these names, * for any characters, or of a file as the manifest has it")
      ->type_name("NAME")
      ->check(notEmpty());
  command->add_flag("--update", options->update,
                    "approve the new pictures, and say how far each is from the one before; not in CI");
  command->add_flag("--beside", options->beside,
                    "with --update: keep what was approved of other renderers, and add this one's");
  command
      ->add_option("--variant", options->variant,
                   "what made the images of other programs, where references differ by it")
      ->type_name("NAME")
      ->check(notEmpty());
  command
      ->add_option("--images", options->images,
                   "folder from which paths of images are, such as a build folder (default: the manifest's)")
      ->type_name("FOLDER")
      ->check(notEmpty());
  command->add_flag("--exact", options->exact, "only identical pictures pass");
  command->add_option("--junit", options->junit, "write the outcome as JUnit XML")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option("--markdown", options->markdown,
                   "add a table in Markdown to a file, such as $GITHUB_STEP_SUMMARY")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_flag("--json", options->json, "the outcome as a JSON object, with the figures that diff has");
  command->add_option("--approve-by", options->approveBy, "command that reports name as the one that approves")
      ->type_name("COMMAND")
      ->check(notEmpty());
  command->add_option("--report", options->report, "write a page of HTML that shows what changed")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      ->add_option("--outcome", options->outcome,
                   "write verdict and reason as a script that an index page of several runs loads")
      ->type_name("FILE")
      ->check(notEmpty());
  command->add_option("-o,--output", options->output, "folder of new pictures and maps (default: out/golden)")
      ->type_name("FOLDER")
      ->check(notEmpty());
  command->add_option("-j,--jobs", options->jobs, "pictures at a time (default: one for each CPU)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command->add_option("--backend", options->backend, "what draws: auto, osmesa or egl")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
  command->add_flag("--native", options->native, "draw as fast as this CPU can, not the same on each");
  command->add_flag("--force", options->force, "replace reports that poinsot did not write");
  command->add_flag("--list", options->list, "only list the tests; with --json, with their files");
  command->add_flag("--unused", options->unused,
                    "make nothing, only look for what is approved and made by no test");
  command->add_flag("--quiet", options->quiet, "only the exit code");
  addAllowance(*command, *options);
  command->footer(
      "Exit code 0 when all are identical or near, 1 when some is not, is new, or is approved and made by no "
      "test.\n"
      "Examples:\n"
      "  poinsot golden tests/golden.toml --report out/golden.html --junit out/golden.xml\n"
      "  poinsot golden tests/golden.toml --update --only racket");
  command->callback([options, &chosen] {
    chosen = [options] {
      return confined(
          *options, [&] { return reachOf(*options); }, [&] { return runGolden(*options); });
    };
  });
}

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "cli/golden_options.h"

#include <CLI/CLI.hpp>

#include "cli/scene_options.h"

namespace poinsot::cli {

void addGoldenOptions(CLI::App& command, GoldenOptions& options) {
  command.add_option("MANIFEST", options.manifest, "what to make and compare (default: golden.toml)")
      ->check(notEmpty());
  command
      .add_option("--only", options.only,
                  "only the tests of these names, * for any characters, or of a file as the manifest has it")
      ->type_name("NAME")
      ->check(notEmpty());
  command.add_flag("--update", options.update,
                   "approve the new pictures, and say how far each is from the one before; not in CI");
  command.add_flag("--beside", options.beside,
                   "with --update: keep what was approved of other renderers, and add this one's");
  command
      .add_option("--variant", options.variant,
                  "what made the images of other programs, where references differ by it")
      ->type_name("NAME")
      ->check(notEmpty());
  command
      .add_option("--images", options.images,
                  "folder from which paths of images are, such as a build folder (default: the manifest's)")
      ->type_name("FOLDER")
      ->check(notEmpty());
  command.add_flag("--exact", options.exact, "only identical pictures that are stored alike pass");
  command.add_option("--junit", options.junit, "write the outcome as JUnit XML")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      .add_option("--markdown", options.markdown,
                  "add a table in Markdown to a NAME.md, or to $GITHUB_STEP_SUMMARY")
      ->type_name("FILE")
      ->check(notEmpty());
  command.add_flag("--json", options.json, "the outcome as a JSON object, with the figures that diff has");
  command.add_option("--approve-by", options.approveBy, "command that reports name as the one that approves")
      ->type_name("COMMAND")
      ->check(notEmpty());
  command.add_option("--report", options.report, "write a page of HTML that shows what changed")
      ->type_name("FILE")
      ->check(notEmpty());
  command
      .add_option("--outcome", options.outcome,
                  "write verdict and reason as a script that an index page of several runs loads")
      ->type_name("FILE")
      ->check(notEmpty());
  command.add_option("-o,--output", options.output, "folder of new pictures and maps (default: out/golden)")
      ->type_name("FOLDER")
      ->check(notEmpty());
  command.add_option("-j,--jobs", options.jobs, "pictures at a time (default: one for each CPU)")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  command.add_option("--backend", options.backend, "what draws: auto, osmesa or egl")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
  command.add_flag("--native", options.native, "draw as fast as this CPU can, not the same on each");
  command.add_flag("--force", options.force, "replace reports that poinsot did not write");
  command.add_flag("--list", options.list, "only list the tests; with --json, with their files");
  command.add_flag("--unused", options.unused, "make nothing, only look for what is approved and made by no test");
  command.add_flag("--quiet", options.quiet, "only the exit code, and tests that could not be run");
  addAllowance(command, options);
}

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "cli/golden_options.h"

#include "cli/command.h"
#include "cli/scene_options.h"

namespace poinsot::cli {

void addGoldenOptions(const Command& command, GoldenOptions& options) {
  command
      .option("MANIFEST", options.manifest,
              "file that lists the pictures to make and compare (default: golden.toml)")
      .notEmpty();
  command
      .option("NAME", options.approved,
              "after the word approve: a page that --report wrote, and the names of tests whose new pictures are "
              "approved (* matches any characters)")
      .notEmpty();
  command
      .option("--only", options.only,
              "only tests with these names (* matches any characters), or tests whose scene or image has this "
              "path in the manifest")
      .type("NAME")
      .notEmpty();
  command.flag("--update", options.update,
               "approve the new pictures, and print how far each is from the previous one; not in CI");
  command.flag("--beside", options.beside,
               "with --update: keep the references of other renderers, and add those of this renderer");
  command
      .option(
          "--variant", options.variant,
          "name of the driver or machine that drew the images of other programs; compares with its own references")
      .type("NAME")
      .notEmpty();
  command
      .option(
          "--images", options.images,
          "folder that the paths of images start from, such as a build folder (default: the manifest's folder)")
      .type("FOLDER")
      .notEmpty();
  command.flag("--exact", options.exact, "only identical pictures that are stored alike pass");
  command.option("--junit", options.junit, "write the outcome as JUnit XML").type("FILE").notEmpty();
  command
      .option("--markdown", options.markdown, "add a table in Markdown to a NAME.md, or to $GITHUB_STEP_SUMMARY")
      .type("FILE")
      .notEmpty();
  command.flag("--json", options.json, "print the outcome as a JSON object, with the figures of diff");
  command.option("--approve-by", options.approveBy, "command that the reports show for approving pictures")
      .type("COMMAND")
      .notEmpty();
  command.option("--report", options.report, "write a page of HTML that shows what changed")
      .type("FILE")
      .notEmpty();
  command
      .option("--outcome", options.outcome,
              "write verdict and reason as a script that an index page of several runs loads")
      .type("FILE")
      .notEmpty();
  command.option("-o,--output", options.output, "folder of new pictures and maps (default: out/golden)")
      .type("FOLDER")
      .notEmpty();
  command.option("-j,--jobs", options.jobs, "pictures at a time (default: one for each CPU)")
      .type("N")
      .range(1, 1024);
  command.option("--backend", options.backend, "OpenGL back end: auto, osmesa or egl")
      .among({"auto", "osmesa", "egl"});
  command.flag("--native", options.native, "draw as fast as this CPU can; pixels may then differ between CPUs");
  command.flag("--force", options.force, "replace reports that poinsot did not write");
  command.flag("--list", options.list, "only list the tests; with --json, with their files");
  command.flag("--unused", options.unused, "make nothing; only list approved pictures that no test makes");
  command.flag("--quiet", options.quiet, "print only the tests that could not be run");
  addAllowance(command, options);
}

}  // namespace poinsot::cli

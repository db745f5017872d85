// SPDX-License-Identifier: Apache-2.0
// Tests tests/consumer/suite, a user's project with poinsot_add_golden_suite(), as its maintainer uses it: the
// output of a failing test, the printed commands, the index page in a browser, JUnit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "package/installed_tree.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

std::string found(const std::string& text, const std::string& pattern) {
  std::smatch match;
  const bool there = std::regex_search(text, match, std::regex(pattern));
  EXPECT_TRUE(there) << pattern << " in\n" << text;
  return there ? match[1].str() : "";
}

class GoldenSuiteProject : public ::testing::Test {
 protected:
  void SetUp() override {
    tree_.run("cp -r " POINSOT_SOURCE_DIR "/tests/consumer/suite project");
    configure();
  }

  void configure() const { run("cmake -G Ninja -S project -B build -DCMAKE_PREFIX_PATH=$PREFIX"); }
  std::string run(const std::string& script) const { return tree_.run("export CI=\n" + script); }
  void approveAll() const {
    run("ctest --test-dir build -R '^plots$'; cmake --build build --target poinsot_golden_update");
  }

  /// Runs ctest. The last line of the result is the exit code.
  std::string ctest(const std::string& words) const {
    return run("ctest --test-dir build -j 2 --output-on-failure " + words + " 2>&1 && echo 0 || echo $?");
  }
  void expectAllPass() const {
    const std::string told = ctest("");
    EXPECT_THAT(told, HasSubstr("100% tests passed"));
  }

  /// Returns the index page as a browser shows it, opened as a file.
  std::string indexPage() const {
    return run(
        "chromium --headless --no-sandbox --disable-gpu --user-data-dir=$PWD/browser --dump-dom "
        "file://$PWD/build/golden/index.html 2>/dev/null");
  }

  InstalledTree tree_;
};

// The maintainer opens the named page and types the printed command.
TEST_F(GoldenSuiteProject, FailuresNameReasonPageAndCommand) {
  const std::string first = ctest("-R viewer.spin_t1.5");
  EXPECT_THAT(first, HasSubstr("new        spin_t1.5: nothing was approved yet\n"));
  EXPECT_TRUE(fs::exists(found(first, "\npage: (.*report.html)\n"))) << first;
  const std::string command = found(first, "approve it: (.*)\n");
  EXPECT_THAT(command, HasSubstr(" --target poinsot_golden_update_viewer.spin_t1.5"));
  run(command);
  EXPECT_THAT(ctest("-R viewer.spin_t1.5"), HasSubstr("100% tests passed"));

  approveAll();
  expectAllPass();
  run("sed -i s/200/180/ project/draw.sh");
  const std::string changed = ctest("");
  EXPECT_THAT(changed, AllOf(HasSubstr("different  plot/wave[1]: largest difference"),
                             HasSubstr("different  plot/wave 2: largest difference"),
                             HasSubstr("different  of <one>; \"odd\" [name: largest difference"),
                             HasSubstr("different  logo: largest difference")));
  EXPECT_THAT(changed, Not(HasSubstr("different  s")));  // the scenes
  // Every printed command works, also for names with brackets and blanks.
  std::string rest = changed;
  const std::regex line("\nif the new .*: (cmake --build .*)\n");
  int commands = 0;
  for (std::smatch match; std::regex_search(rest, match, line); rest = match.suffix(), ++commands) run(match[1]);
  EXPECT_EQ(commands, 3) << changed;  // the pattern, the image, and the single test
  expectAllPass();
}

TEST_F(GoldenSuiteProject, HasOneTestForEachSceneAndPattern) {
  const std::string list = run("ctest --test-dir build -N");
  for (const char* name : {"viewer.scene_spin\n", "viewer.scene_top\n", "viewer.spin_t0\n", "viewer.spin_t1.5\n",
                           "viewer.of <one>; \"odd\" [name\n", "viewer.plots/*.png\n", "viewer.unused\n",
                           "logo.clear\n", "logo.run\n", "logo\n"})
    EXPECT_THAT(list, HasSubstr(std::string(": ") + name));
  EXPECT_THAT(list, HasSubstr("Total Tests: 13"));  // includes plots.clear and plots
  run("cp project/scenes/top.toml project/scenes/book.toml; cmake --build build");
  EXPECT_THAT(run("ctest --test-dir build -N"), HasSubstr(": viewer.scene_book\n"));
}

TEST_F(GoldenSuiteProject, FailsForUnusedReferences) {
  approveAll();
  expectAllPass();
  run("sed -i '/wave 2/d' project/draw.sh; rm project/scenes/top.toml; cmake --build build");
  const std::string told = ctest("-R viewer.unused");
  EXPECT_THAT(told, AllOf(HasSubstr("missing    plot/wave 2: "), HasSubstr("unused     scene_top: ")));
  EXPECT_THAT(told, HasSubstr("project/golden/scene_top.png"));
}

// If all plots are missing, only the tests that compare plots have an error.
TEST_F(GoldenSuiteProject, ReportsMissingImages) {
  approveAll();
  run("echo true >project/draw.sh");
  const std::string told = ctest("-R viewer");
  EXPECT_THAT(told, HasSubstr("/plots/*.png matches no PNG and no film; run the program"));
  EXPECT_THAT(told, HasSubstr("run the program that makes it, or, if the image is gone for good"));
  for (const char* name : {"scene_spin", "scene_top", "spin_t0", "spin_t1.5"})
    EXPECT_THAT(told, Not(HasSubstr(std::string("viewer.") + name + " (Failed)")));
  // If the program fails, the tests of its images do not run; tests of scenes do.
  run("echo false >project/draw.sh");
  EXPECT_THAT(ctest("-R viewer"),
              AllOf(HasSubstr("viewer.plots/*.png (Not Run)"), Not(HasSubstr("viewer.scene_spin (Not Run)"))));
}

TEST_F(GoldenSuiteProject, HasAnIndexPage) {
  EXPECT_THAT(indexPage(), HasSubstr("0 failed, 0 passed, 8 not run"));
  approveAll();
  run("sed -i s/200/180/ project/draw.sh");
  ctest("-R 'viewer|logo$'");
  const std::string page = indexPage();
  EXPECT_THAT(page, HasSubstr("3 failed, 5 passed, 0 not run"));
  const std::string row = found(page,
                                "(<tr[^>]*><td[^>]*>[a-z]*</td><td><a [^>]*>viewer.of &lt;one&gt;; \"odd\" "
                                "\\[name</a></td><td>.*</tr>)");
  EXPECT_THAT(row,
              AllOf(HasSubstr("class=\"failed\""), HasSubstr(">different<"), HasSubstr("largest difference")));
  EXPECT_TRUE(fs::exists(tree_.folder() / "build/golden" / found(row, "href=\"([^\"]*report.html)\""))) << row;
  // The outcome names the page.
  run("sed -i 's/report.html/other page.html/' build/golden/logo/outcome.js");
  EXPECT_THAT(indexPage(), HasSubstr("href=\"logo/other%20page.html\""));
  // If the program crashes, no test compares its pictures, and the index does not show the earlier outcome.
  run("sed -i s/180/200/ project/draw.sh");
  ctest("-R viewer");
  run("sed -i '2i exit 3' project/draw.sh");
  ctest("-R viewer");
  EXPECT_THAT(found(indexPage(), "(<tr[^>]*><td[^>]*>[a-z ]*</td><td>viewer.plots/\\*.png</td>)"),
              HasSubstr(">not run<"));
  run("sed -i 2d project/draw.sh");
  // A run that ends early does not leave the earlier outcome.
  run("echo 'size = 3' >>project/golden.toml; ctest --test-dir build -R scene_top || true");
  EXPECT_THAT(found(indexPage(), "(<tr[^>]*><td[^>]*>error</td><td>viewer.scene_top</td><td>[^<]*)"),
              HasSubstr("golden.toml:"));
}

// Jenkins reads absolute paths, GitLab paths relative to CI_PROJECT_DIR. Each file exists.
TEST_F(GoldenSuiteProject, WritesJUnitWithAttachments) {
  approveAll();
  run("sed -i s/200/180/ project/draw.sh");
  const std::string file = "build/golden/logo/junit.xml";
  ctest("-R logo");
  const std::string absolute = run("cat " + file);
  EXPECT_THAT(absolute, HasSubstr("<failure type=\"different\" message=\"largest difference"));
  EXPECT_THAT(absolute, HasSubstr(">largest difference"));
  EXPECT_THAT(absolute, HasSubstr("\napprove by cmake --build "));
  const std::string picture = found(absolute, "<system-out>\\[\\[ATTACHMENT\\|([^\n]*)\\]\\]\n");
  EXPECT_EQ(picture, (fs::canonical(tree_.folder().path()) / "build/logo/wave.png").string());
  run("export CI_PROJECT_DIR=$PWD; ctest --test-dir build -R logo || true");
  EXPECT_THAT(run("cat " + file), AllOf(HasSubstr("[[ATTACHMENT|build/logo/wave.png]]"),
                                        HasSubstr("[[ATTACHMENT|build/golden/logo/logo.flip.png]]"),
                                        HasSubstr("[[ATTACHMENT|project/approved/logo.png]]")));
}

// Another driver draws the images differently, so it has references beside the usual ones.
TEST_F(GoldenSuiteProject, HasReferencesOfAVariant) {
  const std::string one = "ctest --test-dir build --output-on-failure -R '^viewer.of'";
  const std::string target = found(run(one + " || true"), "--target (\\S*)\n");
  run("cmake --build build --target " + target +
      "; sed -i 's/NAME viewer/& VARIANT softpipe/' project/CMakeLists.txt");
  run("sed -i s/200/180/ project/draw.sh; cmake --build build");
  const std::string told = run(one + " || true");
  EXPECT_THAT(told, HasSubstr("variant 'softpipe': has no approved reference"));
  run(found(told, "to approve the first one, use (.*)\n"));
  EXPECT_THAT(run(one), HasSubstr("100% tests passed"));
  EXPECT_THAT(run("ls project/golden"), HasSubstr("@softpipe.png"));
}

// If the golden.toml names a variant, the targets also keep the references of other variants.
TEST_F(GoldenSuiteProject, KeepsReferencesOfVariantsThatTheManifestNames) {
  approveAll();
  run("sed -i '1a variant = \"mesa\"' project/golden.toml; sed -i s/200/180/ project/draw.sh");
  configure();
  approveAll();
  const std::string list = run("ls project/golden/plot");
  EXPECT_THAT(list, AllOf(HasSubstr("wave 2.png"), HasSubstr("wave 2@mesa.png")));
  expectAllPass();
}

TEST_F(GoldenSuiteProject, NamesReferencesAfterTheBaseline) {
  run("sed -i s/logo.png/logo.v2.png/ project/CMakeLists.txt");
  configure();
  run("cmake --build build --target poinsot_golden_update_logo");
  EXPECT_EQ(run("ls project/approved"), "logo.v2.json\nlogo.v2.png\n");
}

TEST_F(GoldenSuiteProject, RejectsUnknownArguments) {
  run("sed -i 's/NAME viewer/& VARAINT mesa/' project/CMakeLists.txt");
  EXPECT_THAT(run("cmake -S project -B build 2>&1 | tr -s ' \\n' ' ' || true"),
              HasSubstr("poinsot_add_golden_suite: unknown arguments: VARAINT;mesa"));
}

TEST_F(GoldenSuiteProject, FailsToConfigureWithAnInvalidManifest) {
  run("sed -i s/scenes/scnes/ project/golden.toml");
  EXPECT_THAT(run("cmake -S project -B build 2>&1 | tr -s ' \\n' ' ' || true"),
              AllOf(HasSubstr("project/golden.toml:4:1: error: test.scene: no file matches"),
                    HasSubstr("Configuring incomplete")));
}

}  // namespace
}  // namespace poinsot

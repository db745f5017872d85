// SPDX-License-Identifier: Apache-2.0
// tests/consumer/suite, a project of somebody else's with poinsot_add_golden_suite(), as its maintainer uses it:
// what a failing test prints, the commands that it prints, the index page in a browser, JUnit.
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

/// The first group of a pattern; the test fails without it.
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
  /// Draws all, and approves it.
  void approveAll() const {
    run("ctest --test-dir build -R '^plots$'; cmake --build build --target poinsot_golden_update");
  }

  /// What ctest prints; the last line is its exit code.
  std::string ctest(const std::string& words) const {
    return run("ctest --test-dir build -j 2 --output-on-failure " + words + " 2>&1 && echo 0 || echo $?");
  }
  void expectAllPass() const {
    const std::string told = ctest("");
    EXPECT_THAT(told, HasSubstr("100% tests passed"));
  }

  /// The index page as a browser shows it, opened as a file.
  std::string indexPage() const {
    return run(
        "chromium --headless --no-sandbox --disable-gpu --user-data-dir=$PWD/browser --dump-dom "
        "file://$PWD/build/golden/index.html 2>/dev/null");
  }

  InstalledTree tree_;
};

// The maintainer opens the page that is named, and types the command that is named.
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
  // Each command that is printed is one that works, names with brackets and blanks or not.
  std::string rest = changed;
  const std::regex line("\nif the new .*: (cmake --build .*)\n");
  int commands = 0;
  for (std::smatch match; std::regex_search(rest, match, line); rest = match.suffix(), ++commands) run(match[1]);
  EXPECT_EQ(commands, 3) << changed;  // the pattern, the image, the test of its own
  expectAllPass();
}

TEST_F(GoldenSuiteProject, HasOneTestForEachSceneAndPattern) {
  const std::string list = run("ctest --test-dir build -N");
  for (const char* name : {"viewer.scene_spin\n", "viewer.scene_top\n", "viewer.spin_t0\n", "viewer.spin_t1.5\n",
                           "viewer.of <one>; \"odd\" [name\n", "viewer.plots/*.png\n", "viewer.unused\n",
                           "logo.clear\n", "logo.run\n", "logo\n"})
    EXPECT_THAT(list, HasSubstr(std::string(": ") + name));
  EXPECT_THAT(list, HasSubstr("Total Tests: 13"));  // and plots.clear, plots
  // Another scene is another test, after a build.
  run("cp project/scenes/top.toml project/scenes/book.toml; cmake --build build");
  EXPECT_THAT(run("ctest --test-dir build -N"), HasSubstr(": viewer.scene_book\n"));
}

TEST_F(GoldenSuiteProject, FailsForWhatNoTestMakes) {
  approveAll();
  expectAllPass();
  // A plot that is not drawn any more, and a scene that is gone.
  run("sed -i '/wave 2/d' project/draw.sh; rm project/scenes/top.toml; cmake --build build");
  const std::string told = ctest("-R viewer.unused");
  EXPECT_THAT(told, AllOf(HasSubstr("missing    plot/wave 2: "), HasSubstr("unused     scene_top: ")));
  EXPECT_THAT(told, HasSubstr("project/golden/scene_top.png"));
}

// No plot at all is an error of the tests that compare plots, and of no other.
TEST_F(GoldenSuiteProject, SaysThatImagesAreMissing) {
  approveAll();
  run("echo true >project/draw.sh");
  const std::string told = ctest("-R viewer");
  EXPECT_THAT(told, HasSubstr("/plots/*.png matches no PNG and no film; run the program"));
  EXPECT_THAT(told, HasSubstr("run the program that makes it; if it is gone for good"));
  for (const char* name : {"scene_spin", "scene_top", "spin_t0", "spin_t1.5"})
    EXPECT_THAT(told, Not(HasSubstr(std::string("viewer.") + name + " (Failed)")));
  // With a program that fails, its tests do not run; those of scenes do.
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
  // The page is where the outcome says.
  run("sed -i 's/report.html/other page.html/' build/golden/logo/outcome.js");
  EXPECT_THAT(indexPage(), HasSubstr("href=\"logo/other%20page.html\""));
  // Nor does a program that crashes, whose pictures no test gets to compare.
  run("sed -i s/180/200/ project/draw.sh");
  ctest("-R viewer");
  run("sed -i '2i exit 3' project/draw.sh");
  ctest("-R viewer");
  EXPECT_THAT(found(indexPage(), "(<tr[^>]*><td[^>]*>[a-z ]*</td><td>viewer.plots/\\*.png</td>)"),
              HasSubstr(">not run<"));
  run("sed -i 2d project/draw.sh");
  // A run that breaks off does not leave the outcome of the one before.
  run("echo 'size = 3' >>project/golden.toml; ctest --test-dir build -R scene_top || true");
  EXPECT_THAT(found(indexPage(), "(<tr[^>]*><td[^>]*>error</td><td>viewer.scene_top</td><td>[^<]*)"),
              HasSubstr("golden.toml:"));
}

// Jenkins takes absolute paths, GitLab those from CI_PROJECT_DIR; each file is there.
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

// Another driver draws the images in its way: its references stand beside the usual ones.
TEST_F(GoldenSuiteProject, HasReferencesOfAVariant) {
  const std::string one = "ctest --test-dir build --output-on-failure -R '^viewer.of'";
  const std::string target = found(run(one + " || true"), "--target (\\S*)\n");
  run("cmake --build build --target " + target +
      "; sed -i 's/NAME viewer/& VARIANT softpipe/' project/CMakeLists.txt");
  run("sed -i s/200/180/ project/draw.sh; cmake --build build");
  const std::string told = run(one + " || true");
  EXPECT_THAT(told, HasSubstr("variant 'softpipe': no reference was approved for it"));
  run(found(told, "approve the first by (.*)\n"));
  EXPECT_THAT(run(one), HasSubstr("100% tests passed"));
  EXPECT_THAT(run("ls project/golden"), HasSubstr("@softpipe.png"));
}

// With a variant in the golden.toml the targets keep the references of the others, too.
TEST_F(GoldenSuiteProject, KeepsReferencesOfVariantsThatTheManifestNames) {
  approveAll();
  run("sed -i '1a variant = \"mesa\"' project/golden.toml; sed -i s/200/180/ project/draw.sh");
  configure();
  approveAll();
  const std::string list = run("ls project/golden/plot");
  EXPECT_THAT(list, AllOf(HasSubstr("wave 2.png"), HasSubstr("wave 2@mesa.png")));
  expectAllPass();
}

TEST_F(GoldenSuiteProject, CallsReferencesAsTheBaseline) {
  run("sed -i s/logo.png/logo.v2.png/ project/CMakeLists.txt");
  configure();
  run("cmake --build build --target poinsot_golden_update_logo");
  EXPECT_EQ(run("ls project/approved"), "logo.v2.json\nlogo.v2.png\n");
}

TEST_F(GoldenSuiteProject, NamesUnknownArguments) {
  run("sed -i 's/NAME viewer/& VARAINT mesa/' project/CMakeLists.txt");
  EXPECT_THAT(run("cmake -S project -B build 2>&1 | tr -s ' \\n' ' ' || true"),
              HasSubstr("poinsot_add_golden_suite: unknown arguments: VARAINT;mesa"));
}

TEST_F(GoldenSuiteProject, MistakesInTheManifestEndConfiguring) {
  run("sed -i s/scenes/scnes/ project/golden.toml");
  EXPECT_THAT(run("cmake -S project -B build 2>&1 | tr -s ' \\n' ' ' || true"),
              AllOf(HasSubstr("project/golden.toml:4:1: error: test.scene: no file is there of the name"),
                    HasSubstr("Configuring incomplete")));
}

}  // namespace
}  // namespace poinsot

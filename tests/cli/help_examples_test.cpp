// SPDX-License-Identifier: Apache-2.0
// Runs every example in the help of a command as a user pastes it, in a folder with the files that it needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using Lines = std::vector<std::string>;

/// Replacement for an example, with the reason. If `instead` is empty, the example is not run.
struct Exception {
  std::string example, instead, why;
};

const std::vector<Exception> kExceptions{
    {"poinsot golden approve out/golden.html racket",
     "printf '[style]\\ntheme = \"dark\"\\n' >>scenes/tennis_racket.toml; "
     "poinsot golden tests/golden.toml --report out/golden.html; poinsot golden approve out/golden.html racket",
     "a report that has a picture to approve"},
    {"poinsot preview book.toml", "", "a server, which runs until Ctrl-C; preview_server_test runs it"},
    {"poinsot render scenes/football.toml -o - --format png | ffmpeg -f image2pipe -i - ...",
     "poinsot render scenes/football.toml -o - --format png | ffmpeg -v error -f image2pipe -i - -f null -",
     "the dots stand for the options of the reader's film"},
    {"poinsot submit scenes/football.toml -o out/football.mp4 > football.sh && bash football.sh",
     "poinsot submit scenes/football.toml -o out/football.mp4 > football.sh && bash -n football.sh",
     "the script needs a cluster with Slurm; submission_test runs it with stand-ins"}};

/// Runs a line in bash, where `poinsot` is the program under test. CI is empty, because with CI no example could
/// approve a picture.
ShellResult runIn(const ScratchFolder& folder, const std::string& line) {
  return runShell(folder.path(), "set -o pipefail; poinsot() { " POINSOT_PROGRAM " \"$@\"; }\n" + line,
                  {"POINSOT_SCENES=" + (folder / "scenes").string(), "CI="});
}

Lines linesOf(const std::string& text) {
  std::istringstream stream(text);
  Lines lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Lines examplesIn(const std::string& help) {
  Lines examples;
  bool after = false;
  for (const std::string& line : linesOf(help)) {
    after |= line == "Example:" || line == "Examples:";
    if (after && line.starts_with("  poinsot ")) examples.push_back(line.substr(2));
  }
  return examples;
}

/// Returns the names of the subcommands in the help, and "" for the program itself.
Lines commands() {
  const ScratchFolder folder;
  Lines names{""};
  bool among = false;
  for (const std::string& line : linesOf(runIn(folder, "poinsot --help").out)) {
    if (!line.starts_with("  "))
      among = line == "Subcommands:" || line == "SUBCOMMANDS:";  // CLI11 before and since 2.5
    else if (among && line[2] != ' ')
      names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

std::string scene(int frames) {
  return "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 3, 0]\n[time]\nfps = 60\nduration "
         "= " +
         std::to_string(frames / 48.0) + "\n[output]\nsize = [320, 180]\n";
}

/// Writes the files that the examples of a command read. --frames 0-59 and --time 1.25 need 72 frames; at 4k, two
/// frames take long enough.
void prepare(const std::string& command, const ScratchFolder& folder) {
  for (const char* name : {"scenes", "lectures", "out", "tests", "approved", "new"})
    std::filesystem::create_directory(folder / name);
  const int frames = command == "submit" ? 2 : 72;
  for (const char* name : {"scenes/tennis_racket.toml", "scenes/football.toml", "lectures/throw.toml"})
    folder.put(name, scene(frames));
  folder.put("tests/golden.toml",
             "references = \"images\"\n[[test]]\nname = \"racket\"\nscene = \"../scenes/tennis_racket.toml\"\n");
  const std::map<std::string, std::string> commands{
      {"status", "poinsot render scenes/football.toml -o out/film.mp4 --frames 0-5 --quiet"},
      {"diff",
       "poinsot still scenes/football.toml -o approved.png --quiet && cp approved.png new.png && "
       "cp approved.png approved && cp approved.png new && "
       "poinsot render scenes/football.toml -o a.mp4 --frames 0-5 --quiet && cp a.mp4 b.mp4"},
      {"golden", "poinsot golden tests/golden.toml --update"},
      {"grade", "poinsot trajectory scenes/football.toml --rate 100 -o mine.csv"}};
  const auto found = commands.find(command);
  if (found == commands.end()) return;
  const auto made = runIn(folder, found->second);
  EXPECT_EQ(made.exitCode, 0) << found->second << made.out;
}

/// Runs the examples of a command in order, because `assemble` joins the segments of the two examples before it.
void runExamples(const std::string& command) {
  const ScratchFolder folder;
  prepare(command, folder);
  const Lines examples = examplesIn(runIn(folder, "poinsot " + command + " --help").out);
  EXPECT_FALSE(examples.empty()) << command;
  for (const std::string& example : examples) {
    const auto exception = std::ranges::find(kExceptions, example, &Exception::example);
    const std::string line = exception == kExceptions.end() ? example : exception->instead;
    const auto result = runIn(folder, line);
    EXPECT_EQ(result.exitCode, 0) << line << "\n" << result.out;
  }
}

TEST(HelpExamples, RunAsPrinted) {
  const Lines all = commands();
  EXPECT_GE(all.size(), 19u);
  for (const std::string& command : all) runExamples(command);
}

TEST(HelpExamples, ContainEveryExampleThatIsNotRun) {
  const ScratchFolder folder;
  std::set<std::string> all;
  for (const std::string& command : commands())
    for (const std::string& example : examplesIn(runIn(folder, "poinsot " + command + " --help").out))
      all.insert(example);
  EXPECT_GT(all.size(), 30u);
  for (const Exception& exception : kExceptions) EXPECT_TRUE(all.contains(exception.example)) << exception.example;
}

}  // namespace
}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
// Tests every command and option that names an output, as listed in the help. Without --force, nothing that
// poinsot did not write is replaced. No output of a run replaces another output or an input of the run.
#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <memory>
#include <regex>
#include <set>
#include <sstream>

#include "cli/output_commands.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Command = OutputCommand;

/// Beginning of an --outcome file. The file also reports why a run was refused, so it is written if no file is
/// lost by that.
constexpr const char* kTelling = "poinsotOutcome(";

/// Options and operands that name inputs.
const std::set<std::string> kInputs{"--asset-root", "--images", "--mask", "SCENE", "REFERENCE",
                                    "TEST",         "MANIFEST", "OUTPUT", "THEIRS"};
/// Placeholders in the help that do not stand for a file. NAME stands for a file only as the operand of `new`.
const std::set<std::string> kNoFiles{"LINE", "WORDS",   "NAME",      "N",   "NAME=VALUE", "KEY=VALUE", "WxH",
                                     "A-B",  "RATE",    "STYLE",     "T",   "LENGTH",     "k/n",       "TEX",
                                     "M",    "S",       "T1,T2,...", "HZ",  "SIZE",       "0-N",       "ANGLE",
                                     "TEXT", "X,Y,W,H", "NAME1,NAME2,...", "COMMAND",   "INT", "Excludes",   "Print"};

// Scene of two frames; it names a file, because it has its own style.
const char* const kText =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 2, 0.1]\n"
    "[time]\nduration = 0.2\nfps = 10\n[style]\nfile = \"look.toml\"\n[output]\nsize = [64, 36]\n"
    "[show]\nellipsoid = false\nplane = false\nherpolhode = false\npolhode = false\ncontact = false\nlabels = "
    "false\n"
    "L = false\nomega = false\nprincipal_axes = false\n[[timeline]]\nat = 0\ncaption = 'x'\n";

/// Returns other spellings of a file's path, relative to the folder of the run.
std::vector<std::string> spellings(const ScratchFolder& folder, const std::string& file) {
  return {file, "./" + file, (folder / file).string(), "folder/../" + file, "link/" + file};
}

class OutputFiles : public testing::TestWithParam<Command> {
 protected:
  /// Makes two pictures, two films and a mask once for all tests.
  static void SetUpTestSuite() {
    made_ = std::make_unique<ScratchFolder>();
    putScenes(*made_);
    const auto make = [](const Words& words) {
      const RunResult told = poinsot::run(*made_, words);
      ASSERT_EQ(told.exitCode, 0) << told.err;
    };
    make({"still", "s.toml", "-o", "a.png", "--quiet"});
    make({"still", "s.toml", "-o", "b.png", "--quiet", "-D", "show.L=true"});
    make({"render", "s.toml", "-o", "a.gif", "--quiet"});
    make({"render", "s.toml", "-o", "b.gif", "--quiet", "-D", "show.L=true"});
    make({"still", "s.toml", "-o", "mask.png", "--quiet", "--transparent"});
  }
  static void TearDownTestSuite() { made_.reset(); }

  static void putScenes(const ScratchFolder& folder) {
    folder.put("s.toml", kText);
    folder.put("look.toml", "[style]\ntheme = \"dark\"\n");
  }

  void SetUp() override {
    putScenes(folder_);
    for (const char* name : {"folder", "other", "maps", "differences", "new", "pictures", "scenes", "golden"})
      fs::create_directory(folder_ / name);
    fs::create_directory_symlink(".", folder_ / "link");
    for (const char* name : {"a.png", "b.png", "a.gif", "b.gif", "mask.png"})
      fs::copy(*made_ / name, folder_ / name);
    fs::copy(*made_ / "a.png", folder_ / "folder/a.png");
    fs::copy(*made_ / "b.png", folder_ / "other/a.png");
    fs::copy(*made_ / "b.png", folder_ / "golden/s.png");  // differs from the picture that the scene draws
    folder_.put("scenes/football.toml", kText);
    folder_.put("golden.toml", "[[test]]\nname = \"s\"\nscene = \"s.toml\"\n");
    if (command().before.empty()) return;
    ASSERT_EQ(poinsot::run(folder_, command().before).exitCode, 0);
  }

  static const Command& command() { return GetParam(); }

  /// Runs the command with all of its outputs; `others` overrides values of options.
  RunResult run(const std::map<std::string, std::string>& others = {}, bool force = false) const {
    Words words{command().name};
    words.insert(words.end(), command().words.begin(), command().words.end());
    for (const Output& output : command().outputs) {
      if (output.option.empty()) continue;
      if (output.option.starts_with('-')) words.push_back(output.option);
      const auto other = others.find(output.option);
      words.push_back(other == others.end() ? output.value : other->second);
    }
    if (force) words.emplace_back("--force");
    return poinsot::run(folder_, words, Stdout::kFile, {"POINSOT_SCENES=" + (folder_ / "scenes").string(), "CI="});
  }

  /// Returns every file below the folder with its bytes, except outcomes that report why a run was refused.
  std::map<std::string, std::string> files() const {
    std::map<std::string, std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      if (entry.is_regular_file() && !entry.path().filename().string().starts_with(".harness"))
        all[entry.path().lexically_relative(folder_.path())] = bytesOf(entry.path());
    std::erase_if(all, [](const auto& file) { return file.second.starts_with(kTelling); });
    return all;
  }

  void expectClash(const std::map<std::string, std::string>& others, const std::string& where) const {
    const auto before = files();
    const RunResult told = run(others, true);
    EXPECT_EQ(told.exitCode, 2) << where << told.err;
    EXPECT_THAT(told.err, HasSubstr("is the same file as")) << where;
    EXPECT_TRUE(files() == before) << where;
    if (fs::exists(folder_ / "o.js") && bytesOf(folder_ / "o.js").starts_with(kTelling))
      fs::remove(folder_ / "o.js");
  }

  ScratchFolder folder_;

 private:
  static inline std::unique_ptr<ScratchFolder> made_;
};

TEST_P(OutputFiles, AreReplacedOnlyWithForceOrIfWrittenByPoinsot) {
  for (const Output& output : command().outputs) {
    if (output.isAddedTo) continue;
    folder_.put(output.file, "mine\n");
    const auto before = files();
    const RunResult told = run();
    EXPECT_EQ(bytesOf(folder_ / output.file), "mine\n") << output.file;
    EXPECT_EQ(told.exitCode, 4) << output.file << told.err;
    EXPECT_TRUE(files() == before) << "work was done before " << output.file << " was refused";
    EXPECT_THAT(told.err, HasSubstr("--force replaces it")) << output.file;
    fs::remove(folder_ / output.file);
  }
  for (const Output& output : command().outputs) folder_.put(output.file, "mine\n");
  for (const bool force : {true, false}) {
    if (!force)  // the program cannot recognise these outputs as its own, so they must be new
      for (const Output& output : command().outputs)
        if (!output.isKnown) fs::remove(folder_ / output.file);
    const RunResult told = run({}, force);
    EXPECT_EQ(told.exitCode, command().exitCode) << told.err;
    for (const Output& output : command().outputs) {
      if (command().name == "submit") continue;  // submit prints a script
      EXPECT_TRUE(fs::exists(folder_ / output.file)) << output.file;
      EXPECT_EQ(bytesOf(folder_ / output.file).starts_with("mine\n"), output.isAddedTo) << output.file;
    }
  }
}

TEST_P(OutputFiles, MustNotBeInputsOfTheRun) {
  std::size_t turn = 0;
  for (const Output& output : command().outputs)
    for (const std::string& input : command().inputs) {
      const std::string where = output.file + " is " + input;
      fs::create_hard_link(folder_ / input, folder_ / output.file);
      expectClash({}, where + ", linked; ");
      fs::remove(folder_ / output.file);
      if (!output.isAnyName) continue;
      const auto ways = spellings(folder_, input);
      expectClash({{output.option, ways[turn++ % ways.size()]}}, where + "; ");
    }
}

TEST_P(OutputFiles, MustNotBeTheSameAsAnotherOutput) {
  std::size_t turn = 0;
  const std::vector<Output>& outputs = command().outputs;
  for (std::size_t i = 0; i < outputs.size(); ++i)
    for (std::size_t j = i + 1; j < outputs.size(); ++j) {
      const std::string where = outputs[i].file + " and " + outputs[j].file;
      folder_.put(outputs[i].file, "mine\n");
      fs::create_hard_link(folder_ / outputs[i].file, folder_ / outputs[j].file);
      expectClash({}, where + ", linked; ");
      fs::remove(folder_ / outputs[i].file);
      fs::remove(folder_ / outputs[j].file);
      const Output& any = outputs[j].isAnyName ? outputs[j] : outputs[i];
      const Output& other = outputs[j].isAnyName ? outputs[i] : outputs[j];
      if (!any.isAnyName) continue;
      const auto ways = spellings(folder_, other.file);
      expectClash({{any.option, ways[turn++ % ways.size()]}}, where + "; ");
    }
}

INSTANTIATE_TEST_SUITE_P(Each, OutputFiles, testing::ValuesIn(outputCommands()),
                         [](const auto& one) { return one.param.name + one.param.unlike; });

struct Word {
  std::string name, type;
};

std::string helpOf(const std::string& command) {
  const ScratchFolder folder;
  Words words{command, "--help"};
  if (command.empty()) words.erase(words.begin());
  return run(folder, words).out;
}

/// Removes the columns of options. CLI11 writes "  -o,--output FILE", and since 2.5 "  -o,     --output FILE" and
/// "          --output FILE".
std::string withoutColumns(const std::string& line) {
  static const std::regex columns("^  (?:(-.,) +|        )--");
  return std::regex_replace(line, columns, "  $1--");
}

/// Returns the words of lines such as "  -o,--output FILE  what it is" and "  SCENE TEXT REQUIRED  what it is".
std::vector<Word> wordsOf(const std::string& help) {
  std::vector<Word> words;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    line = withoutColumns(line);
    if (!line.starts_with("  ") || line.size() < 3 || line[2] == ' ') continue;
    std::istringstream parts(line.substr(2));
    Word word;
    parts >> word.name >> word.type;
    word.type = word.type.substr(0, word.type.find(':'));
    const auto comma = word.name.find(',');
    if (word.name.starts_with('-') && comma != std::string::npos) word.name = word.name.substr(comma + 1);
    const bool isOperand = word.type == "TEXT";
    const bool takesValue = word.name.starts_with('-') && !word.type.empty() && std::isupper(word.type[0]);
    if (isOperand || takesValue) words.push_back(word);
  }
  return words;
}

std::set<std::string> commandNames() {
  std::set<std::string> names;
  std::istringstream lines(helpOf(""));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  ") && line.size() > 2 && std::islower(line[2]))
      names.insert(line.substr(2, line.find(' ', 2) - 2));
  names.erase("poinsot");  // first word of an example
  return names;
}

// A new option that names a file must be listed as an output (output_commands.cpp) or as an input (above).
TEST(OutputFilesInTheHelp, AreAllTested) {
  std::set<std::pair<std::string, std::string>> tried, found;
  for (const Command& command : outputCommands())
    for (const Output& output : command.outputs)
      if (!output.option.empty()) tried.insert({command.name, output.option});
  for (const std::string& command : commandNames())
    for (const Word& word : wordsOf(helpOf(command))) {
      const bool isOperand = !word.name.starts_with("-");
      const bool isFile = isOperand || word.type == "FILE" || word.type == "FOLDER" || word.type == "SCENE";
      if (tried.contains({command, word.name}))
        found.insert({command, word.name});
      else if (isFile)
        EXPECT_TRUE(kInputs.contains(word.name) ||
                    ((command == "explain" || command == "golden") && word.name == "NAME") ||
                    (command == "new" && word.name == "--from"))
            << command << ' ' << word.name;
      else
        EXPECT_TRUE(kNoFiles.contains(word.type)) << command << ' ' << word.name << ' ' << word.type;
    }
  EXPECT_EQ(found, tried);
}

}  // namespace
}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
// Asks each shell for its completions at the end of a line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/shell_word.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;
using ::testing::Not;

using Words = std::vector<std::string>;

class Completion : public ::testing::Test {
 protected:
  void SetUp() override {
    run(POINSOT_PROGRAM " self-describe share && touch top.toml mine.csv 'my top.toml' notes.txt && mkdir more");
  }

  std::string run(const std::string& script) const {
    const auto result = runShell(folder_.path(), script, {"HOME=" + folder_.path().string(), "TERM=dumb"});
    EXPECT_EQ(result.exitCode, 0) << script << "\n" << result.out;
    return result.out;
  }

  static Words linesOf(const std::string& text) {
    Words lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    std::ranges::sort(lines);
    lines.erase(std::unique(lines.begin(), lines.end()), lines.end());  // Clang 14 lacks std::ranges::unique
    return lines;
  }

  ScratchFolder folder_;
};

class BashCompletion : public Completion {
 protected:
  /// @param words  the line as bash splits it, at spaces and at =; the last word is being typed
  Words offered(const Words& words) const {
    return linesOf(
        run("source share/bash-completion/completions/poinsot\n"
            "compopt() { :; }\n"  // outside of a completion, compopt only prints an error
            "COMP_WORDS=(poinsot " +
            core::shellWords(words) + ") COMP_CWORD=" + std::to_string(words.size()) +
            "\n_poinsot\nprintf '%s\\n' \"${COMPREPLY[@]}\""));
  }
};

TEST_F(BashCompletion, CompletesCommands) {
  EXPECT_THAT(offered({"re"}), ElementsAre("render"));
  EXPECT_THAT(offered({"s"}), ElementsAre("schema", "status", "still", "submit", "sweep"));
  EXPECT_THAT(offered({""}), AllOf(IsSupersetOf({"help", "gallery", "--version"}), Not(Contains("worker"))));
  EXPECT_THAT(offered({"help", "gr"}), ElementsAre("grade"));
  EXPECT_THAT(run("source share/bash-completion/completions/poinsot; complete -p poinsot"),
              ::testing::StartsWith("complete -F _poinsot"));
}

TEST_F(BashCompletion, CompletesOptionsOfTheCommand) {
  EXPECT_THAT(offered({"render", "top.toml", "--f"}), ElementsAre("--force", "--format", "--fps", "--frames"));
  EXPECT_THAT(offered({"info", "--"}),
              ElementsAre("--all", "--alt", "--asset-root", "--digits", "--help", "--json", "--limit",
                          "--max-memory", "--max-seconds", "--untrusted"));
}

TEST_F(BashCompletion, CompletesValuesOfAnOption) {
  EXPECT_THAT(offered({"render", "--backend", "o"}), ElementsAre("osmesa"));
  EXPECT_THAT(offered({"render", "--backend", "=", "e"}), ElementsAre("egl"));
  EXPECT_THAT(offered({"still", "-q", ""}), ElementsAre("1080p", "4k", "720p", "preview"));
  EXPECT_THAT(offered({"render", "--fps", ""}), ElementsAre(""));
}

TEST_F(BashCompletion, CompletesKeysOfAScene) {
  EXPECT_THAT(offered({"render", "top.toml", "-D", "style.th"}), ElementsAre("style.theme="));
  EXPECT_THAT(offered({"render", "top.toml", "-D", "style.theme", "=", "d"}), ElementsAre("dark"));
  EXPECT_THAT(offered({"check", "-D", "time.loop", "="}), ElementsAre("false", "true"));
  EXPECT_THAT(offered({"render", "top.toml", "-D", "style.theme", "=", "dark", "mo"}), ElementsAre("more"));
}

TEST_F(BashCompletion, CompletesFilesOfTheRightKind) {
  EXPECT_THAT(offered({"render", ""}), ElementsAre("more", "my top.toml", "share", "top.toml"));
  EXPECT_THAT(offered({"grade", "top.toml", "m"}), ElementsAre("mine.csv", "more", "my top.toml"));
  EXPECT_THAT(offered({"render", "-o", "n"}), ElementsAre("notes.txt"));
  EXPECT_THAT(offered({"gallery", "-o", ""}), ElementsAre("more", "share"));
}

// Uses readline, which has its own rules for quotes and spaces. Zsh provides the terminal for bash.
TEST_F(BashCompletion, WorksAtATerminal) {
  folder_.put(
      "ask.zsh",
      "zmodload zsh/zpty; zpty b 'env PS1= TERM=dumb bash --norc --noprofile -i'\n"
      "zpty -w b \"source share/bash-completion/completions/poinsot; poinsot() { printf '<%s>' \\\"\\$@\\\"; }\"\n"
      "zpty -w b $'poinsot rend\\tmy\\t -D style.th\\tda\\t --backend o\\t'\n"
      "zpty -r b seen '*<render><my top.toml><-D><style.theme=dark><--backend><osmesa>*' || exit 1\n");
  run("timeout 30 zsh -f ask.zsh");
}

class FishCompletion : public Completion {
 protected:
  Words offered(const std::string& line) const {
    return linesOf(run("fish --no-config -c 'source share/fish/vendor_completions.d/poinsot.fish; complete -C \"" +
                       line + "\"' | cut -f1"));
  }
};

// There is one test, because each start of fish takes half a second.
TEST_F(FishCompletion, CompletesCommandsOptionsValuesKeysAndFiles) {
  run("fish -n share/fish/vendor_completions.d/poinsot.fish");
  EXPECT_THAT(offered("poinsot re"), ElementsAre("render"));
  EXPECT_THAT(offered("poinsot "), AllOf(IsSupersetOf({"help", "gallery"}), Not(Contains("worker"))));
  EXPECT_THAT(offered("poinsot render top.toml --fram"), ElementsAre("--frames"));
  EXPECT_THAT(offered("poinsot render top.toml --backend "), ElementsAre("auto", "egl", "osmesa"));
  EXPECT_THAT(offered("poinsot render -D style.theme="),
              ElementsAre("style.theme=", "style.theme=dark", "style.theme=light", "style.theme=print"));
  EXPECT_THAT(offered("poinsot render t"), ElementsAre("top.toml"));
}

class ZshCompletion : public Completion {
 protected:
  /// Returns zsh commands that type `line` and two tabs at a terminal and wait for the words, in this order.
  std::string ask(const std::string& line, const Words& words) const {
    std::string pattern = "*";
    for (const std::string& word : words) pattern += word + "*";
    return "zpty -w -n z $'" + line + "\\t\\t'; zpty -r z seen '" + pattern +
           "' || exit 1; zpty -w -n z $'\\x15'\n";
  }
};

// Zsh completes only at a terminal, so the test provides one.
TEST_F(ZshCompletion, CompletesCommandsOptionsValuesKeysAndFiles) {
  run("zsh -n share/zsh/vendor-completions/_poinsot");
  folder_.put("ask.zsh",
              "zmodload zsh/zpty; zpty z 'zsh -f -i'\n"
              "zpty -w z 'unsetopt prompt_sp; PS1=; autoload -U compinit; compinit -u -D;"
              " source share/zsh/vendor-completions/_poinsot; echo REA''DY'\n"
              "zpty -r z seen '*READY*' || exit 1\n" +
                  ask("poinsot s", {"schema", "status", "still", "submit", "sweep"}) +
                  ask("poinsot still --backend ", {"auto", "egl", "osmesa"}) +
                  ask("poinsot render top.toml -D style.theme=", {"dark", "light", "print"}) +
                  ask("poinsot render top.toml --f", {"force", "format", "fps", "frames"}) +
                  ask("poinsot grade top.toml m", {"mine.csv", "more"}));
  run("timeout 30 zsh -f ask.zsh");
}

}  // namespace
}  // namespace poinsot

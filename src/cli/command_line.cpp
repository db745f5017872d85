// SPDX-License-Identifier: Apache-2.0
#include "cli/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string_view>

#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::cli {
namespace {

constexpr std::string_view kExamples =
    "Examples:\n"
    "  poinsot render scenes/tennis_racket.toml -o out/tennis_racket.mp4\n"
    "  poinsot still scenes/tennis_racket.toml --time 1.25 -o out/fig.png\n"
    "  poinsot help render\n"
    "Exit codes: ";

struct Entry {
  std::string_view name;
  void (*add)(const Command& program);
};

constexpr std::array kCommands{
    Entry{"new", addNew},
    Entry{"preview", addPreview},
    Entry{"render", addRender},
    Entry{"still", addStill},
    Entry{"sweep", addSweep},
    Entry{"gallery", addGallery},
    Entry{"status", addStatus},
    Entry{"assemble", addAssemble},
    Entry{"submit", addSubmit},
    Entry{"diff", addDiff},
    Entry{"golden", addGolden},
    Entry{"info", addInfo},
    Entry{"trajectory", addTrajectory},
    Entry{"grade", addGrade},
    Entry{"check", addCheck},
    Entry{"explain", addExplain},
    Entry{"schema", addSchema},
    Entry{"doctor", addDoctor},
    Entry{"self-describe", addSelfDescribe},
};

/// Turns off the paragraph formatting of newer versions of CLI11, which would join the lines of examples.
template <class Formatter>
void keepLines(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); }) {
    formatter.enable_description_formatting(false);
    formatter.enable_footer_formatting(false);
  }
}

/// Declares the command `word`, because parsing needs no other. If there is no such command, declares all, for the
/// help and for suggestions. The hidden command self-describe needs all commands, too, because it describes them.
void declare(CLI::App& program, std::string_view word, Action& chosen) {
  keepLines(*program.get_formatter());
  program.description("Films and stills of rotating rigid bodies, from scene files.");
  program.set_version_flag("--version", versionText, "versions of the program and its libraries");
  program.footer(std::string(kExamples) + kExitCodesText);
  program.require_subcommand(1);
  const Command command(program, chosen);
  const auto named = std::ranges::find(kCommands, word, &Entry::name);
  if (named != kCommands.end() && named->add != addSelfDescribe) return named->add(command);
  for (const Entry& entry : kCommands) entry.add(command);
}

std::vector<std::string> commandNames(const CLI::App& program) {
  std::vector<std::string> names{"help"};
  for (const CLI::App* command :
       program.get_subcommands([](const CLI::App* c) { return !c->get_group().empty(); }))
    names.push_back(command->get_name());
  return names;
}

bool isCommand(const CLI::App& program, const std::string& word) {
  const auto named = [&](const CLI::App* command) { return command->get_name() == word; };
  return !program.get_subcommands(named).empty();
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  const auto near = core::closest(word, candidates);
  return near ? fmt::format("; did you mean '{}'?", *near) : "";
}

/// Converts "help" to "--help", and "help render" to "render --help".
std::vector<std::string> withoutHelpWord(std::vector<std::string> words) {
  if (words.empty()) return {"--help"};
  if (words[0] != "help") return words;
  words.erase(words.begin());
  if (words.size() > 1) throw core::usageError("help takes one command");
  words.push_back("--help");
  return words;
}

void checkCommandWord(const CLI::App& program, const std::string& word) {
  if (word.starts_with('-') || isCommand(program, word)) return;
  throw core::usageError(fmt::format("unknown command '{}'{} (poinsot --help lists the commands)",
                                     core::printable(word), didYouMean(word, commandNames(program))));
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

[[noreturn]] void refuseExtra(const CLI::App& program) {
  const auto used = program.get_subcommands();
  const CLI::App& command = used.empty() ? program : *used.front();
  const auto extra = program.remaining(true);
  const std::string word = extra.empty() ? "" : extra.front();
  const std::string help = used.empty() ? "poinsot --help" : fmt::format("poinsot {} --help", command.get_name());
  throw core::usageError(fmt::format("unexpected '{}'{} ({} lists what works)", core::printable(word),
                                     didYouMean(word.substr(0, word.find('=')), optionNames(command)), help));
}

/// Converts a message of CLI11, such as "--size: 1 required WxH missing", to a clearer one.
std::string withoutValue(const std::string& text) {
  constexpr std::string_view kOne = ": 1 required ", kMissing = " missing";
  const std::size_t at = text.find(kOne);
  if (at == std::string::npos || !text.ends_with(kMissing)) return text;
  const std::size_t begin = at + kOne.size();
  return fmt::format("{}: the value is missing; expected {}", text.substr(0, at),
                     text.substr(begin, text.size() - kMissing.size() - begin));
}

void parse(CLI::App& program, std::vector<std::string> words) {
  checkCommandWord(program, words.front());
  std::reverse(words.begin(), words.end());  // CLI11 expects the words in reverse order
  try {
    program.parse(std::move(words));
  } catch (const CLI::ExtrasError&) {
    refuseExtra(program);
  } catch (const CLI::Success&) {
    throw;  // CLI11 throws for --help and --version, too
  } catch (const CLI::ArgumentMismatch& error) {
    throw core::usageError(core::printable(withoutValue(error.what())));
  } catch (const CLI::ParseError& error) {
    throw core::usageError(core::printable(error.what()));
  }
}

int print(const std::string& text) {
  writeOut(text);
  return kDone;
}

}  // namespace

CommandLine::CommandLine(std::vector<std::string> words) : program_(std::make_unique<CLI::App>("", "poinsot")) {
  try {
    words = withoutHelpWord(std::move(words));
    declare(*program_, words.front(), chosen_);
    parse(*program_, std::move(words));
  } catch (const CLI::CallForVersion& version) {
    chosen_.run = [text = std::string(version.what())] { return print(text); };
  } catch (const CLI::Success&) {
    chosen_.run = [this] { return print(program_->help()); };
  }
}

CommandLine::~CommandLine() = default;

int CommandLine::run() const {
  return chosen_.allowance ? confined(*chosen_.allowance, chosen_.access, chosen_.run) : chosen_.run();
}

}  // namespace poinsot::cli

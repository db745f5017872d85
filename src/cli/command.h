// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cli/untrusted.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

/// How a command is declared. CLI11 parses the command line; it takes seconds to compile, so that the commands do
/// not see it.
namespace poinsot::cli {

/// The work of the command that is on the command line.
struct Action {
  std::function<int()> run = {};                ///< returns the exit code
  const AllowanceOptions* allowance = nullptr;  ///< of a command that has --untrusted
  std::function<FileAccess()> access = {};      ///< the files it touches, for the sandbox of --untrusted
};

/// An option, a flag or an operand that was declared, to say more of it. Each function returns the same one.
class Option {
 public:
  explicit Option(CLI::Option& declared) : declared_(&declared) {}

  /// The name of its value in the help, such as FILE.
  Option type(const std::string& name) const;
  Option help(const std::string& text) const;
  /// The help lists it under this title.
  Option group(const std::string& title) const;
  Option showDefault() const;
  Option required() const;
  /// Refuses '' as a value, most often a shell variable without one, which would else count as not given. `words`
  /// are the values there are, for the help; what reads the value refuses others.
  Option notEmpty(const std::vector<std::string>& words = {}) const;
  /// Refuses other values than these.
  Option among(const std::vector<std::string>& words) const;
  Option amongNumbers(const std::vector<int>& numbers) const;
  /// Refuses numbers below `least` and above `most`. Number is int, std::int64_t or double.
  template <class Number>
  Option range(Number least, Number most) const;
  /// May be given again; each takes one value.
  Option repeats() const;
  Option excludes(const Option& other) const;

 private:
  CLI::Option* declared_;
};

/// A command of the program, or the program itself, to declare its options. Valid as long as the CommandLine.
class Command {
 public:
  Command(CLI::App& parser, Action& chosen) : parser_(&parser), chosen_(&chosen) {}

  /// A command of this one.
  Command command(const std::string& name, const std::string& summary) const;
  /// An option, where `names` are such as "-o,--output", or else an operand. Value is std::string, int,
  /// std::int64_t, double, std::vector<std::string>, or std::optional of std::string, int or double; another type
  /// needs a line in command.cpp.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help) const;
  /// "!--no-sheet" sets `value` to false.
  Option flag(const std::string& names, bool& value, const std::string& help) const;
  /// One that was declared. @param name  such as "--output"
  Option declared(const std::string& name) const;
  void remove(const std::string& name) const;
  /// The end of the help.
  void footer(const std::string& text) const;
  /// Keeps it out of the list of commands.
  void hide() const;
  /// Sets its work. Parsing does none of it.
  void does(Action action) const;

  const CLI::App& parser() const { return *parser_; }

 private:
  CLI::App* parser_;
  Action* chosen_;
};

}  // namespace poinsot::cli

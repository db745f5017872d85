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

/// Interface for declaring commands. It keeps CLI11, which takes seconds to compile, out of the commands' sources.
namespace poinsot::cli {

/// Work of the command that the user typed.
struct Action {
  std::function<int()> run = {};                ///< returns the exit code
  const AllowanceOptions* allowance = nullptr;  ///< null for a command without --untrusted
  std::function<FileAccess()> access = {};      ///< returns the files that the sandbox of --untrusted must allow
};

/// Option, flag or operand that was declared. Each function sets a property and returns the same option.
class Option {
 public:
  explicit Option(CLI::Option& declared) : declared_(&declared) {}

  /// Sets the name of the value in the help, such as FILE.
  Option type(const std::string& name) const;
  Option help(const std::string& text) const;
  /// Lists the option under this title in the help.
  Option group(const std::string& title) const;
  Option showDefault() const;
  Option required() const;
  /// Rejects '' as a value, which is usually an unset shell variable and would count as a missing option.
  /// @param words  values for the help; the code that reads the value rejects others
  Option notEmpty(const std::vector<std::string>& words = {}) const;
  Option among(const std::vector<std::string>& words) const;
  Option amongNumbers(const std::vector<int>& numbers) const;
  /// Rejects numbers below `least` and above `most`. Number is int, std::int64_t or double.
  template <class Number>
  Option range(Number least, Number most) const;
  /// Allows the option several times, each with one value.
  Option repeats() const;
  Option excludes(const Option& other) const;

 private:
  CLI::Option* declared_;
};

/// A command of the program, or the program itself, for declaring its options. Valid as long as the CommandLine.
class Command {
 public:
  Command(CLI::App& parser, Action& chosen) : parser_(&parser), chosen_(&chosen) {}

  Command command(const std::string& name, const std::string& summary) const;
  /// Declares an option if `names` is like "-o,--output", otherwise an operand. Value is std::string, int,
  /// std::int64_t, double, std::vector<std::string>, or std::optional of std::string, int or double; another type
  /// needs a line in command.cpp.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help) const;
  /// Declares a flag. A name like "!--no-sheet" sets `value` to false.
  Option flag(const std::string& names, bool& value, const std::string& help) const;
  /// Returns an option that was declared. @param name  such as "--output"
  Option declared(const std::string& name) const;
  void remove(const std::string& name) const;
  /// Sets the text at the end of the help.
  void footer(const std::string& text) const;
  /// Removes the command from the list of commands in the help.
  void hide() const;
  /// Sets the work of the command, which CommandLine::run() starts.
  void does(Action action) const;

  const CLI::App& parser() const { return *parser_; }

 private:
  CLI::App* parser_;
  Action* chosen_;
};

}  // namespace poinsot::cli

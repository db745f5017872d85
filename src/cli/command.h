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

/// Interface for declaring commands. It hides the parser CLI11 from the sources of the commands, because CLI11
/// takes seconds to compile.
namespace poinsot::cli {

/// Function to run for the command that the user typed.
struct Action {
  std::function<int()> run = {};                ///< returns the exit code
  const AllowanceOptions* allowance = nullptr;  ///< null if the command has no option --untrusted
  std::function<FileAccess()> access = {};      ///< returns the files that the command may access with --untrusted
};

/// Declared option, flag or operand. Each setter returns the same option, so that calls can be chained.
class Option {
 public:
  explicit Option(CLI::Option& declared) : declared_(&declared) {}

  /// Sets the name of the value in the help, such as FILE.
  Option type(const std::string& name) const;
  Option help(const std::string& text) const;
  /// Sets the title under which the help lists the option.
  Option group(const std::string& title) const;
  Option showDefault() const;
  Option required() const;
  /// Rejects '' as a value. An empty value usually comes from an unset shell variable, and would count as a
  /// missing option.
  /// @param words  allowed values, listed in the help; the code that reads the value must reject others
  Option notEmpty(const std::vector<std::string>& words = {}) const;
  Option among(const std::vector<std::string>& words) const;
  Option amongNumbers(const std::vector<int>& numbers) const;
  /// Rejects numbers below `least` and above `most`. Number is int, std::int64_t or double.
  template <class Number>
  Option range(Number least, Number most) const;
  /// Allows the user to give the option several times, each with one value.
  Option repeats() const;
  Option excludes(const Option& other) const;

 private:
  CLI::Option* declared_;
};

/// Declaration of a command or of the program, with its options. Valid during the lifetime of the CommandLine.
class Command {
 public:
  Command(CLI::App& parser, Action& chosen) : parser_(&parser), chosen_(&chosen) {}

  Command command(const std::string& name, const std::string& summary) const;
  /// Declares an option if `names` is like "-o,--output", otherwise an operand. Value can be std::string, int,
  /// std::int64_t, double or std::vector<std::string>, or std::optional of std::string, int or double. Another
  /// type needs a line in command.cpp.
  template <class Value>
  Option option(const std::string& names, Value& value, const std::string& help) const;
  /// Declares a flag. A name like "!--no-sheet" sets `value` to false.
  Option flag(const std::string& names, bool& value, const std::string& help) const;
  /// Returns the declared option of this name. @param name  for example "--output"
  Option declared(const std::string& name) const;
  void remove(const std::string& name) const;
  /// Sets the text at the end of the help.
  void footer(const std::string& text) const;
  /// Hides the command from the list of commands in the help.
  void hide() const;
  /// Sets the function that runs the command. CommandLine::run() calls it.
  void does(Action action) const;

  const CLI::App& parser() const { return *parser_; }

 private:
  CLI::App* parser_;
  Action* chosen_;
};

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "cli/command.h"

#include <CLI/CLI.hpp>
#include <cstdint>
#include <optional>
#include <utility>

namespace poinsot::cli {

Option Option::type(const std::string& name) const { return Option(*declared_->type_name(name)); }

Option Option::help(const std::string& text) const { return Option(*declared_->description(text)); }

Option Option::group(const std::string& title) const { return Option(*declared_->group(title)); }

Option Option::showDefault() const { return Option(*declared_->capture_default_str()); }

Option Option::required() const { return Option(*declared_->required()); }

Option Option::notEmpty(const std::vector<std::string>& words) const {
  return Option(*declared_->check({[](std::string& word) -> std::string { return word.empty() ? "is empty" : ""; },
                                   words.empty() ? "" : CLI::detail::generate_set(words), ""}));
}

Option Option::among(const std::vector<std::string>& words) const {
  return Option(*declared_->check(CLI::IsMember(words)));
}

Option Option::amongNumbers(const std::vector<int>& numbers) const {
  return Option(*declared_->check(CLI::IsMember(numbers)));
}

template <class Number>
Option Option::range(Number least, Number most) const {
  return Option(*declared_->check(CLI::Range(least, most)));
}

template Option Option::range(int, int) const;
template Option Option::range(std::int64_t, std::int64_t) const;
template Option Option::range(double, double) const;

Option Option::repeats() const {
  return Option(
      *declared_->expected(1)->allow_extra_args(false)->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

Option Option::excludes(const Option& other) const { return Option(*declared_->excludes(other.declared_)); }

Command Command::command(const std::string& name, const std::string& summary) const {
  return {*parser_->add_subcommand(name, summary), *chosen_};
}

template <class Value>
Option Command::option(const std::string& names, Value& value, const std::string& help) const {
  return Option(*parser_->add_option(names, value, help));
}

template Option Command::option(const std::string&, std::string&, const std::string&) const;
template Option Command::option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option Command::option(const std::string&, int&, const std::string&) const;
template Option Command::option(const std::string&, std::int64_t&, const std::string&) const;
template Option Command::option(const std::string&, double&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<std::string>&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<double>&, const std::string&) const;

Option Command::flag(const std::string& names, bool& value, const std::string& help) const {
  return Option(*parser_->add_flag(names, value, help));
}

Option Command::declared(const std::string& name) const { return Option(*parser_->get_option(name)); }

void Command::remove(const std::string& name) const { parser_->remove_option(parser_->get_option(name)); }

void Command::footer(const std::string& text) const { parser_->footer(text); }

void Command::hide() const { parser_->group(""); }

void Command::does(Action action) const {
  parser_->callback([chosen = chosen_, action = std::move(action)] { *chosen = action; });
}

}  // namespace poinsot::cli

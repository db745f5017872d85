// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <span>
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace poinsot::describe {

/// Sets the language in which say() writes, on this thread, until the scope ends.
class LanguageScope {
 public:
  explicit LanguageScope(scene::Language language);
  ~LanguageScope();
  LanguageScope(const LanguageScope&) = delete;

 private:
  scene::Language before_;
};

/// English text of a description, and its translation. Both have the same replacement fields "{}".
struct Translation {
  std::string_view english, german;
};
std::span<const Translation> translations();

/// Returns an English text in the language of the scope.
/// @pre translations() contains the text, if the language is not English.
std::string_view translated(std::string_view english);

/// Returns whether numbers have a decimal comma in the language of the scope.
bool hasDecimalComma();

/// Returns a text in the language of the scope, with its replacement fields filled in as by fmt::format().
template <class... Values>
std::string say(std::string_view english, const Values&... values) {
  return fmt::format(fmt::runtime(translated(english)), values...);
}

}  // namespace poinsot::describe

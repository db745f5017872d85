// SPDX-License-Identifier: Apache-2.0
#include "stage/figures/point_name.h"

#include <algorithm>

namespace poinsot::stage {
namespace {

// Commands that change how letters look, and spaces. Names leave them out.
constexpr std::string_view kLooks[] = {"mathbf", "boldsymbol", "mathrm", "mathit", "text",  "textbf", "hat",
                                       "dot",    "ddot",       "bar",    "vec",    "tilde", "frac",   "dfrac",
                                       "sqrt",   "quad",       "qquad",  "begin",  "end",   "bmatrix"};

bool isAsciiLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isAsciiDigit(char c) { return c >= '0' && c <= '9'; }

/// Takes the command after a backslash from the front of `tex`. Returns its part of the name.
std::string_view takeCommand(std::string_view& tex) {
  const auto end = static_cast<std::size_t>(std::ranges::find_if_not(tex, isAsciiLetter) - tex.begin());
  const std::string_view command = tex.substr(0, end);
  tex.remove_prefix(std::max<std::size_t>(end, tex.empty() ? 0 : 1));
  return std::ranges::find(kLooks, command) == std::end(kLooks) ? command : std::string_view();
}

}  // namespace

std::string pointName(std::string_view tex) {
  std::string name;
  bool gap = false;
  const auto append = [&](std::string_view part) {
    if (part.empty()) return;
    if (gap && !name.empty()) name += '-';
    gap = false;
    name += part;
  };
  while (!tex.empty()) {
    const char c = tex.front();
    const std::string_view one = tex.substr(0, 1);
    tex.remove_prefix(1);
    if (c == '\\')
      append(takeCommand(tex));
    else if (isAsciiLetter(c) || isAsciiDigit(c))
      append(one);
    else
      gap = gap || c == ' ' || c == '-' || c == '~';
  }
  if (name.empty()) return "vector";
  return isAsciiDigit(name.front()) ? "v" + name : name;
}

}  // namespace poinsot::stage

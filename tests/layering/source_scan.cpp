// SPDX-License-Identifier: Apache-2.0
#include "layering/source_scan.h"

#include <algorithm>
#include <regex>
#include <sstream>

namespace poinsot::layering {
namespace {

// Removes comments but keeps line ends, so that line numbers stay true.
std::string withoutComments(std::string_view source) {
  std::string code;
  enum { kCode, kLine, kBlock } in = kCode;
  for (std::size_t i = 0; i < source.size(); ++i) {
    const std::string_view two = source.substr(i, 2);
    if (in == kCode && two == "//") in = kLine;
    if (in == kCode && two == "/*") {
      in = kBlock;
      ++i;
      continue;
    }
    if (in == kLine && source[i] == '\n') in = kCode;
    if (in == kBlock && two == "*/") {
      in = kCode;
      ++i;
      continue;
    }
    if (in == kCode || source[i] == '\n') code += source[i];
  }
  return code;
}

}  // namespace

std::vector<Mention> includesOf(std::string_view source) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*(?:"([^"]+)\"|<([^>]+)>|(\w+)))");
  std::istringstream lines(withoutComments(source));
  std::vector<Mention> found;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (!std::regex_search(line, match, kInclude)) continue;
    const bool quoted = match[1].matched;
    found.push_back({number, quoted ? match[1] : match[2].matched ? match[2] : match[3], quoted});
  }
  return found;
}

std::vector<Mention> layersLinkedIn(std::string_view cmake, const std::vector<std::string>& layers) {
  static const std::regex kTarget(R"(\bpoinsot(?:::|_)(\w+))");
  std::istringstream lines{std::string(cmake)};
  std::vector<Mention> found;
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line.erase(std::min(line.find('#'), line.size()));
    for (std::sregex_iterator match(line.begin(), line.end(), kTarget), end; match != end; ++match)
      if (std::ranges::find(layers, (*match)[1].str()) != layers.end())
        found.push_back({number, (*match)[1], false});
  }
  return found;
}

}  // namespace poinsot::layering

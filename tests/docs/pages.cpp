// SPDX-License-Identifier: Apache-2.0
#include "docs/pages.h"

#include <fstream>
#include <regex>
#include <sstream>

namespace poinsot {

std::string textOf(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::multiset<int> equationRows(const std::string& markdown) {
  static const std::regex kRow(R"(\n\| (\d+)(?:–(\d+))? \|)");
  std::multiset<int> equations;
  for (std::sregex_iterator match(markdown.begin(), markdown.end(), kRow), end; match != end; ++match) {
    const int first = std::stoi((*match)[1]), last = (*match)[2].matched ? std::stoi((*match)[2]) : first;
    for (int n = first; n <= last; ++n) equations.insert(n);
  }
  return equations;
}

}  // namespace poinsot

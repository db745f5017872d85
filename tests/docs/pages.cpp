// SPDX-License-Identifier: Apache-2.0
#include "docs/pages.h"

#include <regex>

namespace poinsot {

std::vector<std::filesystem::path> pages() {
  const std::filesystem::path root = POINSOT_SOURCE_DIR;
  std::vector<std::filesystem::path> found{root / "README.md"};
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md") found.push_back(entry.path());
  return found;
}

std::vector<std::string> tomlBlocks(const std::string& markdown) {
  const std::string first = "```toml\n", last = "\n```\n";
  std::vector<std::string> blocks;
  for (std::size_t begin = 0; (begin = markdown.find(first, begin)) != std::string::npos;) {
    begin += first.size();
    blocks.push_back(markdown.substr(begin, markdown.find(last, begin) + 1 - begin));
  }
  return blocks;
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

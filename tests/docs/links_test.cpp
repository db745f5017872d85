// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>
#include <vector>

#include "docs/pages.h"

// Pages for people: their links lead to files. lecture_test.py checks the rows of the page on physics.

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::IsEmpty;

/// Returns a page without the text between lines of ```, because a lambda of C++ looks like a link.
std::string withoutCode(std::string markdown) {
  const std::string fence = "\n```";
  for (std::size_t begin = 0; (begin = markdown.find(fence, begin)) != std::string::npos;)
    markdown.erase(begin, markdown.find(fence, begin + 1) + fence.size() - begin);
  return markdown;
}

/// Returns the targets of [text](target) in Markdown, without #fragments and without addresses of other sites.
std::vector<std::string> fileLinks(const std::string& page) {
  const std::string markdown = withoutCode(page);
  static const std::regex kLink(R"(\]\(([^)#\s]+)[^)]*\))");
  std::vector<std::string> links;
  for (std::sregex_iterator match(markdown.begin(), markdown.end(), kLink), end; match != end; ++match)
    if ((*match)[1].str().find("://") == std::string::npos) links.push_back((*match)[1]);
  return links;
}

std::vector<std::string> broken(const fs::path& page, const std::string& markdown) {
  std::vector<std::string> missing;
  for (const std::string& link : fileLinks(markdown))
    if (!fs::exists(page.parent_path() / link)) missing.push_back(page.filename().string() + ": " + link);
  return missing;
}

TEST(Docs, LinksLeadToFiles) {
  std::size_t links = 0;
  for (const fs::path& page : pages()) {
    const std::string markdown = textOf(page);
    EXPECT_THAT(broken(page, markdown), IsEmpty());
    links += fileLinks(markdown).size();
  }
  EXPECT_GT(links, 50u);  // guards against a search that finds no links
}

// Users who keep approved pictures read in this section what an update changes.
TEST(Docs, ChangelogHasASectionPicturesForEachRelease) {
  const std::string changes = textOf(fs::path(POINSOT_SOURCE_DIR) / "CHANGELOG.md");
  std::size_t releases = 0;
  for (std::size_t begin = changes.find("\n## "); begin != std::string::npos; ++releases) {
    const std::size_t end = changes.find("\n## ", begin + 1);
    const std::string release = changes.substr(begin, end - begin);
    EXPECT_THAT(release, ::testing::HasSubstr("\n### Pictures\n"));
    begin = end;
  }
  EXPECT_GT(releases, 0u);
}

TEST(Docs, ABrokenLinkIsDetected) {
  const fs::path page = fs::path(POINSOT_SOURCE_DIR) / "docs/physics.md";
  EXPECT_THAT(fileLinks("[a](b.md) ![c](d/e.png) [f](g.md#h \"title\") [i](https://example.org/j) [k](#l)"),
              ::testing::ElementsAre("b.md", "d/e.png", "g.md"));
  EXPECT_THAT(fileLinks("[a](b.md)\n```cpp\n[](Draft& d)\n```\n[c](d.md)\n```\n[](e)\n```\n"),
              ::testing::ElementsAre("b.md", "d.md"));
  EXPECT_THAT(broken(page, "[a](physics.md) [b](no_such_page.md)"),
              ::testing::ElementsAre("physics.md: no_such_page.md"));
}

}  // namespace
}  // namespace poinsot

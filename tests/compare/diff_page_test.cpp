// SPDX-License-Identifier: Apache-2.0
// The page itself is tested in a browser: tests/golden/page_test.py.
#include "compare/diff_page.h"

#include <gtest/gtest.h>

namespace poinsot::compare {
namespace {

DiffPageEntry entryOf(std::size_t bytes) {
  DiffPageEntry entry;
  entry.status = "different";
  entry.reference = {std::string(bytes, 'r'), "old.png"};
  entry.actual = {std::string(bytes, 'a'), "new.png"};
  return entry;
}

/// Returns how many rows with pictures of that size are embedded.
int admitted(std::size_t bytes) {
  EmbedBudget budget;
  for (int rows = 0; rows < 200; ++rows) {
    DiffPageEntry entry = entryOf(bytes);
    budget.admit(entry);
    EXPECT_EQ(entry.actual.file, "new.png");
    EXPECT_EQ(entry.reference.png.empty(), budget.isSpent());
    EXPECT_EQ(entry.actual.png.empty(), budget.isSpent());
    if (budget.isSpent()) return rows;
  }
  return 200;
}

// Ten rows of 2 x 2 500 000 bytes are 50 MB.
TEST(EmbedBudget, EndsAtAHundredRowsOrFiftyMegabytes) {
  EXPECT_EQ(admitted(1), 100);
  EXPECT_EQ(admitted(2'500'000), 10);
  EXPECT_EQ(admitted(2'500'001), 9);
  EXPECT_EQ(admitted(25'000'001), 0);
}

TEST(EmbedBudget, CountsNoRowWithoutPictures) {
  EmbedBudget budget;
  DiffPageEntry empty;
  for (int i = 0; i < 101; ++i) budget.admit(empty);
  EXPECT_FALSE(budget.isSpent());
}

TEST(WorstFirst, PutsRowsWithoutFiguresBeforeThoseThatDifferMost) {
  std::vector<DiffPageEntry> entries(4, entryOf(1));
  entries[0].status = "identical";
  entries[1].diff.figures.flip.mean = 0.1;
  entries[2].diff.figures.flip.mean = 0.2;
  for (DiffPageEntry& entry : entries) entry.diff.hasFigures = true;
  entries[3].status = "missing";
  entries[3].diff.hasFigures = false;
  const std::vector<DiffPageEntry*> expected{&entries[3], &entries[2], &entries[1]};
  EXPECT_EQ(worstFirst(entries), expected);
}

// Names come from file systems, and the data stands in a script element, so that no "<" may be left in the data.
// Placeholders of the template in a name are text like any other.
TEST(DiffPage, EscapesHostileFileNames) {
  DiffPage page{"</script><script>alert(1)</script>", "different"};
  page.file = "page.html";
  page.entries.push_back(entryOf(0));
  page.entries[0].name = "@SCRIPT@@DATA@@STYLE@<!--\xff";
  const std::string html = htmlOf(page);
  EXPECT_EQ(html.find("<script>alert(1)"), std::string::npos);
  EXPECT_NE(html.find("@SCRIPT@@DATA@@STYLE@\\u003c!--\\ufffd"), std::string::npos);
  EXPECT_EQ(html.find("@STYLE@</style>"), std::string::npos);
  EXPECT_NE(html.find("'use strict'"), std::string::npos);
}

}  // namespace
}  // namespace poinsot::compare

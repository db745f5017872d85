// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include "docs/pages.h"

// The page of the gallery shows every scene, and names the scene that draws each equation.

namespace poinsot {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = POINSOT_SOURCE_DIR;

std::string page() { return textOf(kRoot / "docs/gallery.md"); }

std::set<std::string> namesIn(const fs::path& folder, const std::string& extension) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == extension) names.insert(entry.path().stem());
  return names;
}

TEST(GalleryPage, ShowsEveryScene) {
  const std::string text = page();
  for (const std::string& name : namesIn(kRoot / "scenes", ".toml")) {
    const std::string row =
        "| ![](images/gallery/" + name + ".png) [" + name + "](../scenes/" + name + ".toml) | ";
    EXPECT_NE(text.find(row), std::string::npos) << "no row begins with " << row;
  }
}

TEST(GalleryPage, HasASmallPictureForEachScene) {
  const fs::path folder = kRoot / "docs/images/gallery";
  EXPECT_EQ(namesIn(folder, ".png"), namesIn(kRoot / "scenes", ".toml"));
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_LE(fs::file_size(entry.path()), 60'000u) << entry.path().filename();
}

TEST(GalleryPage, ListsEveryEquationOfTheLectureOnce) {
  std::multiset<int> all;
  for (int n = 1; n <= 40; ++n) all.insert(n);
  EXPECT_EQ(equationRows(page()), all);
}

TEST(GalleryPage, DescribesEachSceneInItsFirstComment) {
  for (const std::string& name : namesIn(kRoot / "scenes", ".toml"))
    EXPECT_THAT(textOf(kRoot / "scenes" / (name + ".toml")), ::testing::StartsWith("# ")) << name;
}

}  // namespace
}  // namespace poinsot

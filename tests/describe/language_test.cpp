// SPDX-License-Identifier: Apache-2.0
// Descriptions in German: every text has a translation with the same fields, and a German description states the
// numbers of the English one.
#include "describe/language.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "describe/alt_text.h"
#include "support/gallery_scenes.h"

namespace poinsot::describe {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::vector<std::string> matches(const std::string& text, const std::regex& pattern, std::size_t group = 0) {
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    all.push_back((*it)[group].str());
  return all;
}

std::vector<std::string> sorted(std::vector<std::string> words) {
  std::ranges::sort(words);
  return words;
}

TEST(Translations, HaveTheFieldsOfTheEnglishText) {
  const std::regex field(R"(\{[0-9]?\})");
  for (const auto& [english, german] : translations())
    EXPECT_EQ(sorted(matches(std::string(english), field)), sorted(matches(std::string(german), field)))
        << english;
}

TEST(Translations, AreThereForEveryTextThatTheSourcesSay) {
  std::set<std::string> known;
  for (const auto& [english, german] : translations()) known.insert(std::string(english));
  const std::regex call(R"re(say\(\s*"((?:[^"\\]|\\.)*)")re"), join(R"re("\s*\n\s*")re");
  std::size_t found = 0;
  for (const auto& file : std::filesystem::directory_iterator(POINSOT_SOURCE_DIR "/src/describe")) {
    if (file.path().extension() != ".cpp") continue;
    std::ifstream source(file.path());
    const std::string text = std::regex_replace(std::string(std::istreambuf_iterator<char>(source), {}), join, "");
    for (const std::string& said : matches(text, call, 1)) {
      EXPECT_TRUE(known.contains(said)) << file.path() << ": " << said;
      ++found;
    }
  }
  EXPECT_GT(found, 60u);
}

TEST(GermanDescription, StatesTheNumbersOfTheEnglishOneForEachGalleryScene) {
  const std::regex number(R"([0-9]+([.,][0-9]+)?)");
  const std::regex english(" (the|and|with|of|is|about|turns|round) ");
  for (const std::string& name : galleryNames()) {
    scene::Scene scene = galleryScene(name);
    scene.show.title = scene.show.subtitle = "";  // texts of the scene are not translated
    scene.notes.clear();
    scene.vectors.clear();
    scene.angles.clear();
    for (scene::View& view : scene.views) view.title = view.subtitle = "";
    for (scene::Plot& plot : scene.plots) plot.title = "";
    const std::string before = altText(scene);
    scene.output.language = scene::Language::kGerman;
    std::string german = altText(scene);
    EXPECT_FALSE(std::regex_search(german, english)) << name << ": " << german;
    EXPECT_THAT(german, HasSubstr("Der Körper ist")) << name;
    std::vector<std::string> numbers = matches(german, number);
    for (std::string& each : numbers) std::ranges::replace(each, ',', '.');
    EXPECT_EQ(sorted(numbers), sorted(matches(before, number))) << name << "\n" << before << "\n" << german;
    EXPECT_EQ(altText(galleryScene(name)).find("Der Körper"), std::string::npos);
  }
}

TEST(GermanDescription, NamesEverySolid) {
  for (const char* body : {"shape = \"box\"\nsize = [3, 2, 1]\n", "shape = \"sphere\"\nradius = 1\n",
                           "shape = \"disc\"\nradius = 1\n", "shape = \"cone\"\nradius = 1\nheight = 2\n",
                           "shape = \"cube\"\nedge = 1\n", "shape = \"racket\"\nlength = 0.68\nwidth = 0.26\n"}) {
    const scene::Scene scene = scene::parseScene("[body]\n" + std::string(body) +
                                                     "mass = 1\n[motion]\nomega_body = [0.1, 2, 0.3]\n"
                                                     "[output]\nlanguage = \"de\"\n",
                                                 "a.toml");
    EXPECT_THAT(altText(scene), ::testing::ContainsRegex("Der Körper ist ein")) << body;
  }
}

}  // namespace
}  // namespace poinsot::describe

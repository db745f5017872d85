// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "docs/pages.h"
#include "request/scene_request.h"
#include "request/user_files.h"
#include "scene/scene_file.h"
#include "suite/manifest.h"
#include "support/scratch_folder.h"
#include "text/commands.h"
#include "text/math_setter.h"

// TOML on the pages can be copied and works: whole scenes as they are, parts at the end of a whole scene. The
// steps of "Your first film" add up to its last file, and each step has its picture.

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::SizeIs;

const fs::path kRoot = POINSOT_SOURCE_DIR;

bool isWhole(const std::string& toml) {
  return toml.find("[body]\n") != std::string::npos && toml.find("[motion]\n") != std::string::npos;
}

/// Returns whether a block is a suite of golden images.
bool isSuite(const std::string& toml) { return toml.find("[[test]]\n") != std::string::npos; }

/// Completes a part of a scene. A part that begins with a key continues [show], as on the pages.
std::string madeWhole(const std::string& part) {
  const std::string body = "[body]\ncatalogue = \"book\"\n[motion]\nomega_body = [0, 6, 0.1]\n";
  return body + (part.starts_with('[') ? "" : "[show]\n") + part;
}

/// Returns what is wrong with a golden.toml whose scenes lie beside it; empty if nothing is.
std::string problemOfGoldens(const std::string& toml) {
  const ScratchFolder folder;
  for (const char* scenes : {"scenes", "lessons"}) {
    fs::create_directory(folder / scenes);
    folder.put(std::string(scenes) + "/racket.toml", "");
  }
  try {
    suite::readGoldenManifest(folder.put("golden.toml", toml));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// Returns whether a block is a user's defaults.toml.
bool isDefaults(const std::string& toml) { return toml.starts_with("[units]\n"); }

std::string problemOfDefaults(const std::string& toml) {
  const ScratchFolder folder;
  try {
    request::defaultsOf(folder.put("defaults.toml", toml));
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

/// Returns what is wrong with a block; empty if nothing is. Files that a scene names are looked for in scenes/.
std::string problem(const std::string& toml) {
  if (isSuite(toml)) return problemOfGoldens(toml);
  if (isDefaults(toml)) return problemOfDefaults(toml);
  try {
    request::loadRequested({kRoot / "scenes/page.toml", toml, {}, std::nullopt});
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

std::pair<int, int> sizeOf(const fs::path& png) {
  const std::string bytes = textOf(png).substr(0, 24);
  const auto number = [&](std::size_t at) {
    int value = 0;
    for (std::size_t k = at; k < at + 4; ++k) value = 256 * value + static_cast<unsigned char>(bytes.at(k));
    return value;
  };
  return {number(16), number(20)};
}

std::string withoutEmptyLines(std::string text) {
  text.erase(std::unique(text.begin(), text.end(), [](char a, char b) { return a == '\n' && b == '\n'; }),
             text.end());
  return text;
}

TEST(DocsScenes, EveryTomlBlockWorks) {
  int whole = 0;
  for (const fs::path& page : pages())
    for (const std::string& block : tomlBlocks(textOf(page))) {
      EXPECT_EQ(problem(isWhole(block) || isSuite(block) || isDefaults(block) ? block : madeWhole(block)), "")
          << page.filename() << ":\n"
          << block;
      whole += isWhole(block) ? 1 : 0;
    }
  EXPECT_GE(whole, 5);  // README, scene.md, and three of the first film
}

TEST(DocsScenes, AMistakeInABlockIsDetected) {
  EXPECT_THAT(tomlBlocks("a\n```toml\nb = 1\n```\nc\n```\nd\n```\n\n```toml\ne = 2\n```\n"),
              ::testing::ElementsAre("b = 1\n", "e = 2\n"));
  EXPECT_THAT(problem(madeWhole("plain = false\n")), ::testing::HasSubstr("show.plane"));
  EXPECT_THAT(problem(madeWhole("title = '$\\omga$'\n")), ::testing::HasSubstr("\\omega"));
}

TEST(DocsScenes, EveryCommandOfFormulasIsListed) {
  const std::string page = textOf(kRoot / "docs/figures.md");
  const std::size_t begin = page.find("\n## Formulas\n");
  ASSERT_NE(begin, std::string::npos);
  const std::string section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
  for (const text::Command& command : text::commands()) {
    if (command.name == " ") continue;  // described in words
    const std::string name = "\\" + std::string(command.name);
    EXPECT_THAT(section, ::testing::AnyOf(::testing::HasSubstr(name + " "), ::testing::HasSubstr(name + "`"),
                                          ::testing::HasSubstr(name + "{"), ::testing::HasSubstr(name + "\n")));
  }
}

// Steps 1 and 2 are whole files, steps 3, 4 and 5 are added to the file, and the sixth block is the whole file
// again.
TEST(FirstFilm, EachStepIsAValidSceneAndTheyAddUp) {
  const std::vector<std::string> blocks = tomlBlocks(textOf(kRoot / "docs/first_film.md"));
  ASSERT_THAT(blocks, SizeIs(6));
  EXPECT_EQ(std::ranges::count(blocks[0], '\n'), 4);
  EXPECT_EQ(problem(blocks[0]), "");
  std::string file = blocks[1];
  EXPECT_EQ(problem(file), "") << "step 2";
  for (std::size_t k = 2; k < 5; ++k) {
    file += blocks[k];
    EXPECT_EQ(problem(file), "") << "step " << k + 1;
  }
  EXPECT_EQ(withoutEmptyLines(file), withoutEmptyLines(blocks[5]));
}

// A picture has at most 75 kB: measured 41 to 71 kB, the larger ones with the ellipsoid's many pale shades.
TEST(FirstFilm, EachStepHasItsCommandAndItsPicture) {
  const std::string page = textOf(kRoot / "docs/first_film.md");
  for (const char* step : {"step_1", "step_2", "step_3", "step_4", "step_5"}) {
    const std::string name = std::string(step) + ".png";
    EXPECT_THAT(page, ::testing::HasSubstr(" -q preview -o out/" + name + "\n\n!["));
    EXPECT_THAT(page, ::testing::HasSubstr("](images/first_film/" + name + ")\n"));
    const fs::path picture = kRoot / "docs/images/first_film" / name;
    EXPECT_EQ(sizeOf(picture), std::pair(640, 360)) << name;
    EXPECT_LE(fs::file_size(picture), 75'000u) << name;
  }
}

}  // namespace
}  // namespace poinsot

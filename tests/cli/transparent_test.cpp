// SPDX-License-Identifier: Apache-2.0
// Tests pictures without paper, made by the whole program: pixels of alpha 0 have no colour. libav decodes the
// films, which are compared with a PNG sequence of the same frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "image/png_file.h"
#include "output/film_reader.h"
#include "support/program_run.h"

namespace poinsot {
namespace {

const std::string kScene =
    "[body]\nprincipal_moments = [1, 2, 3]\n[motion]\nomega_body = [0.1, 3, 0]\n[time]\nduration = 0.5\nfps = 10\n"
    "[output]\nsize = [160, 90]\n";
constexpr int kFrames = 5;

/// Numbers of pixels with alpha 0 (`empty`), and of those that have a colour (`colored`).
struct Hidden {
  int colored = 0, empty = 0;
};

template <typename Sample>
Hidden hiddenIn(const image::BasicImage<Sample>& picture) {
  Hidden hidden;
  EXPECT_EQ(picture.channels, 4);
  for (auto at = picture.pixels.begin(); at != picture.pixels.end(); at += 4) {
    if (at[3] != 0) continue;
    ++hidden.empty;
    if (std::any_of(at, at + 3, [](Sample sample) { return sample != 0; })) ++hidden.colored;
  }
  return hidden;
}

void expectNothingHidden(const image::AnyImage& picture, const std::string& name) {
  const Hidden hidden = std::visit([](const auto& image) { return hiddenIn(image); }, picture);
  EXPECT_GT(hidden.empty, 1000) << name;
  EXPECT_EQ(hidden.colored, 0) << name;
}

class Transparent : public testing::Test {
 protected:
  void SetUp() override { folder_.put("a.toml", kScene); }

  void make(std::vector<std::string> words) const {
    words.insert(words.end(), {"--transparent", "--quiet"});
    const RunResult made = run(folder_, words);
    EXPECT_EQ(made.exitCode, 0) << words.back() << made.err;
  }

  std::vector<image::Image> sequence() const {
    make({"render", "a.toml", "-o", "s_{frame}.png"});
    std::vector<image::Image> pictures;
    for (int k = 0; k < kFrames; ++k)
      pictures.push_back(image::readPng(folder_ / ("s_" + std::to_string(k) + ".png")));
    return pictures;
  }

  std::vector<image::AnyImage> film(const std::string& name, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> words{"render", "a.toml", "-o", name};
    words.insert(words.end(), more.begin(), more.end());
    make(words);
    output::FilmReader reader(folder_ / name);
    std::vector<image::AnyImage> pictures;
    while (auto shown = reader.next()) pictures.push_back(std::move(shown->picture));
    return pictures;
  }

  ScratchFolder folder_;
};

TEST_F(Transparent, PicturesHaveNoColourInEmptyPixels) {
  const std::string range = "motion.omega_body=[0.1..0.4:2, 3, 0]";
  make({"still", "a.toml", "-o", "still.png"});
  make({"still", "a.toml", "-o", "deep.png", "--bits", "16"});
  make({"sweep", "a.toml", "-o", "sheet.png", "-D", range});
  make({"sweep", "a.toml", "-o", "map.png", "--map"});
  make({"render", "a.toml", "-o", "frame.png", "--frames", "3"});
  for (const char* name : {"still.png", "deep.png", "sheet.png", "map.png", "frame.png"})
    expectNothingHidden(image::readPngAsStored(folder_ / name).picture, name);
  for (const image::Image& picture : sequence()) expectNothingHidden(picture, "sequence");
}

// docs/films.md promises "Every pixel as it was drawn".
TEST_F(Transparent, ApngHasTheFramesOfTheSequence) {
  const auto expected = sequence();
  const auto frames = film("a.apng");
  ASSERT_EQ(frames.size(), expected.size());
  for (std::size_t k = 0; k < frames.size(); ++k)
    EXPECT_TRUE(std::get<image::Image>(frames[k]) == expected[k]) << "frame " << k;
}

/// Returns how much a pixel changes the paper under it, in steps of 255.
double seen(double color, double alpha, double paper) { return std::abs(alpha * (255 * color - paper)); }

/// Returns the largest change of white or black paper by pixels that have alpha 0 in the sequence.
double mostSeen(const std::vector<image::AnyImage>& frames, const std::vector<image::Image>& expected) {
  double most = 0;
  for (std::size_t k = 0; k < frames.size(); ++k)
    std::visit(
        [&](const auto& image) {
          const double full = image.kMost;
          for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
            if (expected[k].pixels[i + 3] != 0) continue;
            for (std::size_t c = 0; c < 3; ++c)
              for (const double paper : {0, 255})
                most = std::max(most, seen(image.pixels[i + c] / full, image.pixels[i + 3] / full, paper));
          }
        },
        frames[k]);
  return most;
}

// VP9 compresses alpha with losses, as it does colours, so alpha next to an edge is not quite 0. Measured: 11 of
// 255 at crf = 18; 0 if VP9 is lossless, and in ProRes.
TEST_F(Transparent, FilmsHaveInvisibleEmptyPixels) {
  const auto expected = sequence();
  EXPECT_LE(mostSeen(film("a.webm"), expected), 16);
  EXPECT_EQ(mostSeen(film("b.webm", {"-D", "output.crf=0"}), expected), 0);
  EXPECT_EQ(mostSeen(film("a.mov"), expected), 0);
}

}  // namespace
}  // namespace poinsot

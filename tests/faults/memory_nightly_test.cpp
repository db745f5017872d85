// SPDX-License-Identifier: Apache-2.0
// Measures the memory of a worker at 4K over many frames, and compares each encoder with the estimate of
// request/memory.h.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "faults/memory_watch.h"
#include "faults/tiny_film.h"
#include "request/memory.h"
#include "scene/scene_file.h"

namespace poinsot::faults {
namespace {

std::vector<std::string> arguments(const char* target, image::PixelSize size, int frames, const char* segment) {
  return {"render",       "tiny.toml",
          "-o",           target,
          "--size",       std::to_string(size.width) + "x" + std::to_string(size.height),
          "-j",           "1",
          "--progress",   "json",
          "--segment",    segment,
          "--max-memory", "64GiB",
          "-D",           "time.duration=" + std::to_string(frames / 10.0)};
}

// With segments of 10 frames, encoders are opened and closed three times as often as by default. If each encoder
// leaked a picture of 12 MiB, the medians rose by 48 MiB and the peak to 1108 MiB. The number of pictures that an
// encoder buffers depends on the machine's load: medians differed by up to 24 MiB, peaks by 76 MiB.
// Memory.DoesNotGrowWithTheFrames finds leaks that do not grow with the picture.
void expectFlatBelowAGibibyte(int frames) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  const MemoryWatch watch(folder, arguments("t.mp4", {3840, 2160}, frames, "10"));
  ASSERT_EQ(watch.frames(), frames);
  const int begun = frames / 6, middle = (begun + frames) / 2;
  const double early_MiB = watch.workerMedian_MiB(begun, middle),
               late_MiB = watch.workerMedian_MiB(middle, frames), peak_MiB = watch.workerPeak_MiB(begun, frames);
  std::printf("frames %d to %d: %.1f MiB, %d to %d: %.1f MiB, peak %.1f MiB, parent %.1f MiB\n", begun, middle,
              early_MiB, middle, frames, late_MiB, peak_MiB, watch.parentPeak_MiB());
  EXPECT_LE(late_MiB - early_MiB, 36);
  EXPECT_LE(peak_MiB, 1024);
}

TEST(MemoryNightly, StaysConstantBelowAGibibyteFor4kFilms) { expectFlatBelowAGibibyte(240); }

// Takes most of an hour, so it runs only by name: --gtest_also_run_disabled_tests. Measured 960 and 950 MiB,
// parent 42 MiB.
TEST(MemoryNightly, DISABLED_StaysConstantBelowAGibibyteForALong4kFilm) { expectFlatBelowAGibibyte(10'000); }

struct Measured {
  const char *name, *target;
  image::PixelSize size;
  output::FilmFormat format;
  std::vector<std::string> more = {};
  int frames = 12;  // more than any encoder looks ahead, except AV1's
};

void PrintTo(const Measured& measured, std::ostream* out) { *out << measured.target; }

using output::Chroma, output::Effort, output::FilmCodec, output::FilmContainer;

class MemoryEstimate : public testing::TestWithParam<Measured> {};

/// Scene whose body fills the picture, for which drawing solids takes the most memory.
const std::string kFullScene = std::string(kTinyScene) + "[camera]\nzoom = 6\n";

TEST_P(MemoryEstimate, IsWithinAFifthOfThePeak) {
  const Measured& m = GetParam();
  const ScratchFolder folder;
  folder.put("tiny.toml", kFullScene);
  auto words = arguments(m.target, m.size, m.frames, "30");
  words.insert(words.end(), m.more.begin(), m.more.end());
  const MemoryWatch watch(folder, words);
  const bool isFilm = !std::string(m.target).ends_with(".png");
  const double expected_MiB =
      request::workerMemory_bytes(m.size, isFilm ? std::optional(m.format) : std::nullopt) / (1 << 20);
  const double peak_MiB = watch.workerPeak_MiB(0, m.frames + 1);
  std::printf("%s: peak %.0f MiB, estimate %.0f MiB, ratio %.2f\n", m.name, peak_MiB, expected_MiB,
              expected_MiB / peak_MiB);
  EXPECT_LE(expected_MiB, 1.2 * peak_MiB);
  EXPECT_GE(expected_MiB, peak_MiB / 1.2);
}

std::string sphere(int triangles) {
  const int n = static_cast<int>(std::sqrt(triangles / 2));
  const auto vertex = [n](int i, int j) {
    const double theta = 3.14159265 * i / n, phi = 6.28318531 * (j % n) / n;
    const double r = 1 + 0.03 * std::sin(9 * theta) * std::sin(9 * phi);
    return std::array{r * std::sin(theta) * std::cos(phi), r * std::sin(theta) * std::sin(phi),
                      r * std::cos(theta)};
  };
  std::string text;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < n; ++j) {
      const auto [x, y, z] = vertex(i, j);
      text += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    }
  const auto at = [n](int i, int j) { return std::to_string(1 + i * n + j % n) + " "; };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) text += "f " + at(i, j) + at(i + 1, j) + at(i + 1, j + 1) + at(i, j + 1) + "\n";
  return text;
}

// Measured 206 MiB for 300 000 triangles and 307 MiB for a million; the estimates are 209 and 342 MiB. A binary
// STL, whose equal vertices must first be merged, took 238 and 377 MiB.
TEST(MemoryNightly, IsEstimatedWithinAFifthForMeshes) {
  for (const int triangles : {300'000, 1'000'000}) {
    const ScratchFolder folder;
    folder.put("tiny.toml", std::string(kTinyScene) + "[show.body]\nshape = 'mesh'\nfile = 'm.obj'\n");
    folder.put("m.obj", sphere(triangles));
    const MemoryWatch watch(folder, arguments("t_{frame}.png", {640, 360}, 2, "30"));
    const auto scene = scene::loadScene(folder / "tiny.toml");
    const double expected_MiB =
        (request::workerMemory_bytes({640, 360}, std::nullopt) + request::meshMemory_bytes(scene)) / (1 << 20);
    const double peak_MiB = watch.workerPeak_MiB(0, 3);
    std::printf("%d triangles: peak %.0f MiB, estimate %.0f MiB, ratio %.2f\n", triangles, peak_MiB, expected_MiB,
                expected_MiB / peak_MiB);
    EXPECT_LE(expected_MiB, 1.2 * peak_MiB);
    EXPECT_GE(expected_MiB, peak_MiB / 1.2);
  }
}

constexpr image::PixelSize kHd{1920, 1080}, k4k{3840, 2160}, kLargest{8192, 8192};

INSTANTIATE_TEST_SUITE_P(
    Each, MemoryEstimate,
    testing::Values(
        Measured{"Picture", "t_{frame}.png", kHd, {}, {}, 2},
        Measured{"SmallPicture", "t_{frame}.png", {640, 360}, {}, {}, 2},
        Measured{"PicturesThatFillUp", "t_{frame}.png", k4k, {}, {}, 18},
        Measured{"LargestPicture", "t_{frame}.png", kLargest, {}, {}, 2}, Measured{"Film", "t.mp4", kHd, {}},
        Measured{"SmallFilm", "t.mp4", {640, 360}, {}}, Measured{"Film4k", "t.mp4", k4k, {}},
        Measured{"LargestFilm", "t.mp4", kLargest, {}, {}, 10},
        Measured{"FineFilm", "t.mp4", kHd, {.chroma = Chroma::k444}, {"-D", "output.chroma=\"4:4:4\""}},
        Measured{"SlowFilm", "t.mp4", kHd, {.effort = Effort::kSlow}, {"-D", "output.effort=\"slow\""}},
        Measured{"Hevc", "t.mp4", kHd, {.codec = FilmCodec::kHevc}, {"-D", "output.codec=\"hevc\""}},
        Measured{"Vp9", "t.webm", kHd, {.container = FilmContainer::kWebm, .codec = FilmCodec::kVp9}},
        Measured{"Av1",
                 "t.webm",
                 kHd,
                 {.container = FilmContainer::kWebm, .codec = FilmCodec::kAv1},
                 {"-D", "output.codec=\"av1\""}},
        Measured{"TransparentVp9",
                 "t.webm",
                 kHd,
                 {.container = FilmContainer::kWebm, .codec = FilmCodec::kVp9, .transparent = true},
                 {"--transparent"}},
        Measured{"ProRes", "t.mov", kHd, {.container = FilmContainer::kMov, .codec = FilmCodec::kProRes}},
        Measured{"Gif", "t.gif", kHd, {.container = FilmContainer::kGif, .codec = FilmCodec::kGif}}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace poinsot::faults

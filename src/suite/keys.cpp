// SPDX-License-Identifier: Apache-2.0
#include "suite/keys.h"

#include <algorithm>

namespace poinsot::suite {
namespace {

constexpr GoldenKey kKeys[] = {
    {"", "references", "text", "folder of the approved pictures, relative to the folder of this file", "golden",
     "\"approved\""},
    {"", "size", "[width, height]", "size in pixels of the scenes' pictures; a test can override it", "",
     "[256, 144]"},
    {"", "height", "pixels", "replaces size; the width keeps each scene's aspect ratio", "", "144"},
    {"", "variant", "text", "variant of the pictures that other programs make; --variant overrides it", "",
     "\"mesa\""},
    {"", "rule", "table or text", "rule of all tests without a rule of their own", "near", "\"other_driver\""},
    {"", "test", "[[test]]", "pictures to compare; there must be at least one", "", ""},
    {"test", "scene", "text",
     "scene to draw; a pattern with * (names) and ** (folders) makes a test for each file", "",
     "\"scenes/*.toml\""},
    {"test", "image", "text",
     "replaces scene: PNG or film that another program made; a pattern with * and ** makes a test for each file",
     "", "\"plots/*.png\""},
    {"test", "name", "text", "name of the test and of its reference; * stands for the file's name",
     "the file's name, relative to the folder of the first *", "\"lesson_*\""},
    {"test", "times", "film times", "such as 0, 1.5 or \"90 ms\"; a list makes a picture for each time",
     "the scene's time.still", "[0, \"1.5 s\"]"},
    {"test", "size", "[width, height]", "size in pixels of the scene's picture",
     "the top-level size, or the scene's", "[640, 360]"},
    {"test", "height", "pixels", "replaces size; the width keeps the scene's aspect ratio", "the top-level height",
     "360"},
    {"test", "set", "\"KEY=VALUE\"",
     "override of a scene key, or a list of overrides; a range of values makes a grid of pictures", "",
     "[\"style.theme=dark\"]"},
    {"test", "variant", "text",
     "name of the driver or machine that made the image, if references differ between them",
     "the top-level variant", "\"softpipe\""},
    {"test", "rule", "table or text", "how far the picture may be from its reference", "the top-level rule",
     "\"same\""},
    {"rule", "like", "text", "named limits: same, near or other_driver; the other keys override them", "near",
     "\"other_driver\""},
    {"rule", "max", "\"0-N\"", "largest difference of a channel, of 255", "0-2", "\"0-255\""},
    {"rule", "pixels", "\"0-N\"", "differing pixels, as a number or a percentage", "0-0.5%", "\"0-20\""},
    {"rule", "flip_mean", "\"0-N\"", "mean of FLIP", "0-1e-3", "\"0-0.01\""},
    {"rule", "flip_max", "\"0-N\"", "largest FLIP of a pixel", "0-0.05", "\"0-1\""},
    {"rule", "level", "N", "pixels that differ by at most N of 255 do not count in pixels", "0", "8"},
    {"rule", "ignore", "[[x, y, w, h], ...]", "boxes of pixels that are not compared", "", "[[0, 0, 120, 20]]"},
    {"rule", "mask", "text", "PNG of the picture's size; where it is painted, pixels are not compared", "",
     "\"mask.png\""},
    {"rule", "reason", "text", "why the picture may differ; required in a table of limits", "",
     "\"nearest-texel lookups flip on other processors\""},
};

}  // namespace

std::span<const GoldenKey> goldenKeys() { return kKeys; }

std::vector<std::string> goldenKeysOf(std::string_view table) {
  std::vector<std::string> names;
  for (const GoldenKey& key : kKeys)
    if (key.table == table) names.emplace_back(key.name);
  std::ranges::sort(names);
  return names;
}

}  // namespace poinsot::suite

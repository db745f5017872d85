// SPDX-License-Identifier: Apache-2.0
#include "app/golden_keys.h"

#include <algorithm>

namespace poinsot::app {
namespace {

constexpr GoldenKey kKeys[] = {
    {"", "references", "text", "folder of the approved pictures, from the folder of this file (default: golden)"},
    {"", "size", "[width, height]", "size in pixels of the scenes' pictures; a test may have another"},
    {"", "height", "pixels", "in place of size: the width keeps each scene's proportion"},
    {"", "variant", "text", "variant of the pictures that other programs make; --variant comes before it"},
    {"", "rule", "table or text", "rule of all tests that have none of their own"},
    {"", "test", "[[test]]", "pictures to compare; there must be at least one"},
    {"test", "scene", "text", "scene to draw; with * (names) and ** (folders) a test for each file"},
    {"test", "image", "text",
     "in place of scene: PNG or film that another program makes before; with * and ** a test for each file"},
    {"test", "name", "text",
     "name of the test and of its reference (default: the file's, from the folder of the first *); * stands for "
     "that"},
    {"test", "times", "film times",
     "0, 1.5 or \"90 ms\"; several make a picture each (default: the scene's time.still)"},
    {"test", "size", "[width, height]",
     "size in pixels of the scene's picture (default: the file's, or the scene's)"},
    {"test", "height", "pixels", "in place of size: the width keeps the scene's proportion"},
    {"test", "set", "\"KEY=VALUE\"", "other values for keys of the scene, one or a list; a range makes a sheet"},
    {"test", "variant", "text",
     "name of the driver or machine that made the image, where references differ by it"},
    {"test", "rule", "table or text", "how far the picture may be from its reference"},
    {"rule", "like", "text", "limits by name: same, near (the default) or other_driver; the others change them"},
    {"rule", "max", "\"0-N\"", "largest difference of a channel, of 255 (default: 0-2)"},
    {"rule", "pixels", "\"0-N\"", "differing pixels, a number or a share such as \"0-0.5%\" (the default)"},
    {"rule", "flip_mean", "\"0-N\"", "mean of FLIP (default: 0-1e-3)"},
    {"rule", "flip_max", "\"0-N\"", "largest FLIP of a pixel (default: 0-0.05)"},
    {"rule", "level", "N", "pixels that differ by at most N of 255 do not count in pixels (default: 0)"},
    {"rule", "ignore", "[[x, y, w, h], ...]", "boxes of pixels that are not compared"},
    {"rule", "mask", "text", "PNG of the picture's size; where it is painted, pixels are not compared"},
    {"rule", "reason", "text", "why the picture may differ; a table of limits needs one"},
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

}  // namespace poinsot::app

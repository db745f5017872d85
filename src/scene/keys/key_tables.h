// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/limits.h"

/// Parts of the table of keys. Each part is defined in its own key_table_*.cpp file.
namespace poinsot::scene {

using Put = decltype(Key::put);

// Moments of inertia. The range is far wider than necessary for any body, but L^2 (below 1e201) and T neither
// underflow nor overflow a double.
constexpr Range kMoments{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kMasses{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kSpins{.least = kLeastSpin, .most = kMostSpin, .ofSize = true};  // a component may also be 0
constexpr double kLongestUnit = 40;                                              // characters; no unit needs more
constexpr Range kFullTurns{.least = -360, .most = 360, .unit = "deg"};
constexpr Range kInstants{.least = -kMostInstant_s, .most = kMostInstant_s};  // time times spin does not overflow
constexpr Range kExtent{.least = 1e-12, .most = 1e12};                        // the renderer uses floats
constexpr Range kPositions{.least = 1e-12, .most = 1e12, .ofSize = true};
constexpr Range kQuaternionNorm{.least = 1e-6, .most = 1e6};
constexpr Range kPathLength{.least = 0, .most = 200};  // characters; a message can show the complete path

std::vector<Key> bodyKeys();
std::vector<Key> markKeys();
std::vector<Key> motionKeys();
std::vector<Key> forcingKeys();
std::vector<Key> timeKeys();
std::vector<Key> cameraKeys();
std::vector<Key> framesKeys();
std::vector<Key> showKeys();
std::vector<Key> shownKeys();  ///< keys of [show] that each view can set for itself
std::vector<Key> viewKeys();
std::vector<Key> labelKeys();
std::vector<Key> namedKeys();
std::vector<Key> plotKeys();
std::vector<Key> noteKeys();  ///< keys of [[readout]] and [[note]]
std::vector<Key> timelineKeys();
std::vector<Key> styleKeys();
std::vector<Key> outputKeys();

// Column or row of a panel, and number of columns and rows. More than 8 x 8 panels would be too small to see.
constexpr Range kCellNumber{.least = 0, .most = 7};
constexpr Range kCellCount{.least = 1, .most = 8};

Key cellKey(std::string path, Range range, std::string_view example, std::string_view help, Put put);

std::vector<std::string_view> quantityWords();

/// Table that contains the keys of a shape, with the member of the draft that stores them and the help texts.
struct ShapeTable {
  std::string path;  ///< path such as "body", "body.part[]", "show.body"
  ShapeDraft& (*of)(Draft&, std::size_t element);
  std::string_view shapeHelp, sizeHelp;
};

std::vector<Key> shapeKeys(const ShapeTable& table);

/// Table that selects the contents of a picture: [show], or the same table in a view.
struct ShowTable {
  std::string path;
  Show& (*of)(Draft&, std::size_t element);
};

std::vector<Key> figureKeys(const ShowTable& table);

std::vector<Key> joined(std::vector<std::vector<Key>> parts);

}  // namespace poinsot::scene

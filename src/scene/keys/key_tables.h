// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/limits.h"

/// Parts of the table of keys, one file each, and their shared definitions.
namespace poinsot::scene {

using Put = decltype(Key::put);

// Ranges that several tables share, each with its reason.

// Far beyond any body, and narrow enough that L^2 (below 1e201) and T neither underflow nor overflow a double.
constexpr Range kMoments{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kMasses{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kSpins{.least = kLeastSpin, .most = kMostSpin, .ofSize = true};  // each component may be zero
constexpr double kLongestUnit = 40;                                              // characters; no unit needs more
constexpr Range kInstants{.least = -kMostInstant_s, .most = kMostInstant_s};     // keeps time times spin in range
constexpr Range kExtent{.least = 1e-12, .most = 1e12};                           // drawn coordinates end as floats
constexpr Range kPositions{.least = 1e-12, .most = 1e12, .ofSize = true};
constexpr Range kQuaternionNorm{.least = 1e-6, .most = 1e6};
constexpr Range kPathLength{.least = 0, .most = 200};  // short enough to be shown whole in a message

std::vector<Key> bodyKeys();
std::vector<Key> motionKeys();
std::vector<Key> forcingKeys();
std::vector<Key> timeKeys();
std::vector<Key> cameraKeys();
std::vector<Key> framesKeys();
std::vector<Key> showKeys();
std::vector<Key> shownKeys();  ///< keys of [show] that each view may set for itself
std::vector<Key> viewKeys();
std::vector<Key> labelKeys();
std::vector<Key> namedKeys();
std::vector<Key> plotKeys();
std::vector<Key> noteKeys();  ///< keys of [[readout]] and [[note]]
std::vector<Key> timelineKeys();
std::vector<Key> styleKeys();
std::vector<Key> outputKeys();

// Numbers of columns and rows. More panels than 8 x 8 would be too small to see.
constexpr Range kCellNumber{.least = 0, .most = 7};
constexpr Range kCellCount{.least = 1, .most = 8};

Key cellKey(std::string path, Range range, std::string_view example, std::string_view help, Put put);

std::vector<std::string_view> quantityWords();

/// Table with the keys of a shape: where it stores them, and its help texts.
struct ShapeTable {
  std::string path;  ///< "body", "body.part[]", "show.body"
  ShapeDraft& (*of)(Draft&, std::size_t element);
  std::string_view shapeHelp, sizeHelp;
};

std::vector<Key> shapeKeys(const ShapeTable& table);

/// Table that selects the contents of a picture: "show".
struct ShowTable {
  std::string path;
  Show& (*of)(Draft&, std::size_t element);
};

std::vector<Key> figureKeys(const ShowTable& table);

std::vector<Key> joined(std::vector<std::vector<Key>> parts);

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/keys/keys.h"
#include "scene/limits.h"

/// The parts of the table of keys, one file each, and what they share.
namespace poinsot::scene {

using Put = decltype(Key::put);

// Ranges, each with its reason; those that one table uses stand there.

// Far beyond any body, and so that L^2 (below 1e201) and T neither under- nor overflow a double.
constexpr Range kMoments{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kMasses{.least = kLeastMoment, .most = kMostMoment};
constexpr Range kSpins{.least = kLeastSpin, .most = kMostSpin, .ofSize = true};  // each part may be zero
constexpr double kLongestUnit = 40;                                              // characters: beyond any
constexpr Range kInstants{.least = -kMostInstant_s, .most = kMostInstant_s};     // times the spin it is an angle
constexpr Range kExtent{.least = 1e-12, .most = 1e12};  // what is drawn is cast to float in the end
constexpr Range kPositions{.least = 1e-12, .most = 1e12, .ofSize = true};
constexpr Range kQuaternionNorm{.least = 1e-6, .most = 1e6};
constexpr Range kPathLength{.least = 0, .most = 200};  // what a message shows whole

std::vector<Key> bodyKeys();
std::vector<Key> motionKeys();
std::vector<Key> forcingKeys();
std::vector<Key> timeKeys();
std::vector<Key> cameraKeys();
std::vector<Key> framesKeys();
std::vector<Key> showKeys();
std::vector<Key> shownKeys();  ///< those of [show] that each view may give for itself
std::vector<Key> viewKeys();
std::vector<Key> labelKeys();
std::vector<Key> namedKeys();
std::vector<Key> plotKeys();
std::vector<Key> noteKeys();  ///< of [[readout]] and [[note]]
std::vector<Key> timelineKeys();
std::vector<Key> styleKeys();
std::vector<Key> outputKeys();

// Two numbers of columns and rows: more panels than 8 x 8 are too small to be looked at.
constexpr Range kCellNumber{.least = 0, .most = 7};
constexpr Range kCellCount{.least = 1, .most = 8};

/// "at" or "span" of a panel's table.
Key cellKey(std::string path, Range range, std::string_view example, std::string_view help, Put put);

/// The names of stateQuantities(), in their order.
std::vector<std::string_view> quantityWords();

/// Where a table with the keys of a shape keeps them, and what is to be said of them there.
struct ShapeTable {
  std::string path;  ///< "body", "body.part[]", "show.body"
  ShapeDraft& (*of)(Draft&, std::size_t element);
  std::string_view shapeHelp, sizeHelp;
};

std::vector<Key> shapeKeys(const ShapeTable& table);

/// A table that says what a picture shows: "show".
struct ShowTable {
  std::string path;
  Show& (*of)(Draft&, std::size_t element);
};

std::vector<Key> figureKeys(const ShowTable& table);

std::vector<Key> joined(std::vector<std::vector<Key>> parts);

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/picture_diff.h"

namespace poinsot::app {

/// A row of the page, and what is shown when it is chosen.
struct DiffPageEntry {
  /// The bytes of a PNG file; none for none.
  using Png = std::string;

  std::string name, status, message;
  PictureDiff diff;
  bool hasFigures = false;                               ///< whether diff.figures were made
  double pixelsPerDegree = image::kFlipPixelsPerDegree;  ///< of them
  /// Terms, and what is to be said of them; figures stand before them.
  std::vector<std::pair<std::string, std::string>> facts = {};
  Png reference = {}, actual = {}, difference = {}, map = {};
};

/// A curve over time above the table: a picture on which entries are places.
struct DiffPageCurve {
  std::string svg;
  double left = 0, right = 1;           ///< its first and its last moment, as shares of the picture's width
  std::vector<double> placesOfEntries;  ///< between 0, the first moment, and 1; of the entries in their order
};

/// Pictures beside those that they are compared with.
struct DiffPage {
  std::string title, verdict;
  std::string reference = "reference", actual = "test";  ///< what the two are called
  std::string entry = "Picture";                         ///< what a row is called
  std::string note = {};                                 ///< beside the title; empty for none
  std::string counts = {};                               ///< where entries are not all that was compared
  std::vector<DiffPageEntry> entries = {};
  std::optional<DiffPageCurve> curve = {};

  /// Whether pictures may be added: browsers do not read a script of half a gigabyte. Of entries for which there
  /// is no room, say so in the facts.
  bool hasRoom() const;
};

/// A file, as it is. @throws core::Error(kIo), or (kLimit) above 512 MiB.
DiffPageEntry::Png pngFile(const std::filesystem::path& file);

/// One page of HTML that needs nothing else: pictures, style and script are in it, and it loads nothing. A table
/// that can be sorted; of each entry both pictures side by side, under a slider and blinking, their difference and
/// FLIP's map. Says of itself that this program made it.
std::string htmlOf(const DiffPage& page);

}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/picture_diff.h"
#include "output/file_kind.h"

namespace poinsot::compare {

/// Terms with their texts.
using DiffPageFacts = std::vector<std::pair<std::string, std::string>>;

/// A picture that the page embeds, or loads from a file.
struct DiffPagePicture {
  std::string png;                  ///< bytes to embed; empty if the page loads the file
  std::filesystem::path file = {};  ///< empty if there is none
};

/// A row of the page, and what is shown when it is chosen.
struct DiffPageEntry {
  std::string name, status, message;
  PictureDiff diff;
  bool hasFigures = false;                        ///< whether diff.figures were made
  double pixelsPerDegree = kFlipPixelsPerDegree;  ///< of them
  DiffPageFacts facts = {};                       ///< shown after the figures
  std::string approve = {};  ///< argument of DiffPage::approve for this row; empty if it cannot be approved
  DiffPagePicture reference = {}, actual = {}, map = {};
};

/// A curve over time above the rows: a picture on which entries are places.
struct DiffPageCurve {
  std::string svg;
  double left = 0, right = 1;           ///< its first and its last moment, as shares of the picture's width
  std::vector<double> placesOfEntries;  ///< between 0, the first moment, and 1; of the entries in their order
};

/// Pictures beside those that they are compared with.
struct DiffPage {
  std::string title, verdict;
  std::string reference = "reference", actual = "test";  ///< names of the two
  std::string entry = "Picture";                         ///< name of a row
  std::string note = {};                                 ///< beside the title; empty for none
  std::string counts = {};                               ///< where entries are not all that was compared
  std::string first = {};           ///< name of the row that is chosen at first; empty for the first in order
  std::filesystem::path file = {};  ///< of the page: files of pictures are named from its folder
  DiffPageFacts run = {};           ///< what identifies the run
  std::string approve = {};         ///< command that approves the rows whose arguments follow; empty for none
  std::vector<DiffPageEntry> entries = {};
  std::optional<DiffPageCurve> curve = {};
};

/// Bounds what a page embeds: pictures of 100 rows, or 50 MB.
class EmbedBudget {
 public:
  bool isSpent() const { return isSpent_; }

  /// Counts the bytes of a row's pictures. If they do not fit, drops them, so that the page loads the files, and
  /// nothing fits any more.
  void admit(DiffPageEntry& entry);

 private:
  bool isSpent_ = false;
  std::size_t rows_ = 0, bytes_ = 0;
};

/// Returns the rows that are not identical in the order in which the budget is spent on them.
std::vector<DiffPageEntry*> worstFirst(std::vector<DiffPageEntry>& entries);

/// Reads the files of a row's pictures, to embed them. A picture that cannot be read is left out.
void embedFiles(DiffPageEntry& entry);

/// Returns a page of HTML that frames what changed, magnifies it and approves nothing by itself. Style, script and
/// embedded pictures are in it; it loads the other pictures and nothing else. A comment marks it as poinsot's own.
std::string htmlOf(const DiffPage& page);

/// Pages of this program.
output::FileKind reportKind();

}  // namespace poinsot::compare

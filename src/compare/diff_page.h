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

using DiffPageFacts = std::vector<std::pair<std::string, std::string>>;

struct DiffPagePicture {
  std::string png;  ///< PNG to embed; if empty, the page loads `file`
  std::filesystem::path file = {};
};

/// Row of the page, with the details that the page shows when the row is selected.
struct DiffPageEntry {
  std::string name, status, message;
  PictureDiff diff;
  bool hasFigures = false;                        ///< whether diff.figures are valid
  double pixelsPerDegree = kFlipPixelsPerDegree;  ///< resolution for which the FLIP figures hold
  DiffPageFacts facts = {};
  std::string approve = {};  ///< argument to DiffPage::approve for this row; empty if not approvable
  DiffPagePicture reference = {}, actual = {}, map = {};
};

/// Curve over time above the rows, on which each entry has a position.
struct DiffPageCurve {
  std::string svg;
  double left = 0, right = 1;           ///< ends of the time axis, as fractions of the width
  std::vector<double> placesOfEntries;  ///< position of each entry, from 0 (left) to 1 (right)
};

/// Content of a page that shows pictures beside their references.
struct DiffPage {
  std::string title, verdict;
  std::string reference = "reference", actual = "test";  ///< labels of the two pictures
  std::string entry = "Picture";                         ///< word for a row, such as "Frame"
  std::string note = {};
  std::string counts = {};          ///< summary, if the entries are not all that was compared
  std::string first = {};           ///< name of the initially selected row; empty for the first
  std::filesystem::path file = {};  ///< the page's file, to which links are relative
  DiffPageFacts run = {};
  std::string approve = {};  ///< command that approves rows, without their arguments; may be empty
  std::vector<DiffPageEntry> entries = {};
  std::optional<DiffPageCurve> curve = {};
};

/// Limit for the pictures that a page embeds: 100 rows and 50 MB.
class EmbedBudget {
 public:
  bool isSpent() const { return isSpent_; }

  /// Counts the bytes of a row's pictures. If the budget does not suffice, drops the pictures of this row and of
  /// all later ones, so that the page loads their files.
  void admit(DiffPageEntry& entry);

 private:
  bool isSpent_ = false;
  std::size_t rows_ = 0, bytes_ = 0;
};

/// Returns the rows that are not identical, the worst first; the budget is spent in this order.
std::vector<DiffPageEntry*> worstFirst(std::vector<DiffPageEntry>& entries);

/// Reads the files of a row's pictures in order to embed them. Unreadable pictures are dropped.
void embedFiles(DiffPageEntry& entry);

/// Returns an HTML page that outlines and magnifies the changes. The page contains style, script and embedded
/// pictures, and loads only the other pictures. The page cannot approve anything by itself. A comment marks it as
/// poinsot's own.
std::string htmlOf(const DiffPage& page);

output::FileKind reportKind();

}  // namespace poinsot::compare

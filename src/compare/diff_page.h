// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "compare/approval_files.h"
#include "compare/picture_diff.h"
#include "output/file_kind.h"

namespace poinsot::compare {

using DiffPageFacts = std::vector<std::pair<std::string, std::string>>;

struct DiffPagePicture {
  std::string png;  ///< bytes of the PNG to embed; if empty, the page loads `file`
  std::filesystem::path file = {};
};

/// Row of the page, with the details that the page shows when a user selects the row.
struct DiffPageEntry {
  std::string name, status, message;
  PictureDiff diff;
  bool hasFigures = false;                        ///< whether diff.figures are valid
  double pixelsPerDegree = kFlipPixelsPerDegree;  ///< visual resolution of the FLIP figures
  DiffPageFacts facts = {};
  std::string approve = {};  ///< argument that approves this row; empty if impossible
  std::vector<ApprovalFile> approval = {};
  DiffPagePicture reference = {}, actual = {}, map = {};
};

/// Diagram over time, shown above the rows. Each row has a position on the time axis.
struct DiffPageCurve {
  std::string svg;
  double left = 0, right = 1;           ///< ends of the time axis, as fractions of the diagram's width
  std::vector<double> placesOfEntries;  ///< position of each row, from 0 (left) to 1 (right)
};

/// Content of an HTML page that shows pictures next to their references.
struct DiffPage {
  std::string title, verdict;
  std::string reference = "reference", actual = "test";  ///< labels of the two pictures
  std::string entry = "Picture";                         ///< word for a row, such as "Frame"
  std::string note = {};
  std::string counts = {};          ///< summary of all frames, if only some frames have a row
  std::string first = {};           ///< name of the row to select first; empty for the first row
  std::filesystem::path file = {};  ///< the page's own file, to which links are relative
  DiffPageFacts run = {};
  std::string approve = {};         ///< command to which a row's `approve` is appended; may be empty
  std::filesystem::path root = {};  ///< folder to which the paths of approvals are relative
  std::vector<DiffPageEntry> entries = {};
  std::optional<DiffPageCurve> curve = {};
};

/// Limit for the pictures that a page embeds: 100 rows and 50 MB.
class EmbedBudget {
 public:
  bool isSpent() const { return isSpent_; }

  /// Adds the size of a row's pictures to the total. If the limit is exceeded, drops the embedded pictures of this
  /// row and of all later rows. The page then loads the files of these rows instead.
  void admit(DiffPageEntry& entry);

 private:
  bool isSpent_ = false;
  std::size_t rows_ = 0, bytes_ = 0;
};

/// Returns the rows whose pictures are not identical, the worst first. Pictures are embedded in this order.
std::vector<DiffPageEntry*> worstFirst(std::vector<DiffPageEntry>& entries);

/// Reads a row's pictures from their files, so that the page embeds them. Leaves out unreadable pictures.
void embedFiles(DiffPageEntry& entry);

/// Returns an HTML page that outlines and magnifies the changes. Style, script and embedded pictures are part of
/// the page; only other pictures are loaded. The page cannot approve anything by itself. A comment in the page
/// identifies it as written by poinsot.
std::string htmlOf(const DiffPage& page);

output::FileKind reportKind();

}  // namespace poinsot::compare

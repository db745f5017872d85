// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/diff_page.h"
#include "compare/outcome.h"
#include "core/file_batch.h"

namespace poinsot::compare {

/// Texts and places of a page of outcomes.
struct OutcomePageHead {
  std::string title, verdict;
  std::string note = {};                                 ///< beside the title; empty for none
  std::string reference = "reference", actual = "test";  ///< names of the two pictures
  std::string entry = "Picture";                         ///< name of a row
  std::filesystem::path page = {};                       ///< file that it is written to
  std::filesystem::path place = {};                      ///< in the work tree whose commit is named
  std::string approve = {};  ///< command that approves the rows whose names follow; empty for none
  double pixelsPerDegree = kFlipPixelsPerDegree;
  bool exact = false;                        ///< whether identical pixels that are stored in another way fail
  const core::FileBatch* unnamed = nullptr;  ///< holds maps of this run that have no names yet
};

/// A page without rows.
DiffPage pageOf(const OutcomePageHead& head);

/// A row without embedded pictures. An identical pair names one of its files.
DiffPageEntry entryOf(const Outcome& outcome, const OutcomePageHead& head);

/// Embeds two compared pictures, and FLIP's map of them.
void embedCompared(DiffPageEntry& entry, const ComparedPictures& compared);

/// The outcomes as a page (diff_page.h). Embeds the pictures of the worst outcomes as far as EmbedBudget allows,
/// of films the worst frame, and names the files of the others. Maps that no file has are made, `jobs` at a time.
/// @throws core::Error(kIo), or (kLimit).
std::string outcomePage(const std::vector<Outcome>& outcomes, const OutcomePageHead& head, int jobs);

}  // namespace poinsot::compare

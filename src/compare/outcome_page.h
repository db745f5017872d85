// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/diff_page.h"
#include "compare/outcome.h"
#include "core/file_batch.h"

namespace poinsot::compare {

struct OutcomePageHead {
  std::string title, verdict;
  std::string note = {};
  std::string reference = "reference", actual = "test";
  std::string entry = "Picture";
  std::filesystem::path page = {};
  std::filesystem::path place = {};  ///< path in the work tree whose commit the page shows
  std::string approve = {};          ///< command that approves rows, without their names; may be empty
  double pixelsPerDegree = kFlipPixelsPerDegree;
  bool exact = false;                        ///< whether equal pixels in another storage format fail
  const core::FileBatch* unnamed = nullptr;  ///< maps of this run that are not committed yet
};

DiffPage pageOf(const OutcomePageHead& head);

/// Returns a row without embedded pictures. For an identical pair, the row names only the reference.
DiffPageEntry entryOf(const Outcome& outcome, const OutcomePageHead& head);

void embedCompared(DiffPageEntry& entry, const ComparedPictures& compared);

/// Returns the outcomes as an HTML page (diff_page.h). The worst outcomes' pictures, of films the worst frame, are
/// embedded as far as EmbedBudget allows; the others' files are linked. Missing maps are computed, `jobs` at a
/// time.
/// @throws core::Error(kIo), or (kLimit).
std::string outcomePage(const std::vector<Outcome>& outcomes, const OutcomePageHead& head, int jobs);

}  // namespace poinsot::compare

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
  std::filesystem::path place = {};  ///< path in a git work tree; the page shows the tree's commit and patches it
  std::string approve = {};          ///< command that approves the rows whose names follow it; may be empty
  double pixelsPerDegree = kFlipPixelsPerDegree;
  bool exact = false;                        ///< whether pictures stored in different formats fail
  const core::FileBatch* unnamed = nullptr;  ///< maps of this run that are not committed yet
};

DiffPage pageOf(const OutcomePageHead& head);

/// Returns the row of an outcome, without embedded pictures. The row of an identical pair shows only the
/// reference.
DiffPageEntry entryOf(const Outcome& outcome, const OutcomePageHead& head);

void embedCompared(DiffPageEntry& entry, const ComparedPictures& compared);

/// Returns the outcomes as an HTML page (diff_page.h). Embeds the pictures of the worst outcomes, as far as
/// EmbedBudget allows; the page loads the files of the other outcomes. Shows films by their worst frame. Computes
/// missing maps, `jobs` at a time.
/// @throws core::Error(kIo), or (kLimit).
std::string outcomePage(const std::vector<Outcome>& outcomes, const OutcomePageHead& head, int jobs);

}  // namespace poinsot::compare

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "picture_source.h"

namespace poinsot::python {

/// Result of one comparison in pytest.
struct GoldenRow {
  std::string name, status, message;       ///< status as compare::toString(OutcomeStatus), or "approved"
  std::filesystem::path place;             ///< file of the baseline, also if it does not exist yet
  std::filesystem::path baseline, actual;  ///< empty if there is none
  RuleWords rule;
  std::vector<std::vector<double>> ignore;  ///< boxes: left, top, width, height; pixels
  std::filesystem::path mask;               ///< empty if there is none
};

/// Outcomes of a run as texts: as a JSON object in the form of `golden --json`, and as a table in Markdown.
struct GoldenTexts {
  std::string json, markdown;
};

/// Writes the HTML page of a run. Compares pictures that are not identical again, to get figures and maps.
/// @returns the same outcomes as texts
/// @param place  folder in a git work tree; the page shows the tree's commit
/// @param jobs  pictures compared at a time
/// @throws core::Error(kIo) if the page cannot be written
GoldenTexts writeGoldenReport(const std::filesystem::path& page, const std::string& title,
                              const std::filesystem::path& place, const std::vector<GoldenRow>& rows, int jobs);

}  // namespace poinsot::python

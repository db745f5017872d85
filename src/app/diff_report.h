// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/film_diff.h"
#include "app/folder_diff.h"

/// Results of a comparison as a page (diff_page.h). All throw core::Error(kIo), or (kLimit), where a picture
/// cannot be read again.
namespace poinsot::app {

/// The two things compared, the request and the page that reports on them.
struct DiffSubject {
  std::filesystem::path reference, test;
  const DiffRequest& request;
  std::filesystem::path page;
};

std::string diffReport(const ComparedPictures& compared, const DiffSubject& subject);

/// Embeds the pictures of the worst pairs that are not identical, as far as EmbedBudget allows, and names the
/// files of the others. `jobs` pairs at a time are read again.
std::string diffReport(const FolderDiff& diff, const DiffSubject& subject, int jobs);

/// Shows the curve over time and, of each twentieth of the film, the worst frame that is not identical.
std::string diffReport(const FilmDiff& diff, const DiffSubject& subject);

}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "app/film_diff.h"
#include "app/folder_diff.h"

/// What came of comparing as a page (diff_page.h). All throw core::Error(kIo), or (kLimit), where a picture cannot
/// be read again.
namespace poinsot::app {

/// What was compared with what, and how.
struct DiffSubject {
  std::filesystem::path reference, test;
  const DiffRequest& request;
};

std::string diffReport(const ComparedPictures& compared, const DiffSubject& subject);

/// Pairs that are not identical have their pictures; of more than a hundred, or than a page can hold, the worst.
/// `jobs` at a time are read again.
std::string diffReport(const FolderDiff& diff, const DiffSubject& subject, int jobs);

/// The curve over time and, of each twentieth of the film, the worst frame that is not identical.
std::string diffReport(const FilmDiff& diff, const DiffSubject& subject);

}  // namespace poinsot::app

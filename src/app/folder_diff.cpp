// SPDX-License-Identifier: Apache-2.0
#include "app/folder_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>

#include "app/file_diff.h"
#include "app/parallel.h"
#include "core/error.h"
#include "core/text.h"
#include "output/atomic_file.h"
#include "output/film_reader.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;
using core::Error;
using core::ErrorKind;

/// Names of the PNG files and films beneath a folder, from there; sorted. Hidden ones are left out.
/// @param links  gets the links to folders, which are not followed
std::vector<std::string> namesIn(const fs::path& folder, std::vector<std::string>& links) {
  std::vector<std::string> names;
  std::error_code failure;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const bool hidden = entry->path().filename().native().starts_with('.');
    if (hidden) entry.disable_recursion_pending();
    if (!hidden && entry->is_symlink(failure) && entry->is_directory(failure))
      links.push_back((folder / entry->path().lexically_relative(folder)).native());
    if (!hidden && output::isPictureOrFilmName(entry->path()) && entry->is_regular_file(failure))
      names.push_back(entry->path().lexically_relative(folder).native());
  }
  if (failure)
    throw Error(ErrorKind::kIo, fmt::format("{}: {}", core::printable(folder.native()), failure.message()));
  std::sort(names.begin(), names.end());
  return names;
}

/// The request for one pair: places for its pictures in the folders.
DiffRequest requestFor(const DiffRequest& request, const std::string& name) {
  DiffRequest own = request;
  for (auto* place : {&own.map, &own.difference})
    if (*place) *place = **place / name;
  return own;
}

/// Identical pairs leave no picture.
PictureDiff diffPair(const fs::path& reference, const fs::path& test, const std::string& name,
                     const DiffRequest& request) {
  const DiffRequest own = requestFor(request, name);
  ComparedPictures compared = compareFiles(reference / name, test / name, own);
  compared.diff.name = name;
  if (compared.diff.verdict == image::Verdict::kIdentical) {
    forgetMaps(own);
    return std::move(compared.diff);
  }
  for (const auto& place : {own.map, own.difference})
    if (place && compared.diff.hasFigures) output::makeFolders(place->parent_path());
  writeMaps(compared, own);
  return std::move(compared.diff);
}

}  // namespace

image::Verdict FolderDiff::verdict() const {
  image::Verdict worst = image::Verdict::kIdentical;
  if (!onlyInReference.empty() || !onlyInTest.empty()) worst = image::Verdict::kDifferent;
  for (const PictureDiff& picture : pictures) worst = std::max(worst, picture.verdict);
  return worst;
}

FolderDiff diffFolders(const fs::path& reference, const fs::path& test, const DiffRequest& request, int jobs) {
  FolderDiff diff;
  const auto ours = namesIn(reference, diff.linkedFolders), theirs = namesIn(test, diff.linkedFolders);
  if (ours.empty() && theirs.empty())
    throw Error(ErrorKind::kUsage,
                fmt::format("{} and {}: no PNG file and no film is there", core::printable(reference.native()),
                            core::printable(test.native())));
  std::vector<std::string> both;
  std::ranges::set_intersection(ours, theirs, std::back_inserter(both));
  std::ranges::set_difference(ours, theirs, std::back_inserter(diff.onlyInReference));
  std::ranges::set_difference(theirs, ours, std::back_inserter(diff.onlyInTest));
  diff.pictures.resize(both.size());
  std::vector<std::optional<Error>> errors(both.size());
  forEachIndex(both.size(), jobs, [&](std::size_t i) {
    try {
      diff.pictures[i] = diffPair(reference, test, both[i], request);
    } catch (const Error& error) {
      diff.pictures[i] = unreadablePair(error);
      diff.pictures[i].name = both[i];
      errors[i] = error;
    }
  });
  for (auto& error : errors) {
    if (error && !diff.firstError) diff.firstError = std::move(error);
  }
  return diff;
}

}  // namespace poinsot::app

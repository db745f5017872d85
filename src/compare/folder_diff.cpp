// SPDX-License-Identifier: Apache-2.0
#include "compare/folder_diff.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <system_error>

#include "compare/file_diff.h"
#include "core/atomic_file.h"
#include "core/file_error.h"
#include "core/parallel.h"
#include "core/text.h"
#include "output/film_reader.h"

namespace poinsot::compare {
namespace {

namespace fs = std::filesystem;
using core::Error;
using core::ErrorKind;

/// Returns the relative paths of the PNG files and films below a folder, sorted. Skips hidden files and folders.
/// @param links  receives the links to folders, which are not followed
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
    throw core::FileError(ErrorKind::kIo,
                          fmt::format("{}: {}", core::printable(folder.native()), failure.message()), folder,
                          failure.value());
  std::sort(names.begin(), names.end());
  return names;
}

/// Adds the maps of a pair to the batch. If the pair is identical, adds the removal of earlier maps instead.
void addPairMaps(core::FileBatch& maps, const ComparedPictures& compared, const DiffRequest& own) {
  if (compared.diff.verdict == Verdict::kIdentical) return addRemovalOfMaps(maps, own);
  for (const auto& place : {own.map, own.difference})
    if (place && compared.diff.hasFigures) core::makeFolders(place->parent_path());
  addMaps(maps, compared, own);
}

}  // namespace

FolderNames namesInFolders(const fs::path& reference, const fs::path& test) {
  FolderNames names;
  const auto ours = namesIn(reference, names.linkedFolders), theirs = namesIn(test, names.linkedFolders);
  if (ours.empty() && theirs.empty())
    throw core::usageError(fmt::format("{} and {}: neither folder contains a PNG file or a film",
                                       core::printable(reference.native()), core::printable(test.native())));
  std::ranges::set_intersection(ours, theirs, std::back_inserter(names.inBoth));
  std::ranges::set_difference(ours, theirs, std::back_inserter(names.onlyInReference));
  std::ranges::set_difference(theirs, ours, std::back_inserter(names.onlyInTest));
  return names;
}

DiffRequest requestForPair(const DiffRequest& request, const std::string& name) {
  DiffRequest own = request;
  for (auto* place : {&own.map, &own.difference})
    if (*place) *place = **place / name;
  return own;
}

Verdict FolderDiff::verdict() const {
  Verdict worst = Verdict::kIdentical;
  if (!names.onlyInReference.empty() || !names.onlyInTest.empty()) worst = Verdict::kDifferent;
  for (const PictureDiff& picture : pictures) worst = std::max(worst, picture.verdict);
  return worst;
}

FolderDiff diffFolders(const fs::path& reference, const fs::path& test, FolderNames names,
                       const DiffRequest& request, int jobs, core::FileBatch& maps) {
  FolderDiff diff;
  const std::vector<std::string>& both = names.inBoth;
  diff.pictures.resize(both.size());
  std::vector<std::optional<Error>> errors(both.size());
  std::vector<core::FileBatch> mapsOf(both.size());
  core::forEachIndex(both.size(), jobs, [&](std::size_t i) {
    const DiffRequest own = requestForPair(request, both[i]);
    ComparedPictures compared;
    try {
      compared = compareFiles(reference / both[i], test / both[i], own);
    } catch (const Error& error) {
      compared.diff = unreadablePair(error);
      errors[i] = error;
    }
    if (!errors[i]) addPairMaps(mapsOf[i], compared, own);
    diff.pictures[i] = std::move(compared.diff);
    diff.pictures[i].name = both[i];
  });
  for (auto& error : errors) {
    if (error && !diff.firstError) diff.firstError = std::move(error);
  }
  for (core::FileBatch& each : mapsOf) maps.add(std::move(each));
  diff.names = std::move(names);
  return diff;
}

}  // namespace poinsot::compare

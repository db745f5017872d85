// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/file_batch.h"

namespace poinsot::compare {

/// Approves new pictures of a page that htmlOf() wrote: adds the files of the chosen rows to a batch. A picture
/// that the page embeds is taken from the page, so that the page alone is enough; others are read beside it.
/// @param names  names of rows, in which * matches any characters
/// @param root  folder below which all files must be, see approvalRoot()
/// @returns text with one line per picture
/// @throws core::Error(kIo) if the page cannot be read, if a picture or a reference changed since the page was
///   written, or if a file is behind a link; (kUsage) if a name matches no row that can be approved
std::string approveOnPage(core::FileBatch& batch, const std::filesystem::path& page,
                          const std::vector<std::string>& names, const std::filesystem::path& root);

}  // namespace poinsot::compare

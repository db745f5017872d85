// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::compare {

/// Returns the git work tree around a path, or nullopt if there is none.
std::optional<std::filesystem::path> workTreeAround(const std::filesystem::path& place);

/// Returns the commit that is checked out in the git work tree around a path, in hexadecimal. Reads git's files
/// without running git. Returns an empty string if there is no work tree or no commit, or if a file cannot be
/// read.
std::string commitAround(const std::filesystem::path& place);

/// Returns facts that identify this run, as pairs of label and text: the date with its time zone, the commit
/// around `place`, the machine, the program and its command line. Leaves out facts that are not available.
std::vector<std::pair<std::string, std::string>> runFacts(const std::filesystem::path& place);

}  // namespace poinsot::compare

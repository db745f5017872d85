// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace poinsot::compare {

/// Returns the commit that is checked out in the git work tree around a file or folder, in hexadecimal. Reads
/// git's files without running git. Empty if there is no work tree, no commit yet, or a file cannot be read.
std::string commitAround(const std::filesystem::path& place);

/// Returns what identifies this run, as terms and texts: the date with its zone, the commit around `place`, the
/// machine, the program and its command line. Facts that are not available are left out.
std::vector<std::pair<std::string, std::string>> runFacts(const std::filesystem::path& place);

}  // namespace poinsot::compare

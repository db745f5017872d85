// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::figure {

/// Converts the TeX of a label to LaTeX. The result needs amsmath and is the same with or without babel and
/// siunitx. Characters beyond ASCII become commands if there is a command for them. Letters with marks that LaTeX
/// does not have become accent commands. Characters with a special meaning in LaTeX (% # & ") are escaped. Other
/// characters stay.
/// Only known commands are accepted, so that a label cannot make LaTeX read files or run programs.
/// @throws core::Error(kUsage) if the label itself cannot be set.
std::string latexOf(std::string_view tex);

/// Returns definitions, one per line, of the commands in `latex` that LaTeX with amsmath lacks. May be empty.
std::string latexDefinitionsFor(std::string_view latex);

}  // namespace poinsot::figure

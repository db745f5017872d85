// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::figure {

/// Converts a label's TeX to LaTeX with amsmath that does not depend on babel or siunitx. Characters beyond ASCII
/// become their command if they have one. Letters with marks that LaTeX lacks are spelled with accents, and
/// characters that LaTeX would interpret (% # & ") are spelled out. Other characters stay.
/// @throws core::Error(kUsage) if the label itself cannot be set. Only known commands pass, so that a label cannot
/// make LaTeX read files or run programs.
std::string latexOf(std::string_view tex);

/// Returns definitions, one a line, of the commands in `latex` that LaTeX with amsmath lacks. May be empty.
std::string latexDefinitionsFor(std::string_view latex);

}  // namespace poinsot::figure

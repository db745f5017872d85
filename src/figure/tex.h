// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace poinsot::figure {

/// A label's TeX as LaTeX with amsmath takes it, whatever babel or siunitx make of a character or a command:
/// characters beyond ASCII that have a command become that command, letters with marks that LaTeX lacks are
/// spelled with its accents, those that LaTeX would read as its own (% # & ") are spelled, the others stay.
/// @throws core::Error(kUsage) where the label itself cannot be set: what passes holds no command but the known
/// ones, so a label cannot make LaTeX read files or run programs.
std::string latexOf(std::string_view tex);

/// Definitions of the commands in `latex` that LaTeX with amsmath lacks, one a line; empty where there are none.
std::string latexDefinitionsFor(std::string_view latex);

}  // namespace poinsot::figure

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Output of the program. Data goes to stdout, where a failed write is an error. All else goes to stderr, where it
/// is not. Control characters from scenes, files and file names are replaced (core::printableLines).
namespace poinsot::cli {

/// Opens descriptors 0 to 2 if they are closed, so that no file opened later gets one of these numbers.
void openStandardStreams();

/// @throws core::BrokenPipe, or core::Error(kIo) if stdout takes no more.
void writeOut(std::string_view text);

void writeErr(std::string_view text);

/// Writes text with control characters to stderr. Use it only for text of this program.
void writeControl(std::string_view text);

/// Writes "poinsot: error: MESSAGE\n" to stderr; "error:" is red on a terminal, unless NO_COLOR is set.
void writeError(std::string_view message);

/// Reports on stderr that memory ran out, without allocating any.
void writeOutOfMemory() noexcept;

/// Returns whether stderr is a terminal that can redraw a line.
bool errIsTerminal();
int errColumns();

constexpr std::size_t kColumns = 100;  ///< width of text for a terminal

/// Breaks text at spaces into lines of at most `width` characters. Line ends in the text stay.
/// @param indent  number of spaces before each line except the first
/// @param column  number of characters that already stand on the first line
/// @returns the lines without a final line end
std::string wrapped(std::string_view paragraph, std::size_t width = kColumns, std::size_t indent = 0,
                    std::size_t column = 0);

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Output of the program. Data is written to stdout, where a failed write is an error. Messages are written to
/// stderr, where a failed write is ignored. Control characters in texts from outside are escaped
/// (core::printableLines).
namespace poinsot::cli {

/// Opens those of the descriptors 0 to 2 that are closed, so that no other file gets one of these numbers.
void openStandardStreams();

/// Writes text to stdout. @throws core::BrokenPipe, or core::Error(kIo) if writing fails.
void writeOut(std::string_view text);

void writeErr(std::string_view text);

/// Writes text to stderr without escaping control characters. Use it only for texts of this program.
void writeControl(std::string_view text);

/// Writes "poinsot: error: MESSAGE\n" to stderr. On a terminal, "error:" is red unless NO_COLOR is set.
void writeError(std::string_view message);

/// Writes an error message about lack of memory to stderr. Does not allocate memory.
void writeOutOfMemory() noexcept;

/// Returns whether stderr is a terminal that can redraw a line.
bool errIsTerminal();
int errColumns();

constexpr std::size_t kColumns = 100;  ///< default width of text on a terminal

/// Breaks text at spaces into lines of at most `width` characters. Keeps the newlines of the text.
/// @param indent  number of spaces before each line except the first
/// @param column  number of characters already printed on the first line
/// @returns the lines, without a newline at the end
std::string wrapped(std::string_view paragraph, std::size_t width = kColumns, std::size_t indent = 0,
                    std::size_t column = 0);

}  // namespace poinsot::cli

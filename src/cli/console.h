// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// The two streams: data to stdout, where a lost byte is an error; all else to stderr, where it is not. Whatever a
/// scene, a file or its name had in it, no control character gets through here (core::printableLines).
namespace poinsot::cli {

/// Descriptors 0 to 2 exist from here on: a file opened later cannot land on one of them.
void openStandardStreams();

/// @throws core::BrokenPipe, or core::Error(kIo) if stdout takes no more.
void writeOut(std::string_view text);

void writeErr(std::string_view text);

/// As it is: what this program itself has put control characters into, and no text of others.
void writeControl(std::string_view text);

/// "poinsot: error: MESSAGE\n" on stderr; the word in red on a terminal without NO_COLOR.
void writeError(std::string_view message);

/// That memory is out: takes none.
void writeOutOfMemory() noexcept;

/// Whether stderr is a terminal that can redraw a line, and how wide it is.
bool errIsTerminal();
int errColumns();

constexpr std::size_t kColumns = 100;  ///< of text for a terminal

/// Broken at spaces to lines of at most `width` characters, each but the first after `indent`; a line end stays
/// one. `column` characters stand before the first. Ends without a line end.
std::string wrapped(std::string_view paragraph, std::size_t width = kColumns, std::size_t indent = 0,
                    std::size_t column = 0);

}  // namespace poinsot::cli

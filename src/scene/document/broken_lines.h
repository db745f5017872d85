// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/abi.h"
#include "scene/document/source.h"
#include "scene/limits.h"

namespace poinsot::scene {

/// Lines that cannot be read because of a syntax error, both ends included.
struct BrokenLines {
  int first = 0, last = 0;
  std::string table;  ///< name of the top-level table to which the lines belong; empty if it is unknown
};

/// Returns the lines to leave out after a syntax error, so that the rest of the text keeps its meaning: one line,
/// all lines of an array, or a broken header with the whole table below it.
/// @param line  number of the line of the error
BrokenLines brokenLines(const Source& source, int line, const Limits& limits);

/// Returns the text with blank lines in place of broken lines. All other lines keep their numbers.
std::string withoutLines(const Source& source, const BrokenLines& broken);

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/sha256.h"
#include "output/ffmpeg_container.h"

/// Whether the bytes of a film are those that were written.
///
/// A film keeps the SHA-256 of its whole file, at the end of the text that names its origin. While the digest is
/// computed, its own digits are zeros. This covers every byte of every container that holds a text.
namespace poinsot::output {

/// Returns the text that a film keeps: its origin and its digest, or zeros until the digest is known.
std::string sealText(const std::string& origin, const core::Digest& digest = {});

/// Returns the origin from a text that holds a sealText(); empty if it holds none.
std::string originIn(std::string_view text);

/// Replaces the zeros in a film that holds sealText(origin) by its digest.
/// @throws core::Error(kIo) with the path if the film holds no such text, or cannot be read again or written.
void seal(core::AtomicFile& film, FileFormat format, const std::string& origin);

/// Compares a film with its digest. @returns kOther if the file holds no sealText(origin).
/// @throws core::Error(kIo) with the path if it cannot be read.
FilmState sealState(const std::filesystem::path& film, FileFormat format, const std::string& origin);

/// Returns whether the digest of any film stands in the file; false if it cannot be read.
bool bearsSeal(const std::filesystem::path& file);

}  // namespace poinsot::output

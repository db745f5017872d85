// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/sha256.h"
#include "output/ffmpeg_container.h"

/// Seal of a film: a digest that shows whether the film's bytes are those that were written.
///
/// A film stores the SHA-256 of its whole file at the end of the text that names its origin. While the digest is
/// computed, its own digits are zeros. The digest covers every byte of every container that holds a text.
namespace poinsot::output {

/// Returns the text that a film stores: its origin and its digest, or zeros until the digest is known.
std::string sealText(const std::string& origin, const core::Digest& digest = {});

/// Returns the origin from a text that holds a sealText(); empty if there is none.
std::string originIn(std::string_view text);

/// Replaces the zeros of sealText(origin) in a film by the film's digest.
/// @throws core::Error(kIo) with the path if the film holds no such text, or cannot be read again or written.
void seal(core::AtomicFile& film, FileFormat format, const std::string& origin);

/// Compares a film with its digest. @returns kOther if the file holds no sealText(origin).
/// @throws core::Error(kIo) with the path if the file cannot be read.
FilmState sealState(const std::filesystem::path& film, FileFormat format, const std::string& origin);

/// Returns whether the file holds the digest of any film; false if the file cannot be read.
bool bearsSeal(const std::filesystem::path& file);

}  // namespace poinsot::output

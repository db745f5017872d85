// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/sha256.h"
#include "output/ffmpeg_container.h"

/// Seal of a film: a digest that shows whether the film's bytes have changed since the film was written.
///
/// The seal is the SHA-256 digest of the whole file, at the end of the text that names the film's origin. The
/// digest is computed with zeros in place of its own digits. It covers every byte of every container that can
/// store a text.
namespace poinsot::output {

/// Returns the text that a film stores: its origin, then its digest. The digest is zeros until it is known.
std::string sealText(const std::string& origin, const core::Digest& digest = {});

/// Returns the origin from a text that contains a sealText(); empty if there is none.
std::string originIn(std::string_view text);

/// Computes the digest of a film, and stores it in place of the zeros of sealText(origin).
/// @throws core::Error(kIo) with the path if the film has no such text, or cannot be read again or written.
void seal(core::AtomicFile& film, FileFormat format, const std::string& origin);

/// Compares a film with its digest. @returns kOther if the file does not contain a sealText(origin).
/// @throws core::Error(kIo) with the path if the file cannot be read.
FilmState sealState(const std::filesystem::path& film, FileFormat format, const std::string& origin);

/// Returns whether the file contains the digest of any film; false if the file is unreadable.
bool bearsSeal(const std::filesystem::path& file);

}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
// The texts of films that libavformat writes none into: comments of a GIF, text chunks of an APNG, both before the
// pictures, so that a film which was cut still has them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "output/ffmpeg_container.h"

namespace poinsot::output {

/// Returns whether a file of this format takes its texts from insertTexts().
bool isAnimation(FileFormat format);

/// Returns a text as it stands in such a file: a comment extension, a text chunk.
std::string animationText(FileFormat format, const std::string& text);

/// Puts texts into a film that libavformat has written.
/// @throws core::Error(kIo) with the path.
void insertTexts(core::AtomicFile& film, FileFormat format, const std::vector<std::string>& texts);

/// Reads the texts of a .gif or an .apng.
/// @throws core::Error(kIo) with the path if there are none because the file is damaged, or no such film.
std::vector<std::string> animationTexts(const std::filesystem::path& file);

}  // namespace poinsot::output

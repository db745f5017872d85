// SPDX-License-Identifier: Apache-2.0
// Metadata texts of a GIF (comments) and of an APNG (text chunks), which libavformat cannot write. They are stored
// before the pictures, so that a truncated film still has them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/atomic_file.h"
#include "output/ffmpeg_container.h"

namespace poinsot::output {

/// Returns whether the format is GIF or APNG, whose texts insertTexts() writes.
bool isAnimation(FileFormat format);

/// Returns the bytes that store a text in the file: a comment extension in a GIF, an iTXt chunk in an APNG.
std::string animationText(FileFormat format, const std::string& text);

/// Inserts texts into a film that libavformat has written.
/// @throws core::Error(kIo) with the path.
void insertTexts(core::AtomicFile& film, FileFormat format, const std::vector<std::string>& texts);

/// Reads the texts of a .gif or an .apng.
/// @throws core::Error(kIo) with the path if the file is not such a film, or is damaged before its first text.
std::vector<std::string> animationTexts(const std::filesystem::path& file);

}  // namespace poinsot::output

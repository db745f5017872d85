// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"

namespace poinsot::app {

/// Returns the SHA-256 of a picture's size, channels and samples, in hexadecimal. It is the same before a picture
/// is written as PNG and after it is read again, however the file is compressed.
std::string pixelDigest(const image::AnyImage& picture);

/// Returns the same of a PNG file; of a film, the SHA-256 of the file.
/// @throws core::Error(kIo) if it cannot be read; (kLimit) as image::readPngAsStored().
std::string pixelDigestOf(const std::filesystem::path& file, bool isFilm);

}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "image/image.h"

namespace poinsot::image {

/// Returns the SHA-256 of a picture's size, channels and samples, in hexadecimal. It is the same before a picture
/// is written as PNG and after it is read again, however the file is compressed.
std::string pixelDigest(const AnyImage& picture);

}  // namespace poinsot::image

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "image/image.h"

namespace poinsot::image {

/// Returns the SHA-256 of a picture's size, channels and samples, in hexadecimal. A picture that is written as PNG
/// and read back has the same digest, whatever its compression.
std::string pixelDigest(const AnyImage& picture);

}  // namespace poinsot::image

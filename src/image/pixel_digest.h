// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "image/image.h"

namespace poinsot::image {

/// Returns the SHA-256 of a picture's size, channels and samples, in hexadecimal. The digest is the same before a
/// picture is written as PNG and after it is read back, regardless of the compression.
std::string pixelDigest(const AnyImage& picture);

}  // namespace poinsot::image

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace poinsot::output {

/// Takes x264's note about itself (its version and every option, as an SEI message with its UUID) out of an H.264
/// byte stream (Annex B), in place. Nothing else is touched.
/// @param note  receives the text that was taken out, if any.
/// @returns the new length.
std::size_t removeEncoderNote(std::span<std::uint8_t> stream, std::string* note = nullptr);

}  // namespace poinsot::output

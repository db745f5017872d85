// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace poinsot::output {

/// Removes x264's note about itself from an H.264 byte stream (Annex B), in place. The note is an SEI message with
/// x264's UUID, which contains the version and every option. Other bytes do not change.
/// @param note  receives the removed text, if any.
/// @returns the new length.
std::size_t removeEncoderNote(std::span<std::uint8_t> stream, std::string* note = nullptr);

}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

/// JSON that may have been written by anyone: what lies in a work folder or beside a reference picture.
namespace poinsot::core {

/// Enough for the job of a film with all the captions that a scene of 4 MiB holds, each character escaped, and for
/// the record of a segment of 10 000 frames, each with a name of 255 bytes. In memory such a file takes up to ten
/// times as much.
inline constexpr std::size_t kMostJsonBytes = std::size_t{8} << 20;
/// Objects and arrays in one another; ours have three.
inline constexpr int kDeepestJson = 16;

/// @throws core::Error(kIo) for what is no JSON or nested deeper than that.
nlohmann::ordered_json parseJson(std::string_view text);

/// Of a regular file. @throws as parseJson(); core::Error(kIo) also if it cannot be read, core::Error(kLimit) if
/// it has more than `mostBytes`.
nlohmann::ordered_json readJson(const std::filesystem::path& file, std::size_t mostBytes = kMostJsonBytes);

/// @throws core::Error(kIo) unless it is a whole number of at most 63 bits: of others, the library's conversion is
/// undefined or takes what is left of them.
std::int64_t wholeNumber(const nlohmann::ordered_json& json);

/// Returns the text of a JSON document, indented by one space and ended by a newline. Bytes that are not UTF-8, as
/// in file names, are replaced.
std::string jsonText(const nlohmann::ordered_json& json);

std::string utf8FromBytes(const std::string& bytes);
/// @pre made by utf8FromBytes().
std::string bytesFromUtf8(const std::string& utf8);

}  // namespace poinsot::core

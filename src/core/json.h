// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

/// JSON from untrusted sources, such as files in a work folder or beside a reference picture.
namespace poinsot::core {

/// Size limit of a file. The limit is enough for the job of a film with all captions of a 4 MiB scene, each
/// character escaped, and for the record of a segment of 10 000 frames with names of 255 bytes. Parsed, such a
/// file takes up to ten times as much memory.
inline constexpr std::size_t kMostJsonBytes = std::size_t{8} << 20;
/// Limit on nested objects and arrays; files of this program have three levels.
inline constexpr int kDeepestJson = 16;

/// Parses JSON text. @throws core::Error(kIo) if the text is not JSON, or is nested deeper than kDeepestJson.
nlohmann::ordered_json parseJson(std::string_view text);

/// Reads and parses a regular file.
/// @throws core::Error(kIo) as parseJson(), or if the file cannot be read; kLimit if it exceeds `mostBytes`
nlohmann::ordered_json readJson(const std::filesystem::path& file, std::size_t mostBytes = kMostJsonBytes);

/// Converts a JSON value to an integer, without the truncation of get<std::int64_t>().
/// @throws core::Error(kIo) unless the value is a whole number of at most 63 bits
std::int64_t wholeNumber(const nlohmann::ordered_json& json);

/// Returns the text of a JSON document, indented by one space and ended by a newline. Replaces bytes that are not
/// UTF-8, as in file names.
std::string jsonText(const nlohmann::ordered_json& json);

std::string utf8FromBytes(const std::string& bytes);
/// Reverses utf8FromBytes(), which encodes each byte as one character. @pre made by utf8FromBytes().
std::string bytesFromUtf8(const std::string& utf8);

}  // namespace poinsot::core

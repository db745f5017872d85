// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

/// Reader of JSON from untrusted sources, such as the files in a work folder.
namespace poinsot::core {

/// Default size limit of a JSON file. The limit is enough for the job of a film with all captions of a 4 MiB
/// scene, and for the record of a segment of 10 000 frames with names of 255 bytes. A parsed file takes up to ten
/// times as much memory.
inline constexpr std::size_t kMostJsonBytes = std::size_t{8} << 20;
/// Limit on the depth of nested objects and arrays. Files of this program have three levels.
inline constexpr int kDeepestJson = 16;

/// Parses JSON text. @throws core::Error(kIo) if the text is not JSON, or is nested deeper than kDeepestJson.
nlohmann::ordered_json parseJson(std::string_view text);

/// Reads and parses a regular file.
/// @throws core::Error(kIo) if the file cannot be read, or as parseJson(); core::Error(kLimit) if the file has
/// more than `mostBytes`
nlohmann::ordered_json readJson(const std::filesystem::path& file, std::size_t mostBytes = kMostJsonBytes);

/// Converts a JSON value to an integer. Rejects fractions, which get<std::int64_t>() would truncate.
/// @throws core::Error(kIo) unless the value is a whole number of at most 63 bits
std::int64_t wholeNumber(const nlohmann::ordered_json& json);

/// Returns the text of a JSON document, indented by one space, with a newline at the end. Replaces invalid UTF-8,
/// which may occur in file names.
std::string jsonText(const nlohmann::ordered_json& json);

std::string utf8FromBytes(const std::string& bytes);
/// Reverses utf8FromBytes(), which encodes each byte as one character. @pre made by utf8FromBytes().
std::string bytesFromUtf8(const std::string& utf8);

}  // namespace poinsot::core

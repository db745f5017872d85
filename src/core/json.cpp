// SPDX-License-Identifier: Apache-2.0
#include "core/json.h"

#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/text.h"

namespace poinsot::core {

using Json = nlohmann::ordered_json;

Json parseJson(std::string_view text) try {
  return Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
    if (depth >= kDeepestJson)
      throw ioError(fmt::format("objects and arrays are nested more than {} deep", kDeepestJson));
    return true;
  });
} catch (const Json::exception& error) {
  throw ioError("invalid JSON: " + printable(error.what()));
}

Json readJson(const std::filesystem::path& file, std::size_t mostBytes) {
  return parseJson(readRegularFile(file, mostBytes, ErrorKind::kIo));
}

std::int64_t wholeNumber(const Json& json) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const bool small = !json.is_number_unsigned() || json.get<std::uint64_t>() <= kMost;
  if (!json.is_number_integer() || !small) throw ioError("expected an integer");
  return json.get<std::int64_t>();
}

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string utf8FromBytes(const std::string& bytes) {
  std::string utf8;
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xc0 | byte >> 6);
      utf8 += static_cast<char>(0x80 | (byte & 0x3f));
    }
  }
  return utf8;
}

std::string bytesFromUtf8(const std::string& utf8) {
  std::string bytes;
  for (std::size_t i = 0; i < utf8.size(); ++i) {
    const auto lead = static_cast<unsigned char>(utf8[i]);
    bytes += lead < 0x80 ? utf8[i]
                         : static_cast<char>((lead & 0x03) << 6 | (static_cast<unsigned char>(utf8[++i]) & 0x3f));
  }
  return bytes;
}

}  // namespace poinsot::core

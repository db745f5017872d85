// SPDX-License-Identifier: Apache-2.0
#include "core/json_file.h"

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
      throw Error(ErrorKind::kIo, fmt::format("objects and arrays are nested more than {} deep", kDeepestJson));
    return true;
  });
} catch (const Json::exception& error) {
  throw Error(ErrorKind::kIo, "no JSON: " + printable(error.what()));
}

Json readJson(const std::filesystem::path& file, std::size_t mostBytes) {
  return parseJson(readRegularFile(file, mostBytes, ErrorKind::kIo));
}

std::int64_t wholeNumber(const Json& json) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  const bool small = !json.is_number_unsigned() || json.get<std::uint64_t>() <= kMost;
  if (!json.is_number_integer() || !small) throw Error(ErrorKind::kIo, "no whole number");
  return json.get<std::int64_t>();
}

std::string jsonText(const nlohmann::ordered_json& json) {
  return json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace poinsot::core

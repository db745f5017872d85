// SPDX-License-Identifier: Apache-2.0
#include "request/user_limits.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "request/user_file.h"
#include "scene/document/document.h"

namespace poinsot::request {
namespace {

namespace fs = std::filesystem;
using scene::Limits;
using scene::Node;

void take(const Node& value, scene::Limit limit, Limits& limits) {
  if (const auto* number = value.as<std::int64_t>()) return limits.set(limit, *number);
  if (const auto* text = value.as<std::string>()) return limits.set(limit, std::string_view(*text));
  throw core::Error(core::ErrorKind::kUsage,
                    fmt::format("expected a whole number, or a size such as \"4 GiB\", got {}", describe(value)));
}

}  // namespace

fs::path userLimitsFile() { return userFile("limits.toml"); }

Limits limitsOf(const fs::path& file) {
  Limits limits;
  readUserFile(file, [&](const scene::Entry& entry, scene::Problems& problems) {
    scene::Place place = entry.keyPlace;
    try {
      const scene::Limit limit = scene::limitNamed(entry.key);
      place = entry.value.place;
      take(entry.value, limit, limits);
    } catch (const core::Error& error) {
      problems.add(place, fmt::format("{}: {}", core::printable(entry.key), error.message()));
    }
  });
  return limits;
}

}  // namespace poinsot::request

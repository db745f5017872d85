// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "core/error.h"
#include "core/text.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

using enum LimitUnit;

constexpr std::int64_t kKi = 1 << 10, kMi = kKi << 10, kGi = kMi << 10, kTi = kGi << 10;

// Each default is far above what a lecture needs and far below the capacity of a small machine. Each maximum is
// where something else fails: the stack for nesting, llvmpipe for sides, 32-bit indices for triangles.
constexpr LimitRow kTable[] = {
    {"scene_bytes", kBytes, 4 * kMi, kGi, "text of a scene file, a style file, a golden.toml"},
    {"string_bytes", kBytes, 64 * kKi, 64 * kMi, "one string in such a file, as written"},
    {"nesting", kCount, 64, 1000, "depth of nested tables and arrays"},
    {"values", kCount, 100'000, 100'000'000, "tables, arrays, values and parts of keys in such a file"},
    {"elements", kCount, 10'000, 1'000'000, "an array of tables: parts, point masses, steps of a torque"},
    {"file_bytes", kBytes, 128 * kMi, 64 * kGi, "one file that a scene names: a mesh, a table"},
    {"files_bytes", kBytes, 512 * kMi, 64 * kGi, "all files that a scene names"},
    {"triangles", kCount, 2'000'000, 1'000'000'000, "all meshes of a scene"},
    {"characters", kCount, 10'000, 10'000'000, "all text that one frame may show, as written"},
    {"side", kPixels, 8192, 16384, "a side of a picture"},
    {"frames", kCount, 36'000, 10'000'000, "frames of a film"},
    {"fps", kCount, 1000, 1'000'000, "frames per second"},
    {"duration", kSeconds, 3600, 1'000'000'000, "length of a film"},
    {"steps", kCount, 2'000'000, 1'000'000'000,
     "steps of a driven motion; a fifth of that with losses, where a step takes longer"},
    {"memory", kBytes, 2 * kGi, 1024 * kTi,
     "estimated memory of one process that draws or compares; also `--max-memory`"},
    {"output", kBytes, 64 * kGi, 1024 * kTi, "all files that a run writes: a film, a sequence, a trajectory"},
    {"seconds", kSeconds, 0, 1'000'000'000, "wall-clock time of a run; also `--max-seconds`"},
};
static_assert(std::size(kTable) == kLimitCount);

struct Size {
  std::string_view unit;
  std::int64_t bytes;
};
constexpr Size kSizes[] = {{"TiB", kTi}, {"GiB", kGi}, {"MiB", kMi}, {"KiB", kKi}};

std::string bytesText(std::int64_t value) {
  for (const Size& size : kSizes)
    if (value >= size.bytes && value % size.bytes == 0) return fmt::format("{} {}", value / size.bytes, size.unit);
  return fmt::format("{} bytes", value);
}

std::optional<std::int64_t> parsed(std::string_view text, LimitUnit unit) {
  std::int64_t value = 0, factor = 1;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
  while (rest.starts_with(' ')) rest.remove_prefix(1);
  if (unit == kBytes && !rest.empty())
    for (const Size& size : kSizes)
      if (rest == size.unit) {
        factor = size.bytes;
        rest = {};
      }
  std::int64_t product = 0;
  const bool fits = status == std::errc() && rest.empty() && !__builtin_mul_overflow(value, factor, &product);
  return fits ? std::optional(product) : std::nullopt;
}

}  // namespace

std::span<const LimitRow> limitTable() { return kTable; }

const LimitRow& rowOf(Limit limit) { return limitTable()[static_cast<std::size_t>(limit)]; }

double usual(Limit limit) { return static_cast<double>(rowOf(limit).usual); }

std::string limitText(Limit limit, std::int64_t value) {
  switch (rowOf(limit).unit) {
    case kCount:
      return fmt::format("{}", value);
    case kBytes:
      return bytesText(value);
    case kSeconds:
      return fmt::format("{} s", value);
    case kPixels:
      return fmt::format("{} pixels", value);
  }
  return "";
}

std::string howToRaise(Limit limit) {
  if (limit == Limit::kMemory) return "--max-memory SIZE raises the limit";
  return fmt::format("--limit {}=N raises the limit", rowOf(limit).name);
}

Limits::Limits() {
  for (std::size_t i = 0; i < kLimitCount; ++i) values_[i] = kTable[i].usual;
}

void Limits::set(Limit limit, std::int64_t value) {
  const LimitRow& row = rowOf(limit);
  if (value < 1 || value > row.highest)
    throw core::usageError(
        fmt::format("the limit {} must be from 1 to {}, got {}", row.name, limitText(limit, row.highest), value));
  values_[static_cast<std::size_t>(limit)] = value;
}

void Limits::set(Limit limit, std::string_view value) {
  const LimitRow& row = rowOf(limit);
  if (const auto number = parsed(value, row.unit)) return set(limit, *number);
  throw core::usageError(fmt::format("the limit {} must be a whole number{}, got '{}'", row.name,
                                     row.unit == kBytes ? ", of bytes or with KiB, MiB, GiB or TiB" : "",
                                     core::printable(value)));
}

void Limits::setByWord(std::string_view word) {
  const auto equals = word.find('=');
  if (equals == std::string_view::npos)
    throw core::usageError(fmt::format("'{}': a limit is NAME=VALUE, such as side=16384", core::printable(word)));
  set(limitNamed(word.substr(0, equals)), word.substr(equals + 1));
}

Limit limitNamed(std::string_view name) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < kLimitCount; ++i) {
    if (kTable[i].name == name) return static_cast<Limit>(i);
    names.emplace_back(kTable[i].name);
  }
  constexpr std::size_t kLongest = 64;  // characters; the edit distance of longer text takes too long
  const auto near = name.size() <= kLongest ? core::closest(name, names) : std::nullopt;
  throw core::usageError(fmt::format(
      "there is no limit '{}'{}", core::printable(name),
      near ? fmt::format("; did you mean {}?", *near) : fmt::format(": {}", core::joined(names, ", "))));
}

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#include "cli/option_values.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <optional>

#include "cli/command.h"
#include "core/error.h"
#include "core/number.h"
#include "core/text.h"
#include "figure/figure.h"
#include "scene/limits.h"
#include "scene/sweep.h"
#include "scene/units.h"

namespace poinsot::cli {

double parseTime_s(std::string_view option, const std::string& word) {
  if (const auto seconds = core::parseNumber(word)) return *seconds;
  const auto quantity = scene::parseQuantity(word, scene::Dimension::kTime);
  if (!quantity.ok())
    throw core::usageError(fmt::format("{} '{}': {}", option, core::printable(word), quantity.problem));
  return quantity.value;
}

std::vector<double> parseTimes_s(std::string_view option, std::string_view words) {
  std::vector<double> times_s;
  for (bool last = false; !last;) {
    const auto comma = words.find(',');
    last = comma == std::string_view::npos;
    std::string_view word = words.substr(0, comma);
    while (word.starts_with(' ')) word.remove_prefix(1);
    while (word.ends_with(' ')) word.remove_suffix(1);
    times_s.push_back(parseTime_s(option, std::string(word)));
    if (!last) words.remove_prefix(comma + 1);
  }
  return times_s;
}

namespace {

/// Returns the times of a range such as "0..3.6:5".
std::vector<double> spreadTimes_s(const std::string& times) try {
  const std::string override = fmt::format("{}={}", scene::kInstantKey, times);
  const scene::SweepAxis axis = scene::sweepAxis(override).value();
  std::vector<double> times_s;
  for (const scene::SweepValue& value : axis.values) times_s.push_back(parseTime_s("--times", value.text));
  return times_s;
} catch (const core::Error& error) {
  std::string message = error.message();
  const std::string key = fmt::format("-D {}:", scene::kInstantKey);
  if (message.starts_with(key)) message.replace(0, key.size(), "--times");
  throw core::usageError(message);
}

}  // namespace

std::string instantsOverride(const std::string& times) {
  const auto refuse = [&](const std::string& why) {
    throw core::usageError(fmt::format("--times '{}': {}", core::printable(times), why));
  };
  const bool isRange = times.find("..") != std::string::npos;
  const std::vector<double> times_s = isRange ? spreadTimes_s(times) : parseTimes_s("--times", times);
  if (times_s.size() < 2 || times_s.size() > static_cast<std::size_t>(scene::kMostCells))
    refuse(fmt::format("a sheet has from 2 to {} instants, got {}; for one instant, use --time", scene::kMostCells,
                       times_s.size()));
  std::string text;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    if (!std::isfinite(times_s[i]) || times_s[i] < 0)
      refuse(fmt::format("{} s: a film begins at 0 s; choose times from 0 to its end", times_s[i]));
    if (i > 0 && times_s[i] <= times_s[i - 1])
      refuse(fmt::format("{} s comes after {} s; the times must increase", times_s[i], times_s[i - 1]));
    text += fmt::format("{}{}", i == 0 ? "" : "|", times_s[i]);
  }
  return fmt::format("{}={}", scene::kInstantKey, text);
}

namespace {

struct PaperUnit {
  std::string_view name;
  double unit_mm;
};

constexpr double kTexPoint_mm = 25.4 / 72.27;
constexpr PaperUnit kUnits[] = {{"mm", 1}, {"cm", 10}, {"in", 25.4}, {"pt", kTexPoint_mm}};

constexpr double kLeastWidth_mm = 15;  // minimum for text in its printed size
constexpr double kLeastType_pt = 3, kMostType_pt = 40;

/// Parses a number above 0 with a unit. Returns nullopt for other text.
std::optional<double> parseLength_mm(std::string_view word) {
  for (const PaperUnit& unit : kUnits) {
    if (!word.ends_with(unit.name)) continue;
    std::string_view number = word.substr(0, word.size() - unit.name.size());
    while (number.ends_with(' ')) number.remove_suffix(1);
    const auto value = core::parseNumber(number);
    if (!value || !(*value > 0) || !std::isfinite(*value)) break;
    return *value * unit.unit_mm;
  }
  return std::nullopt;
}

struct Sides {
  double width, height;
};

Sides sidesOf(const request::PrintSize& print, image::PixelSize proportion) {
  const double width = std::round(print.width_mm / 25.4 * print.dpi);
  return {width, std::round(width * proportion.height / proportion.width)};
}

bool fits(const Sides& sides, double most) {
  const auto within = [most](double side) { return side >= scene::kLeastSide && side <= most; };
  return within(sides.width) && within(sides.height);
}

/// Returns advice to use the nearest whole --dpi that is allowed. Empty if no --dpi is allowed.
std::string advice(request::PrintSize print, image::PixelSize proportion, double longest) {
  const Sides asked = sidesOf(print, proportion);
  const auto [least, most] = std::minmax(asked.width, asked.height);
  const double shrink = longest / most;
  print.dpi = shrink < 1 ? std::floor(print.dpi * shrink) : std::ceil(print.dpi * scene::kLeastSide / least);
  return fits(sidesOf(print, proportion), longest) ? fmt::format("; use --dpi {:.0f}", print.dpi) : "";
}

}  // namespace

double parseWidth_mm(const std::string& word) {
  const auto width_mm = parseLength_mm(word);
  if (!width_mm)
    throw core::usageError(
        fmt::format("--width '{}': must be a number above 0 with the unit mm, cm, in or pt, such as 86mm",
                    core::printable(word)));
  if (*width_mm >= kLeastWidth_mm) return *width_mm;
  throw core::usageError(
      fmt::format("--width '{}': must be at least {} mm, because text does not shrink below its size in points",
                  core::printable(word), kLeastWidth_mm));
}

double parseTypeSize_pt(const std::string& word) {
  const auto size_mm = parseLength_mm(word);
  const double size_pt = size_mm.value_or(0) / kTexPoint_mm;
  // Accepts 3pt and 40pt in spite of rounding.
  if (size_pt >= kLeastType_pt - 1e-9 && size_pt <= kMostType_pt + 1e-9) return *size_mm / 25.4 * 72;
  throw core::usageError(fmt::format("--type '{}': must be from {} to {} pt, with the unit, such as 8pt",
                                     core::printable(word), kLeastType_pt, kMostType_pt));
}

image::PixelSize printedPixels(const request::PrintSize& print, image::PixelSize proportion,
                               const scene::Limits& limits) {
  const auto longest = static_cast<double>(limits[scene::Limit::kSide]);
  const Sides sides = sidesOf(print, proportion);
  if (fits(sides, longest)) return {static_cast<int>(sides.width), static_cast<int>(sides.height)};
  throw core::limitError(fmt::format(
      "{:.4g} mm at {:.4g} dpi are {:.0f}x{:.0f} pixels; sides must be from {} to {} pixels{}", print.width_mm,
      print.dpi, sides.width, sides.height, scene::kLeastSide, longest, advice(print, proportion, longest)));
}

namespace {

struct FileUnit {
  std::string_view name;
  double unit_bytes;
};

constexpr FileUnit kFileUnits[] = {{"KiB", 1024.0}, {"MiB", 1048576.0}, {"GiB", 1073741824.0},
                                   {"kB", 1e3},     {"MB", 1e6},        {"GB", 1e9}};
constexpr double kMostFile_bytes = 1e15;

}  // namespace

std::int64_t parseFileSize_bytes(std::string_view option, const std::string& word) {
  std::string_view number = word;
  double unit_bytes = 1;
  for (const FileUnit& unit : kFileUnits)
    if (number.ends_with(unit.name)) {
      unit_bytes = unit.unit_bytes;
      number.remove_suffix(unit.name.size());
      break;
    }
  while (number.ends_with(' ')) number.remove_suffix(1);
  const double size_bytes = core::parseNumber(number).value_or(0) * unit_bytes;
  if (size_bytes >= 1 && size_bytes <= kMostFile_bytes) return static_cast<std::int64_t>(size_bytes);
  throw core::usageError(fmt::format(
      "{} '{}': must be from 1 byte to {:.0f} GB; write a number of bytes, or a number with kB, MB, GB, "
      "KiB, MiB or GiB, such as 5MB",
      option, core::printable(word), kMostFile_bytes / 1e9));
}

std::string fileSizeText(std::int64_t size_bytes) {
  const auto size = static_cast<double>(size_bytes);
  if (size < 1e3) return fmt::format("{} bytes", size_bytes);
  if (size < 999.5e3) return fmt::format("{:.3g} kB", size / 1e3);
  return size < 999.5e6 ? fmt::format("{:.3g} MB", size / 1e6) : fmt::format("{:.4g} GB", size / 1e9);
}

void addBitsOption(const Command& command, int& bits) {
  command
      .option("--bits", bits, "bits per sample in a PNG: 8, or 16 for gradients that you edit later (default: 8)")
      .type("N")
      .amongNumbers({8, 16});
}

void checkBits(int bits, const request::OutputTarget& target) {
  if (bits == 8 || request::takesDeepPictures(target)) return;
  throw core::usageError(
      fmt::format("--bits {}: {}", bits,
                  target.kind == request::OutputKind::kFigure
                      ? "the pictures in a figure have 8; NAME.png can have 16"
                      : "the pictures of a film have 8; NAME_{frame:05}.png and NAME.png can have 16"));
}

}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "image/png_color.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "core/sha256.h"
#include "core/text.h"

namespace poinsot::image {
namespace {

struct KnownCicp {
  int primaries, transfer;
  const char* name;
};

/// Source: ITU-T H.273, tables 2 and 3.
constexpr KnownCicp kKnownCicp[] = {
    {12, 13, "Display P3"}, {9, 16, "BT.2100 PQ"}, {9, 18, "BT.2100 HLG"}, {1, 1, "BT.709"}, {9, 14, "BT.2020"}};
constexpr int kSrgbPrimaries = 1, kSrgbTransfer = 13;

ColorTag cicpTag(const std::array<std::uint8_t, 4>& codes) {
  const auto [primaries, transfer, matrix, range] = codes;
  const bool plain = matrix == 0 && range == 1;  // RGB with the full range of values
  if (plain && primaries == kSrgbPrimaries && transfer == kSrgbTransfer) return {};
  const std::string digits = fmt::format("{}-{}-{}-{}", primaries, transfer, matrix, range);
  std::string name = digits;
  for (const KnownCicp& known : kKnownCicp)
    if (plain && known.primaries == primaries && known.transfer == transfer) name = known.name;
  return {name + " (cICP)", "cICP " + digits};
}

ColorTag profileTag(const PngColorChunks& chunks) {
  const std::string_view bytes(reinterpret_cast<const char*>(chunks.profile.data()), chunks.profile.size());
  return {fmt::format("the profile '{}' (iCCP)", core::printable(chunks.profileName)),
          "iCCP " + core::toHex(core::sha256(bytes))};
}

bool areSrgbPrimaries(const std::array<int, 8>& primaries) {
  constexpr std::array<int, 8> kSrgb = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
  constexpr int kRounding = 100;
  return std::ranges::equal(primaries, kSrgb, [](int a, int b) { return std::abs(a - b) <= kRounding; });
}

ColorTag gammaTag(const PngColorChunks& chunks) {
  constexpr double kSrgbGamma = 1 / 2.2, kRounding = 5e-4;
  std::vector<std::string> names;
  std::string identity;
  if (chunks.gamma && std::abs(*chunks.gamma - kSrgbGamma) > kRounding) {
    names.push_back(fmt::format("gamma {:.4g} (gAMA)", 1 / *chunks.gamma));
    identity = names.back();
  }
  if (chunks.primaries && !areSrgbPrimaries(*chunks.primaries)) {
    names.emplace_back("primaries of its own (cHRM)");
    identity += fmt::format("cHRM {}", fmt::join(*chunks.primaries, " "));
  }
  if (names.empty()) return {};
  return {fmt::format("{}", fmt::join(names, " and ")), identity};
}

}  // namespace

ColorTag colorTagOf(const PngColorChunks& chunks) {
  if (chunks.cicp) return cicpTag(*chunks.cicp);
  if (chunks.isSrgb) return {};
  return chunks.profileName.empty() ? gammaTag(chunks) : profileTag(chunks);
}

}  // namespace poinsot::image

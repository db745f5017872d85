// SPDX-License-Identifier: Apache-2.0
#include "stage/type/readout_board.h"

#include <algorithm>
#include <cmath>

#include "core/expect.h"
#include "stage/plot/plot_tones.h"
#include "text/math_setter.h"

namespace poinsot::stage {
namespace {

constexpr int kMostDigits = 4;

/// Returns the number of decimals that gives a positive number `digits` significant digits.
int decimalsOf(int digits, double number) { return digits - 1 - static_cast<int>(std::floor(std::log10(number))); }

std::vector<int> quantitiesOf(const std::vector<scene::Readout>& readouts) {
  std::vector<int> all;
  for (const scene::Readout& readout : readouts) all.push_back(readout.quantity);
  return all;
}

std::string nameOf(const scene::Readout& readout, const std::string& tex) {
  return readout.label.empty() ? "$" + tex + "\\,=$" : readout.label + " $=$";
}

std::string wider(const std::string& a, const std::string& b) {
  return text::setTex(a).width_em >= text::setTex(b).width_em ? a : b;
}

}  // namespace

std::string ReadoutFormat::tex(double si, scene::DecimalSign sign) const {
  return numberTex(fixedDigits(unit.written(si), decimals), sign);
}

ReadoutFormat readoutFormat(scene::QuantityUnit unit, const QuantityRange& range, const std::string& asked) {
  const double size = sizeOf(range);
  ReadoutFormat format{writtenUnit(unit, size, asked), 0};
  const double largest = format.unit.written(size);
  const int wanted = varies(range) ? decimalsThatResolve(format.unit.written(range.high - range.low))
                                   : decimalsOf(kMostDigits, largest);
  format.decimals = std::max(0, std::min(wanted, decimalsOf(kMostDigits, largest)));
  return format;
}

ReadoutBoard::ReadoutBoard(const scene::Scene& scene, std::shared_ptr<const physics::Motion> motion,
                           const Palette& colors, std::span<const QuantityRange> least)
    : sign_(scene.style.decimalSign) {
  if (scene.readouts.empty()) return;
  POINSOT_EXPECT(least.empty() || least.size() == scene.readouts.size());
  track_.emplace(scene, std::move(motion), quantitiesOf(scene.readouts));
  for (std::size_t i = 0; i < scene.readouts.size(); ++i) {
    const scene::StateQuantity& quantity = track_->quantity(i);
    const QuantityRange& range =
        ranges_.emplace_back(least.empty() ? track_->range(i) : joined(track_->range(i), least[i]));
    const ReadoutFormat& format =
        formats_.emplace_back(readoutFormat(quantity.unit, range, scene.readouts[i].unit));
    texts_.push_back({.at = scene.readouts[i].at,
                      .name = nameOf(scene.readouts[i], track_->tex(i)),
                      .value = {},
                      .widest = wider(format.tex(range.low, sign_), format.tex(range.high, sign_)),
                      .unit = unitSuffix(format.unit),
                      .color = familyColor(colors, quantity.family)});
  }
}

std::vector<ReadoutText> ReadoutBoard::at(double filmTime_s) const {
  std::vector<ReadoutText> texts = texts_;
  for (std::size_t i = 0; i < texts.size(); ++i)
    texts[i].value = formats_[i].tex(track_->at(i, filmTime_s), sign_);
  return texts;
}

}  // namespace poinsot::stage

// SPDX-License-Identifier: Apache-2.0
#include "compare/change_measures.h"

#include <algorithm>
#include <cstring>
#include <tuple>
#include <vector>

#include "compare/changed_pixels.h"

namespace poinsot::compare {
namespace {

/// Returns all shifts up to kLargestShift except (0, 0), the shortest first.
std::vector<Shift> candidates() {
  std::vector<Shift> shifts;
  for (int y = -kLargestShift; y <= kLargestShift; ++y)
    for (int x = -kLargestShift; x <= kLargestShift; ++x)
      if (x != 0 || y != 0) shifts.push_back({x, y});
  std::ranges::sort(shifts, {}, [](const Shift& s) { return std::tuple(s.x * s.x + s.y * s.y, s.y, s.x); });
  return shifts;
}

/// Tests whether a shift explains the differences in a box. A quick test of a few differing pixels rejects nearly
/// all shifts. A full test then compares every pixel of the box.
template <typename Sample>
class ShiftTrial {
 public:
  ShiftTrial(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b, const image::PixelRect& box,
             std::int64_t changed)
      : a_(a), b_(b), box_(box) {
    constexpr std::int64_t kProbes = 256;
    const std::int64_t stride = std::max<std::int64_t>(1, changed / kProbes);
    std::int64_t count = 0;
    forEachChangedPixel(a, b, box, [&](int x, int y, const Sample*, const Sample*) {
      if (count++ % stride == 0) probes_.push_back({x, y});
    });
  }

  bool agreesAtProbes(const Shift& shift) const {
    std::size_t met = 0;
    for (const Shift& at : probes_) {
      const int fromX = at.x - shift.x, fromY = at.y - shift.y, toX = at.x + shift.x, toY = at.y + shift.y;
      const bool hasOrigin = inPicture(fromX, fromY), hasTarget = inPicture(toX, toY);
      if (hasOrigin && !equal(a_.at(fromX, fromY), b_.at(at.x, at.y), 1)) return false;
      if (hasTarget && !equal(a_.at(at.x, at.y), b_.at(toX, toY), 1)) return false;
      met += hasOrigin && hasTarget ? 1 : 0;
    }
    return 3 * met >= probes_.size();  // pixels that entered or left prove nothing
  }

  bool agreesEverywhere(const Shift& shift) const {
    return agreesFrom(shift,
                      {box_.left - shift.x, box_.top - shift.y, box_.right - shift.x, box_.bottom - shift.y}) &&
           agreesFrom(shift, box_);
  }

 private:
  /// Reports whether a part of the reference appears in the test, moved by `shift`. Pixels without a position in
  /// both pictures are skipped.
  bool agreesFrom(const Shift& shift, const image::PixelRect& part) const {
    const auto [width, height] = a_.size;
    const int left = std::max({part.left, 0, -shift.x}), right = std::min({part.right, width, width - shift.x});
    const int top = std::max({part.top, 0, -shift.y}), bottom = std::min({part.bottom, height, height - shift.y});
    for (int y = top; y < bottom && left < right; ++y)
      if (!equal(a_.at(left, y), b_.at(left + shift.x, y + shift.y), right - left)) return false;
    return true;
  }
  bool inPicture(int x, int y) const { return x >= 0 && x < a_.size.width && y >= 0 && y < a_.size.height; }
  bool equal(const Sample* p, const Sample* q, int pixels) const {
    return std::memcmp(p, q, static_cast<std::size_t>(pixels * a_.channels) * sizeof(Sample)) == 0;
  }

  const image::BasicImage<Sample>&a_, &b_;
  image::PixelRect box_;
  std::vector<Shift> probes_;  // positions of the pixels for the quick test
};

template <typename Sample>
std::optional<Shift> found(const image::BasicImage<Sample>& a, const image::BasicImage<Sample>& b,
                           const image::PixelRect& box, std::int64_t changed) {
  const ShiftTrial<Sample> trial(a, b, box, changed);
  int fullTrials = 8;  // limits the time if the quick test accepts many shifts
  std::optional<Shift> only;
  for (const Shift& shift : candidates()) {
    if (!trial.agreesAtProbes(shift)) continue;
    if (trial.agreesEverywhere(shift)) {
      if (only) return std::nullopt;  // ambiguous, such as a flat area that grew
      only = shift;
    }
    if (--fullTrials == 0) break;
  }
  return only;
}

}  // namespace

std::optional<Shift> shiftOf(const image::Image& reference, const image::Image& test, const image::PixelRect& box,
                             std::int64_t changed) {
  return found(reference, test, box, changed);
}

std::optional<Shift> shiftOf(const image::DeepImage& reference, const image::DeepImage& test,
                             const image::PixelRect& box, std::int64_t changed) {
  return found(reference, test, box, changed);
}

}  // namespace poinsot::compare

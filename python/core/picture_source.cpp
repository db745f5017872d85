// SPDX-License-Identifier: Apache-2.0
#include "picture_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "compare/picture_rule.h"
#include "core/error.h"
#include "core/text.h"

namespace poinsot::python {
namespace {

namespace py = pybind11;
namespace fs = std::filesystem;

template <class Sample>
image::BasicImage<Sample> expanded(const Sample* samples, image::PixelSize size, int channels) {
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  image::BasicImage<Sample> picture(size, alpha ? 4 : 3);
  if (!grey) {
    std::copy_n(samples, picture.pixels.size(), picture.pixels.begin());
    return picture;
  }
  auto next = picture.pixels.begin();
  const std::size_t pixels = picture.pixels.size() / (alpha ? 4 : 3);
  for (std::size_t i = 0; i < pixels; ++i) {
    next = std::fill_n(next, 3, *samples++);
    if (alpha) *next++ = *samples++;
  }
  return picture;
}

template <class Sample>
compare::DiffPicture pictureOfSamples(const py::array& array) {
  const auto samples = py::array_t<Sample, py::array::c_style>::ensure(array);
  const auto side = [&](py::ssize_t axis) { return static_cast<int>(array.shape(axis)); };
  const int channels = side(2);
  return {expanded(samples.data(), {side(1), side(0)}, channels), {channels, false, sizeof(Sample) == 2}};
}

}  // namespace

compare::DiffPicture pictureOf(const py::array& array) {
  return array.itemsize() == 2 ? pictureOfSamples<std::uint16_t>(array) : pictureOfSamples<std::uint8_t>(array);
}

Source sourceOf(const PictureSource& source) {
  if (py::isinstance<py::bytes>(source)) return fs::path(py::cast<std::string>(source));
  return pictureOf(py::cast<py::array>(source));
}

compare::NearRule limitsOf(const RuleWords& rule) {
  compare::NearRule limits;
  for (const auto& [key, word] : rule)
    if (key == "like") limits = compare::namedLimits("rule", word);
  for (const auto& [key, word] : rule) {
    if (key == "like") continue;
    const auto known = std::ranges::find(compare::ruleLimits(), std::string_view(key), &compare::RuleLimit::key);
    if (known == compare::ruleLimits().end()) {
      std::vector<std::string_view> keys{"like"};
      for (const compare::RuleLimit& limit : compare::ruleLimits()) keys.emplace_back(limit.key);
      throw core::usageError(
          fmt::format("rule: unknown key '{}'; the keys are {}", core::printable(key), core::joined(keys, ", ")));
    }
    known->set(limits, "rule: " + key, word);
  }
  compare::expectCanRefuse(limits, "rule");
  return limits;
}

compare::PictureRule ruleOf(const RuleWords& rule, const std::vector<std::vector<double>>& ignore) {
  compare::PictureRule made{limitsOf(rule)};
  for (const std::vector<double>& box : ignore) made.ignore.push_back(compare::ignoredBox("ignore", box));
  return made;
}

}  // namespace poinsot::python

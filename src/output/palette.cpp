// SPDX-License-Identifier: Apache-2.0
#include "output/palette.h"

#include "core/error.h"
#include "core/expect.h"
#include "output/imagequant_library.h"

namespace poinsot::output {
namespace {

template <auto kFree>
struct LiqDeleter {
  template <class T>
  void operator()(T* thing) const {
    (imagequant().*kFree)(thing);
  }
};

using AttributesPtr = std::unique_ptr<liq_attr, LiqDeleter<&Imagequant::liq_attr_destroy>>;
using HistogramPtr = std::unique_ptr<liq_histogram, LiqDeleter<&Imagequant::liq_histogram_destroy>>;
using ImagePtr = std::unique_ptr<liq_image, LiqDeleter<&Imagequant::liq_image_destroy>>;
using ResultPtr = std::unique_ptr<liq_result, LiqDeleter<&Imagequant::liq_result_destroy>>;

void check(liq_error code) {
  if (code == LIQ_OUT_OF_MEMORY) throw std::bad_alloc();
  if (code != LIQ_OK) throw core::encodeError("libimagequant finds no palette");
}

std::vector<std::uint8_t> rgbaOf(const image::Image& picture) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(picture.pixels.size() / static_cast<std::size_t>(picture.channels) * 4);
  for (std::size_t i = 0; i < picture.pixels.size(); i += static_cast<std::size_t>(picture.channels))
    rgba.insert(rgba.end(), {picture.pixels[i], picture.pixels[i + 1], picture.pixels[i + 2], 255});
  return rgba;
}

}  // namespace

void checkPaletteMaker() { imagequant(); }

struct PaletteMaker::Parts {
  AttributesPtr attributes;
  HistogramPtr histogram;
};

PaletteMaker::PaletteMaker(int most) : parts_(std::make_unique<Parts>()) {
  // Use one thread, because the sums depend on the number of threads.
  if (imagequant().omp_set_num_threads) imagequant().omp_set_num_threads(1);
  parts_->attributes.reset(imagequant().liq_attr_create());
  if (!parts_->attributes) throw std::bad_alloc();
  check(imagequant().liq_set_max_colors(parts_->attributes.get(), most));
  parts_->histogram.reset(imagequant().liq_histogram_create(parts_->attributes.get()));
  if (!parts_->histogram) throw std::bad_alloc();
}

PaletteMaker::~PaletteMaker() = default;

void PaletteMaker::add(const image::Image& picture) {
  const std::vector<std::uint8_t> rgba = rgbaOf(picture);
  const ImagePtr image(imagequant().liq_image_create_rgba(parts_->attributes.get(), rgba.data(),
                                                          picture.size.width, picture.size.height, 0));
  if (!image) throw std::bad_alloc();
  check(imagequant().liq_histogram_add_image(parts_->histogram.get(), parts_->attributes.get(), image.get()));
}

std::vector<Rgb> PaletteMaker::palette() {
  liq_result* made = nullptr;
  check(imagequant().liq_histogram_quantize(parts_->histogram.get(), parts_->attributes.get(), &made));
  const ResultPtr result(made);
  const liq_palette& colors = *imagequant().liq_get_palette(made);
  std::vector<Rgb> palette;
  for (unsigned i = 0; i < colors.count; ++i)
    palette.push_back({colors.entries[i].r, colors.entries[i].g, colors.entries[i].b});
  return palette;
}

}  // namespace poinsot::output

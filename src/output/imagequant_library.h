// SPDX-License-Identifier: Apache-2.0
// Functions of libimagequant. The library is opened when the first GIF gets its palette. Included by palette.cpp
// only.
#pragma once

#include <libimagequant.h>

namespace poinsot::output {

// clang-format off
#define POINSOT_IMAGEQUANT_FUNCTIONS(X)                                                                     \
  X(liq_attr_create) X(liq_attr_destroy) X(liq_get_palette) X(liq_histogram_add_image)                      \
  X(liq_histogram_create) X(liq_histogram_destroy) X(liq_histogram_quantize) X(liq_image_create_rgba)       \
  X(liq_image_destroy) X(liq_result_destroy) X(liq_set_max_colors)
// clang-format on

struct Imagequant {
  Imagequant();

#define POINSOT_MEMBER(function) decltype(&::function) function;  // NOLINT(bugprone-macro-parentheses): a name
  POINSOT_IMAGEQUANT_FUNCTIONS(POINSOT_MEMBER)
#undef POINSOT_MEMBER
  /// Sets the number of threads of the OpenMP library that libimagequant uses; null if it uses none. Does not
  /// affect other copies of OpenMP in the process.
  void (*omp_set_num_threads)(int count);
};

/// Returns libimagequant's functions. @throws core::Error(kEncode) as ffmpeg().
const Imagequant& imagequant();

}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
#include "cli/picture_bits.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/error.h"

namespace poinsot::cli {

void addBitsOption(CLI::App& command, int& bits) {
  command.add_option("--bits", bits, "of a sample in a PNG: 8, or 16 for gradients to work on (default: 8)")
      ->type_name("N")
      ->check(CLI::IsMember({8, 16}));
}

void checkBits(int bits, const request::OutputTarget& target) {
  if (bits == 8 || request::takesDeepPictures(target)) return;
  throw core::Error(
      core::ErrorKind::kUsage,
      fmt::format("--bits {}: {}", bits,
                  target.kind == request::OutputKind::kFigure
                      ? "the pictures in a figure have 8; NAME.png can have 16"
                      : "the pictures of a film have 8; NAME_{frame:05}.png and NAME.png can have 16"));
}

}  // namespace poinsot::cli

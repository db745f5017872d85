// SPDX-License-Identifier: Apache-2.0
// Encodes a small film into the file that it is given, and prints what the processor is said to have, then a hash
// of the pictures and one of the film: for the test that no processor changes a byte.
#include <fmt/format.h>

#include <fstream>
#include <span>
#include <sstream>

#include "core/sha256.h"
#include "decoded_film.h"
#include "output/video_segment.h"

using namespace poinsot;

namespace {

constexpr image::PixelSize kSize{320, 180};
constexpr int kFrames = 30;

core::Digest picturesInto(const char* film) {
  core::Sha256 hash;
  output::VideoSegmentWriter segment(film, kSize, {30, 1}, output::h264(18), 0);
  for (int k = 0; k < kFrames; ++k) {
    const image::Image picture = output::movingDisc(kSize, k);
    hash.add(std::as_bytes(std::span(picture.pixels)));
    segment.write({picture}, k);
  }
  segment.finish();
  return hash.finish();
}

core::Digest hashOf(const char* file) {
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return core::sha256(bytes.str());
}

}  // namespace

int main(int, char** argv) {
  fmt::print("ssse3={} avx2={}\n", __builtin_cpu_supports("ssse3") ? 1 : 0,
             __builtin_cpu_supports("avx2") ? 1 : 0);
  const core::Digest pictures = picturesInto(argv[1]);
  fmt::print("{}\n{}\n", core::toHex(pictures), core::toHex(hashOf(argv[1])));
  return 0;
}

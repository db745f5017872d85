// SPDX-License-Identifier: Apache-2.0
#include "edge_error.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "image/png_file.h"

namespace poinsot::render {
namespace {

void write(const image::Image& picture, const std::string& path) {
  const auto bytes = image::encodePng(picture);
  std::ofstream(path, std::ios::binary).write(reinterpret_cast<const char*>(bytes.data()), std::ssize(bytes));
}

}  // namespace

EdgeError edgeError(const image::Image& picture, const FinePicture& fine, const std::string& name) {
  EdgeError error;
  image::Image map(picture.size, 3);
  for (std::size_t i = 0; i < fine.edge.size(); ++i) {
    if (!fine.edge[i]) continue;
    ++error.count;
    for (std::size_t c = 0; c < 3; ++c) {
      const int step = std::abs(picture.pixels[3 * i + c] - fine.mean.pixels[3 * i + c]);
      error.mean += step;
      error.worst = std::max(error.worst, step);
      map.pixels[3 * i + c] = static_cast<std::uint8_t>(std::min(255, 8 * step));
    }
  }
  error.mean /= std::max(3 * error.count, 1);
  if (const char* folder = std::getenv("EDGE_PICTURES"))
    for (const auto& [what, p] : {std::pair{"is", &picture}, {"fine", &fine.mean}, {"error", &map}})
      write(*p, std::string(folder) + "/" + name + ", " + what + ".png");
  std::printf("%-28s %6d edge pixels, mean %5.2f, worst %3d\n", name.c_str(), error.count, error.mean,
              error.worst);
  return error;
}

}  // namespace poinsot::render

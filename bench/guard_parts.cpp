// SPDX-License-Identifier: Apache-2.0
#include "guard_parts.h"

#include <memory>
#include <vector>

#include "compare/difference.h"
#include "guard_picture.h"
#include "image/png_file.h"
#include "output/yuv.h"
#include "physics/free_motion.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot::bench {
namespace {

constexpr image::PixelSize kFrame{1920, 1080};

/// Computes states of each kind of motion in bench/README.md, at times from 0.1 s to about 1e6 s.
Work motion() {
  using Eigen::Vector3d;
  struct Kind {
    Vector3d moments, omega_B;
  };
  const Kind kinds[] = {
      {{2, 3, 4}, {0.5, 0.25, 1}},               // about the largest axis
      {{2, 3, 4}, {1, 0.25, 0.25}},              // about the smallest axis
      {{1, 2, 2.25}, {0.75, 0.5, 1}},            // on the separatrix
      {{1, 2, 2.25}, {0.75, 0.5, 1 + 0x1p-45}},  // 3e-14 off it
      {{1, 2, 3}, {0x1p-10, 1, 0}},              // flipping
      {{1.5, 1.5, 0.9}, {0.5, 0, 2}},            // symmetric
      {{1e-3, 1, 1.0005}, {1, 0.5, 0.25}},       // needle
      {{1, 2, 3}, {0, 0, 1}},                    // steady
  };
  auto motions = std::make_shared<std::vector<physics::FreeMotion>>();
  for (const Kind& kind : kinds)
    motions->emplace_back(physics::PrincipalMoments(kind.moments), kind.omega_B, Eigen::Quaterniond::Identity());
  return [motions] {
    for (const physics::FreeMotion& motion : *motions)
      for (double t_s = 0.1; t_s < 1e6; t_s *= 1.0625) motion.at(t_s);
  };
}

/// Composes pictures of the standard scene, spread over its film, from the draw list to the last letter.
Work compose() {
  const auto stage =
      std::make_shared<const stage::Stage>(scene::loadScene(POINSOT_SOURCE_DIR "/bench/standard.toml"));
  return [stage] {
    for (double filmTime_s = 0; filmTime_s < 10; filmTime_s += 2.5)
      stage->compose(filmTime_s, {kFrame.width, kFrame.height});
  };
}

Work convert() {
  struct Planes {
    std::vector<std::uint8_t> y = std::vector<std::uint8_t>(kFrame.width * kFrame.height);
    std::vector<std::uint8_t> cb = std::vector<std::uint8_t>(y.size() / 4), cr = cb;
  };
  const auto picture = std::make_shared<const image::Image>(guardPicture(kFrame, 0));
  const auto planes = std::make_shared<Planes>();
  return [picture, planes] {
    output::convertToYuv420(*picture, {planes->y.data(), planes->cb.data(), planes->cr.data(), kFrame.width,
                                       kFrame.width / 2, kFrame.width / 2});
  };
}

/// Computes all figures of two pictures that differ at edges. The pictures are small, because FLIP takes half a
/// second for a frame, and 50 times that under valgrind.
Work compare() {
  constexpr image::PixelSize kSmall{480, 270};
  const auto a = std::make_shared<const image::Image>(guardPicture(kSmall, 0));
  const auto b = std::make_shared<const image::Image>(guardPicture(kSmall, 0.125));
  return [a, b] { compare::compare(*a, *b); };
}

Work png() {
  const auto picture = std::make_shared<const image::Image>(guardPicture(kFrame, 0));
  return [picture] { image::encodePng(*picture); };
}

}  // namespace

const std::map<std::string, Work (*)()>& guardedParts() {
  static const std::map<std::string, Work (*)()> parts = {
      {"motion", motion}, {"compose", compose}, {"convert", convert}, {"compare", compare}, {"png", png}};
  return parts;
}

}  // namespace poinsot::bench

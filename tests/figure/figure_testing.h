// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <string>

#include "core/regular_file.h"
#include "figure/alpha.h"
#include "figure/figure.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"

namespace poinsot::figure {

struct Spoken {
  std::string text;
  int status = -1;
};

inline Spoken spoken(const std::string& command) {
  Spoken said;
  std::FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return said;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof(buffer), pipe)) > 0;) said.text.append(buffer, n);
  const int ended = ::pclose(pipe);
  said.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return said;
}

inline bool present(const std::string& program) { return spoken("command -v " + program).status == 0; }

/// Fails the test if a program is missing; the launcher installs these programs for the tests.
#define POINSOT_NEEDS(program) ASSERT_TRUE(present(program)) << program << " is not installed"

/// Fixture that composes, renders and writes pictures as figures. The files stay in build/figure-review/ for
/// inspection.
class FigureTest : public testing::Test {
 protected:
  static constexpr int kWidth = 1016, kHeight = 640;  // 86 mm at 300 dpi across
  static constexpr double kWidth_mm = 86;

  /// Returns a scene's picture, composed for print as by `poinsot still`.
  static draw::Picture sceneAt(const std::string& name, double filmTime_s) {
    const auto file = std::filesystem::path(POINSOT_SOURCE_DIR) / "scenes" / (name + ".toml");
    return stage::Stage(scene::loadScene(file)).compose(filmTime_s, {kWidth, kHeight}, stage::printSizing(300));
  }

  /// Renders a picture. If `transparent` is set, alpha is fitted so that other programs mix as light mixes.
  static image::Image rendered(const draw::Picture& picture, bool transparent = false) {
    gl::pinEnvironment(true);
    static const auto context = gl::openContext(gl::Backend::kAuto);
    static render::Renderer renderer(*context);
    render::RenderOptions options;
    options.transparent = transparent;
    image::Image image = renderer.render(picture, options);
    if (transparent) fitAlpha(image, picture.background);
    return image;
  }

  static std::filesystem::path written(const draw::Picture& picture, const std::string& name,
                                       const FigureOptions& options = {}, bool transparent = false) {
    const auto folder = std::filesystem::path(POINSOT_BINARY_DIR) / "figure-review";
    std::filesystem::create_directories(folder);
    const auto part = rendered(imagePartOf(picture, *figureMedium(name)), transparent);
    writeFigure(folder / name, picture, part, options);
    return folder / name;
  }

  /// Returns the figure as another program draws it on white paper, `times` as large as the picture.
  static image::Image seen(const std::filesystem::path& figure, const draw::Picture& picture, int times = 1) {
    const std::string base =
        (figure.parent_path() / figure.stem()).string() + figure.extension().string().substr(1);
    const glm::ivec2 size = times * picture.size_px;
    const std::string command =
        figure.extension() == ".pdf"
            ? fmt::format("pdftocairo -singlefile -png -scale-to-x {} -scale-to-y {} '{}' '{}'", size.x, size.y,
                          figure.string(), base)
            : fmt::format("rsvg-convert -b white -w {} -h {} -o '{}.png' '{}'", size.x, size.y, base,
                          figure.string());
    const Spoken said = spoken(command);
    EXPECT_EQ(said.status, 0) << command << "\n" << said.text;
    return image::readPng(base + ".png");
  }

  static std::string content(const std::filesystem::path& file) {
    return core::readRegularFile(file, std::size_t{64} << 20, core::ErrorKind::kIo);
  }
};

}  // namespace poinsot::figure

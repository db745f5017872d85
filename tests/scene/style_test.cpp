// SPDX-License-Identifier: Apache-2.0
// Themes, colours by meaning, and style files.
#include "scene/assembly/style_file.h"

#include <gmock/gmock.h>

#include <fstream>
#include <numbers>

#include "scene/camera_preset.h"
#include "scene_testing.h"
#include "support/scratch_folder.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

class StyleFile : public testing::Test {
 protected:
  void write(const std::string& text) const { std::ofstream(folder_.path() / "house.toml") << text; }
  std::string sceneFile() const { return (folder_.path() / "scene.toml").string(); }
  Style style(const std::string& ownKeys = "", const std::vector<std::string>& overrides = {}) const {
    return parseScene(kMinimal + std::string("[style]\nfile = \"house.toml\"\n") + ownKeys, sceneFile(), overrides)
        .style;
  }
  std::vector<Problem> problems(const std::string& ownKeys = "") const {
    return problemsOf(kMinimal + std::string("[style]\nfile = \"house.toml\"\n") + ownKeys, {}, sceneFile());
  }

  ScratchFolder folder_;
};

std::optional<std::uint32_t> color(const Style& style, ColorMeaning meaning) {
  return style.colors[static_cast<std::size_t>(meaning)];
}

TEST_F(StyleFile, SetsKeysThatTheSceneOmits) {
  write("[style]\ntheme = \"dark\"\ntext_size = 1.5\n[style.colors]\nL = \"#0A0b0C\"\nbody = \"#111111\"\n");
  const Style given = style("colors.body = \"#222222\"\n", {"style.text_size=2"});
  EXPECT_EQ(given.theme, Theme::kDark);
  EXPECT_EQ(given.textSize, 2);
  EXPECT_EQ(color(given, ColorMeaning::kL), 0x0A0B0Cu);
  EXPECT_EQ(color(given, ColorMeaning::kBody), 0x222222u);
  EXPECT_EQ(color(given, ColorMeaning::kOmega), std::nullopt);
}

TEST_F(StyleFile, MayBeNamedInAnOverride) {
  write("[style]\ntheme = \"print\"\n");
  EXPECT_EQ(parseScene(kMinimal, sceneFile(), {"style.file=house.toml"}).style.theme, Theme::kPrint);
}

TEST_F(StyleFile, ErrorsNameTheStyleFileAndItsLine) {
  write("[style]\nline_width = 1\n  [style.colors]\n  omega = \"orange\"\n  elipsoid = \"#000000\"\n");
  const auto all = problems();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].where.file, (folder_.path() / "house.toml").string());
  EXPECT_EQ(all[0].where.line, 4);
  EXPECT_EQ(all[0].where.column, 11);
  EXPECT_EQ(all[0].sourceLine, "  omega = \"orange\"");
  EXPECT_EQ(all[0].message,
            "style.colors.omega: expected a colour \"#RRGGBB\" in hexadecimal digits, got \"orange\". For "
            "example:\n    omega = \"#ffa500\"");
  EXPECT_EQ(all[1].where.line, 5);
  EXPECT_THAT(all[1].message, HasSubstr("did you mean style.colors.ellipsoid?"));
}

TEST_F(StyleFile, IsCheckedEvenIfTheSceneOverridesIt) {
  write("[style]\nline_width = 1000\n");
  const auto all = problems("line_width = 2\n");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_THAT(all[0].message, HasSubstr("style.line_width: must be"));
  EXPECT_EQ(all[0].where.line, 2);
}

TEST_F(StyleFile, RejectsKeysOutsideStyle) {
  write("schema = 1\n[style]\nfile = \"house.toml\"\n[show]\nplane = false\n");
  const auto all = problems();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].message, "style.file: a style file must not name another style file");
  EXPECT_THAT(all[1].message,
              HasSubstr("show.plane.visible: a style file may contain only [style] and [style.colors]"));
}

TEST_F(StyleFile, IsRejectedIfItIsNotToml) {
  write("[style]\ntheme = dark\n");
  const auto all = problems();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].where.line, 2);
  EXPECT_THAT(all[0].where.file, HasSubstr("house.toml"));
}

TEST_F(StyleFile, MustLieInTheScenesFolder) {
  for (const char* path : {"../house.toml", "/etc/passwd", "none.toml", ""}) {
    const auto all = problemsOf(kMinimal, {"style.file=" + std::string(path)}, sceneFile());
    ASSERT_EQ(all.size(), 1u) << path;
    EXPECT_THAT(all[0].message, HasSubstr("style.file: cannot read")) << path;
  }
  EXPECT_THAT(messagesOf(kMinimal, {"style.file=" + std::string(500, 'a')}, sceneFile()),
              HasSubstr("style.file: may have at most 200 characters"));
}

TEST(Colors, AreSixHexadecimalDigits) {
  const auto messages = [](const std::string& value) {
    return messagesOf(kMinimal, {"style.colors.ink=" + value});
  };
  EXPECT_EQ(messages("\"#a1B2c3\""), "");
  for (const char* bad : {"\"#12345\"", "\"#1234567\"", "\"123456\"", "\"#12345g\"", "\"#-12345\"", "\"#+12345\"",
                          "\"#0x1234\"", "\"#12 456\"", "123456", "\"\""})
    EXPECT_THAT(messages(bad), HasSubstr("style.colors.ink: expected a colour \"#RRGGBB\"")) << bad;
}

TEST(PrintTheme, HasThinnerLines) {
  const auto width = [](const std::string& keys) {
    return parseScene(kMinimal + std::string("[style]\n") + keys, "test.toml").style.lineWidth;
  };
  const double thin = width("theme = \"print\"\n");
  EXPECT_LT(thin, 0.8);
  EXPECT_DOUBLE_EQ(width("theme = \"print\"\nline_width = 2\n"), 2 * thin);
  EXPECT_EQ(width(""), 1);
}

Camera cameraOf(const std::string& keys) {
  return parseScene(kMinimal + std::string("[camera]\n") + keys, "test.toml").views.at(0).camera;
}

// The x, y and z axes are equally foreshortened: (sin a, -cos a sin e), (cos a, sin a sin e), (0, cos e).
TEST(IsometricPreset, ForeshortensAllAxesAlike) {
  const Camera camera = cameraOf("preset = \"isometric\"\n");
  EXPECT_EQ(camera.projection, Projection::kOrthographic);
  const double a = camera.azimuth_rad, e = camera.elevation_rad;
  EXPECT_NEAR(std::hypot(std::sin(a), std::cos(a) * std::sin(e)), std::cos(e), 1e-15);
  EXPECT_NEAR(std::hypot(std::cos(a), std::sin(a) * std::sin(e)), std::cos(e), 1e-15);
  EXPECT_NEAR(std::cos(e), std::sqrt(2.0 / 3), 1e-15);
  EXPECT_EQ(cameraOf("preset = \"isometric\"\nprojection = \"perspective\"\n").projection,
            Projection::kPerspective);
}

TEST(Presets, LeaveTheProjectionAloneUnlessTheySetIt) {
  EXPECT_EQ(cameraOf("preset = \"side\"\n").projection, Projection::kPerspective);
  EXPECT_EQ(cameraOf("preset = \"side\"\nprojection = \"orthographic\"\n").projection, Projection::kOrthographic);
}

TEST(Projections, MayDifferBetweenViews) {
  const Scene scene = parseScene(
      kMinimal + std::string("[[view]]\ncamera.projection = \"orthographic\"\n[[view]]\n"), "test.toml");
  EXPECT_EQ(scene.views.at(0).camera.projection, Projection::kOrthographic);
  EXPECT_EQ(scene.views.at(1).camera.projection, Projection::kPerspective);
}

}  // namespace
}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
// The golden suite against shaders that are wrong: each fault is put into a copy of them, or into the scene where
// it is one of what is drawn or when, and the suite must not pass. Faults of the renderer itself:
// renderer_faults_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>

#include "golden/suite_run.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;

const Fault kFaults[] = {
    {"GlassInsideOut", "sheet_ellipsoid.glsl", "chord, -1.0, ray2), far = endOf(e, chord, 1.0",
     "chord, 1.0, ray2), far = endOf(e, chord, -1.0"},
    {"NormalsTurned", "shading.glsl", "0.5 + 0.5 * dot(n_C, lightDirection_C)",
     "0.5 - 0.5 * dot(n_C, lightDirection_C)"},
    {"NearPlaneTooFar", "camera.glsl", "* depthRange.y, 0.0", "* depthRange.y - 0.3, 0.0"},
    {"PlanesNotDrawn", "sheet_plane.glsl", "colors[slot] = color;", "colors[slot] = vec4(0.0);"},
    {"RaysHalfAPixelOff", "camera.glsl", "(p_px - opticalCentre_px) * (pixelAtOne * (1.0",
     "(p_px + 0.5 - opticalCentre_px) * (pixelAtOne * (1.0"},
    {"GammaOfAnotherCurve", "srgb.glsl", "sqrt(sqrt(c))", "sqrt(sqrt(0.95 * c))"},
    {"ConstantsOfTheFirst", "composite.frag", "kCones + OF_CONE * k", "kCones"},
    {"OpacityTwice", "sheet.glsl", "return over + under", "return over * over.a + under"},
    {"HighlightLost", "shading.glsl", "0.45 * m.gloss", "0.0 * m.gloss"},
    {"HighlightOfTheOtherSide", "shading.glsl", "lightDirection_C + towardEye_C",
     "lightDirection_C - towardEye_C"},
    {"EdgesThroughSolids", "composite.frag", "depths[slot] <= depth && ", ""},
    {"SecondEdgeLost", "composite.frag", "addEdge(1, nextEdgeColor, nextEdgeDepth, texel, depth)",
     "colors[1] = vec4(0.0)"},
    {"ParallelRaysForgotten", "camera.glsl", "mix(t, 1.0, orthographic)", "t"},
    {"GridOnePercentWide", "sheet_plane.glsl", "gridLines(uv.x", "gridLines(uv.x / 1.01"},
    {"ShadowLost", "sheet_plane.glsl", "shadow.w * max(exp2", "0.0 * max(exp2"},
    {"EdgesNotSmooth", "coverage.glsl", "edge.z * sharpness", "edge.z * 1000.0"},
    {"TubesFlat", "curve.frag", "front = sqrt(1.0 - u * u)", "front = 1.0"},
    {"FacetsOfAnEdgeLeftOut", "mesh_pixel.vert", "i < kFacets", "i < 1"},
    {"PaperOneLevelDarker", "composite.frag", "mix(own(0).rgb,", "mix(own(0).rgb - 0.01,"},
};

class SeededFault : public testing::TestWithParam<Fault> {
 protected:
  ShellResult suite() const {
    return runSuite(folder_, POINSOT_PROGRAM, "tests/golden/golden.toml", kTestsOfEverything,
                    {"POINSOT_SHADERS=" + shaders_});
  }

  const ScratchFolder folder_;
  const std::string shaders_ = (folder_ / "shaders").string();
};

TEST_P(SeededFault, IsCaught) {
  const Fault& fault = GetParam();
  fs::copy(POINSOT_SOURCE_DIR "/shaders", shaders_);
  const std::string text = textWith(fault, shaders_);  // before the file is emptied
  std::ofstream(fs::path(shaders_) / fault.file) << text;
  expectCaught(suite());
}

INSTANTIATE_TEST_SUITE_P(Of, SeededFault, testing::ValuesIn(kFaults),
                         [](const auto& each) { return std::string(each.param.name); });

// The control: the same shaders from a folder, without a fault.
TEST_F(SeededFault, NoneIsNoFailure) {
  fs::copy(POINSOT_SOURCE_DIR "/shaders", shaders_);
  const ShellResult run = suite();
  EXPECT_EQ(run.exitCode, 0) << run.out;
}

/// A suite of one picture that is drawn otherwise than approved.
ShellResult runOther(const ScratchFolder& folder, const std::string& line) {
  const std::string root = POINSOT_SOURCE_DIR;
  folder.put("golden.toml", fmt::format("references = '{0}/tests/golden/images'\nheight = 144\n[[test]]\n"
                                        "name = 'gallery_football'\nscene = '{0}/scenes/football.toml'\n{1}\n",
                                        root, line));
  return runSuite(folder, POINSOT_PROGRAM, (folder / "golden.toml").string() + " --asset-root tests/golden",
                  "gallery_football");
}

TEST_F(SeededFault, OfOneThingNotDrawnIsCaught) {
  EXPECT_EQ(runOther(folder_, "").exitCode, 0);
  EXPECT_EQ(runOther(folder_, "set = ['show.L=false']").exitCode, 1);
}

TEST_F(SeededFault, OfOneFrameTooLateIsCaught) {
  // The still is taken at a time that the scene gives, or at 0.
  const std::string scene = textOf(POINSOT_SOURCE_DIR "/scenes/football.toml");
  const auto at = scene.find("\nstill = ");
  const double still_s = at == std::string::npos ? 0 : std::stod(scene.substr(at + 9));
  EXPECT_EQ(runOther(folder_, fmt::format("times = [{}]", still_s)).exitCode, 0);
  EXPECT_EQ(runOther(folder_, fmt::format("times = [{}]", still_s + 1.0 / 30)).exitCode, 1);
}

}  // namespace
}  // namespace poinsot

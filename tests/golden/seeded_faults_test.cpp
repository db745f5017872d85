// SPDX-License-Identifier: Apache-2.0
// Runs the golden suite with faulty shaders. Each fault is put into a copy of the shaders, or into the scene if it
// concerns the drawn objects or the time. The suite must fail. renderer_faults_test.cpp has faults of the renderer
// itself.
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
  const std::string text = textWith(fault, shaders_);  // reads the file before it is emptied
  std::ofstream(fs::path(shaders_) / fault.file) << text;
  expectCaught(suite());
}

INSTANTIATE_TEST_SUITE_P(Each, SeededFault, testing::ValuesIn(kFaults),
                         [](const auto& each) { return std::string(each.param.name); });

// Control: the same shaders from a folder, without a fault.
TEST_F(SeededFault, ControlWithoutFaultPasses) {
  fs::copy(POINSOT_SOURCE_DIR "/shaders", shaders_);
  const ShellResult run = suite();
  EXPECT_EQ(run.exitCode, 0) << run.out;
}

ShellResult runOther(const ScratchFolder& folder, const std::string& line) {
  const std::string root = POINSOT_SOURCE_DIR;
  folder.put("golden.toml", fmt::format("references = '{0}/tests/golden/images'\nheight = 144\n[[test]]\n"
                                        "name = 'gallery_football'\nscene = '{0}/scenes/football.toml'\n{1}\n",
                                        root, line));
  return runSuite(folder, POINSOT_PROGRAM, (folder / "golden.toml").string() + " --asset-root tests/golden",
                  "gallery_football");
}

TEST_F(SeededFault, IsCaughtIfOneObjectIsNotDrawn) {
  EXPECT_EQ(runOther(folder_, "").exitCode, 0);
  EXPECT_EQ(runOther(folder_, "set = ['show.L=false']").exitCode, 1);
}

TEST_F(SeededFault, IsCaughtIfThePictureIsOneFrameLate) {
  // The still shows the time in the scene, or 0.
  const std::string scene = textOf(POINSOT_SOURCE_DIR "/scenes/football.toml");
  const auto at = scene.find("\nstill = ");
  const double still_s = at == std::string::npos ? 0 : std::stod(scene.substr(at + 9));
  EXPECT_EQ(runOther(folder_, fmt::format("times = [{}]", still_s)).exitCode, 0);
  EXPECT_EQ(runOther(folder_, fmt::format("times = [{}]", still_s + 1.0 / 30)).exitCode, 1);
}

}  // namespace
}  // namespace poinsot

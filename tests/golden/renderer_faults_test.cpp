// SPDX-License-Identifier: Apache-2.0
// Runs the golden suite with a faulty renderer. One source file is compiled with a fault and linked into the
// program, and the suite must fail.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "golden/suite_run.h"

namespace poinsot {
namespace {

const Fault kFaults[] = {
    {"WindingTurned", "render/mesh_painter.cpp", "glFrontFace(GL_CW)", "glFrontFace(GL_CCW)"},
    {"SilhouettesNotResolved", "render/mesh_painter.cpp", "screen.isSilhouette(e) ||", ""},
    {"NormalsNotTurned", "render/mesh_painter.cpp", "emplace_back(screen.normals_C[i]",
     "emplace_back(glm::mat3(1)[i]"},
    {"LastCurveNotDrawn", "render/solid_painter.cpp", "for (const draw::Curve& c : list.curves)",
     "for (const draw::Curve& c : std::span(list.curves).first(list.curves.empty() ? 0 : list.curves.size() - "
     "1))"},
    {"DepthOfTheLastDrawn", "render/solid_painter.cpp", "glDepthFunc(GL_LESS)", "glDepthFunc(GL_ALWAYS)"},
    {"MaterialOfTheFirst", "render/solid_painter.cpp", "{f.material.color, 0}",
     "{list_->frustums.front().material.color, 0}"},
    {"SeamsNotDrawn", "render/solid_painter.cpp", "return solidCells_->shared(b);", "return b.left > 1e9f;"},
    {"OneTriangleTooFew", "render/solid_painter.cpp", "range.first, range.count)",
     "range.first, range.count - 3)"},
    {"FarSheetAsTheNear", "render/sheet_constants.cpp", "e.rimOpacity, e.nearOpacity",
     "e.rimOpacity, e.farOpacity"},
    {"ShadowOfThePlanesSize", "render/sheet_constants.cpp", "p.spacing_V / p.shadowRadius_V",
     "p.spacing_V / glm::length(p.u_V)"},
    {"LinesATwentiethTooWide", "render/curve_strip.cpp", "0.5f * curve.width_px", "0.525f * curve.width_px"},
    {"LettersAQuarterPixelOff", "render/text_painter.cpp", "size, x, y, outline", "size, x + 0.25, y, outline"},
    {"HalosLost", "render/text_painter.cpp",
     "place = blendCoverage(coverage(item, item.halo_px), *item.halo, item.opacity, picture);", "place = {};"},
    {"BlendedWithoutLight", "render/blend.cpp", "draw::linearFromSrgb(under_[c])",
     "static_cast<float>(under_[c]) / kMost"},
    {"FarPlaneNear", "render/constants.cpp", "1 / (camera.far - camera.near)", "1.0f"},
};

const std::string kBuild = POINSOT_BINARY_DIR;

/// Program with a fault in one of its files, built with the build's own commands.
class FaultyProgram {
 public:
  FaultyProgram(const ScratchFolder& folder, const Fault& fault) : folder_(folder) {
    std::ofstream(source_) << textWith(fault, POINSOT_SOURCE_DIR "/src");
    compile(fault.file);
    link();
  }

  const std::string& path() const { return program_; }

 private:
  static void expectDone(const ShellResult& result) { EXPECT_EQ(result.exitCode, 0) << result.out; }

  /// Compiles what the build compiles: the file, or a source that includes it and others. The faulty file replaces
  /// it there, so that the object defines the same functions as the library's.
  void compile(const std::string& file) const {
    expectDone(runShell(kBuild, fmt::format("set -e\n"
                                            "commands=$(ninja -t commands bin/poinsot | grep -- ' -c ')\n"
                                            "sources=$(printf '%s\\n' \"$commands\" | sed 's/.* -c //')\n"
                                            "if unit=$(printf '%s\\n' $sources | grep '/src/{0}$'); then\n"
                                            "  echo '#include \"{1}\"' > {2}\n"
                                            "else\n"
                                            "  unit=$(grep -l '#include \".*/src/{0}\"' $sources)\n"
                                            "  sed 's|#include \".*/src/{0}\"|#include \"{1}\"|' \"$unit\" > {2}\n"
                                            "fi\n"
                                            "command=$(printf '%s\\n' \"$commands\" | grep -F -- \" -c $unit\")\n"
                                            "${{command%% -MD *}} -o {3} -c {2}",
                                            file, source_, unit_, object_)));
  }

  /// Links the faulty object first, so that the linker does not take its symbols from the library.
  void link() const {
    expectDone(
        runShell(kBuild, fmt::format("command=$(ninja -t commands bin/poinsot | tail -1)\n"
                                     "faulty=$(printf %s \"$command\" | sed 's| -o bin/poinsot | {} -o {} |')\n"
                                     "[ \"$faulty\" != \"$command\" ] && eval \"$faulty\"",
                                     object_, program_)));
  }

  const ScratchFolder& folder_;
  const std::string source_ = (folder_ / "faulty.cpp").string(), unit_ = (folder_ / "unit.cpp").string(),
                    object_ = (folder_ / "faulty.o").string(), program_ = (folder_ / "poinsot").string();
};

class RendererFault : public testing::TestWithParam<Fault> {
 protected:
  ShellResult suiteWith(const Fault& fault) const {
    return runSuite(folder_, FaultyProgram(folder_, fault).path(), "tests/golden/golden.toml", kTestsOfEverything);
  }

  const ScratchFolder folder_;
};

TEST_P(RendererFault, IsCaught) { expectCaught(suiteWith(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Each, RendererFault, testing::ValuesIn(kFaults),
                         [](const auto& each) { return std::string(each.param.name); });

// Control: a file without a fault is compiled and linked in the same way.
TEST_F(RendererFault, ControlWithoutFaultPasses) {
  const ShellResult suite = suiteWith({"None", "render/blend.cpp", "namespace poinsot", "namespace poinsot"});
  EXPECT_EQ(suite.exitCode, 0) << suite.out;
}

}  // namespace
}  // namespace poinsot

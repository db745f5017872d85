// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "layering/layer_rules.h"
#include "layering/source_scan.h"

namespace poinsot::layering {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Layering, HasNoViolationsInThisSourceTree) {
  const Findings findings = checkSources(fs::path(POINSOT_SOURCE_DIR) / "src");
  EXPECT_THAT(findings.violations, IsEmpty());
  // Guards against a scan that silently reads nothing; the tree has passed these numbers for good.
  EXPECT_GT(findings.filesRead, 100);
  EXPECT_GT(findings.includesRead, 400);
}

TEST(Layering, AllowsOnlyLowerLayersToBeUsed) {
  std::vector<std::string> lower;
  for (const Layer& layer : layers()) {
    for (const std::string& used : layer.mayUse)
      EXPECT_THAT(lower, ::testing::Contains(used)) << layer.name << " uses " << used;
    lower.push_back(layer.name);
  }
}

/// Returns the libraries and what they may use, from the table in docs/architecture.md.
std::vector<std::string> documentedRows() {
  std::ifstream page(fs::path(POINSOT_SOURCE_DIR) / "docs/architecture.md");
  const std::regex row(R"(\| `(\w+)` \| [^|]* \| ([^|;]*?)(?:; [^|]*)?\| .*)");
  std::vector<std::string> rows;
  for (std::string line; std::getline(page, line);)
    if (std::smatch match; std::regex_match(line, match, row))
      rows.push_back(fmt::format("{}: {}", match.str(1), std::regex_replace(match.str(2), std::regex(" +$"), "")));
  return rows;
}

TEST(Layering, TableInTheDocsMatchesThisTest) {
  std::vector<std::string> rows;
  for (const Layer& layer : layers())
    rows.push_back(fmt::format("{}: {}", layer.name,
                               layer.name == "cli" ? "all" : fmt::format("{}", fmt::join(layer.mayUse, ", "))));
  EXPECT_THAT(documentedRows(), ::testing::UnorderedElementsAreArray(rows));
}

TEST(SourceScan, ReadsIncludesAndNotComments) {
  const auto found = includesOf(
      "#include \"core/a.h\"\n"
      "// #include \"core/b.h\"\n"
      "/* #include <c>\n#include <d>\n*/\n"
      "  #  include <e/f.hpp>  // why\n"
      "#include FT_OUTLINE_H\n"
      "int include = 1;\n");
  ASSERT_EQ(found.size(), 3u);
  EXPECT_EQ(found[0].name, "core/a.h");
  EXPECT_TRUE(found[0].quoted);
  EXPECT_EQ(found[1].name, "e/f.hpp");
  EXPECT_EQ(found[1].line, 6);
  EXPECT_FALSE(found[1].quoted);
  EXPECT_EQ(found[2].name, "FT_OUTLINE_H");
}

// ---- tests of the check itself: made-up trees with one fault each ----

class SampleTree : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::temp_directory_path() /
            ("poinsot-layering-" + std::string(test->name()) + "-" + std::to_string(getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& file, const std::string& text) const {
    fs::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << text;
  }
  std::vector<std::string> violations() const { return checkSources(root_).violations; }

 private:
  fs::path root_;
};

TEST_F(SampleTree, HasNoViolationsWithoutFaults) {
  write("physics/a.cpp",
        "#include \"physics/a.h\"\n#include <vector>\n#include <Eigen/Core>\n#include \"core/error.h\"\n");
  write("physics/CMakeLists.txt", "poinsot_layer(physics SOURCES a.cpp LINKS poinsot::core) # not poinsot::gl\n");
  write("image/png_file.cpp", "#include <png.h>\n");
  write("text/font.cpp", "#include <ft2build.h>\n#include FT_FREETYPE_H\n#include <hb-ot.h>\n");
  write("output/ffmpeg_library.h", "#include <libavcodec/avcodec.h>\n");
  write("gl/egl_context.cpp", "#include <EGL/egl.h>\n");
  EXPECT_THAT(violations(), IsEmpty());
}

TEST_F(SampleTree, ReportsIncludesOfHigherAndSiblingLayers) {
  write("core/a.h", "\n#include \"physics/b.h\"\n");
  write("render/a.cpp", "#include <physics/free_motion.h>\n");
  write("job/a.cpp", "#include \"cli/program.h\"\n");
  EXPECT_THAT(violations(), ElementsAre("core/a.h:2: core must not include physics/b.h",
                                        "job/a.cpp:1: job must not include cli/program.h",
                                        "render/a.cpp:1: render must not include physics/free_motion.h"));
}

TEST_F(SampleTree, ReportsForbiddenPairsOfLayersOnly) {
  for (const Layer& from : layers())
    for (const Layer& to : layers()) {
      write(from.name + "/a.h", "#include \"" + to.name + "/b.h\"\n");
      write(from.name + "/CMakeLists.txt", "target_link_libraries(x poinsot::" + to.name + ")\n");
      const bool allowed = from.name == to.name || std::ranges::find(from.mayUse, to.name) != from.mayUse.end();
      EXPECT_EQ(violations().size(), allowed ? 0u : 2u) << from.name << " -> " << to.name;
      write(from.name + "/a.h", "");
      write(from.name + "/CMakeLists.txt", "");
    }
}

TEST_F(SampleTree, ReportsForbiddenLinks) {
  write("scene/CMakeLists.txt", "poinsot_layer(scene\n  SOURCES a.cpp\n  LINKS poinsot::core poinsot::stage)\n");
  write("text/CMakeLists.txt", "target_link_libraries(poinsot_text PRIVATE poinsot_flags poinsot_image)\n");
  EXPECT_THAT(violations(), ElementsAre("scene/CMakeLists.txt:3: scene must not link poinsot::stage",
                                        "text/CMakeLists.txt:1: text must not link poinsot::image"));
}

TEST_F(SampleTree, ReportsThirdPartyHeadersOutsideTheirFiles) {
  const std::pair<const char*, const char*> kFaults[] = {{"image/image.cpp", "<png.h>"},
                                                         {"output/film.h", "<libavformat/avformat.h>"},
                                                         {"job/a.cpp", "<libswscale/swscale.h>"},
                                                         {"output/a.cpp", "<libavutil/crc.h>"},
                                                         {"output/palette.cpp", "<libimagequant.h>"},
                                                         {"gl/a.cpp", "<dlfcn.h>"},
                                                         {"scene/scene.h", "<toml++/toml.h>"},
                                                         {"stage/a.cpp", "<toml++/toml.h>"},
                                                         {"text/font.h", "<ft2build.h>"},
                                                         {"render/a.cpp", "<hb.h>"},
                                                         {"render/a.h", "FT_FREETYPE_H"},
                                                         {"render/a.cpp", "<EGL/egl.h>"},
                                                         {"job/a.cpp", "<GL/osmesa.h>"},
                                                         {"render/a.h", "<glad/gl.h>"},
                                                         {"stage/a.cpp", "<glad/gl.h>"},
                                                         {"draw/a.h", "<Eigen/Core>"},
                                                         {"gl/a.cpp", "<Eigen/Core>"},
                                                         {"render/a.cpp", "<Eigen/Core>"},
                                                         {"output/a.cpp", "<Eigen/Core>"},
                                                         {"text/a.cpp", "<Eigen/Core>"},
                                                         {"image/a.cpp", "<Eigen/Core>"},
                                                         {"physics/a.cpp", "<glm/vec3.hpp>"},
                                                         {"scene/a.h", "<glm/vec3.hpp>"},
                                                         {"job/a.cpp", "<CLI/CLI.hpp>"},
                                                         {"job/a.h", "<nlohmann/json.hpp>"},
                                                         {"render/a.cpp", "<cairo.h>"}};
  for (const auto& [file, header] : kFaults) {
    write(file, std::string("#include ") + header + "\n");
    EXPECT_EQ(violations().size(), 1u) << file << " " << header;
    write(file, "");
  }
}

TEST_F(SampleTree, ReportsFilesWithoutALayer) {
  write("render/a.cpp", "#include \"renderer.h\"\n");
  write("util/a.h", "#include <vector>\n");
  EXPECT_THAT(
      violations(),
      ElementsAre("render/a.cpp:1: \"renderer.h\" is in no layer; write \"layer/file.h\"",
                  "util/a.h:1: a folder of src/ that is no layer; add it to docs/architecture.md and here"));
}

}  // namespace
}  // namespace poinsot::layering

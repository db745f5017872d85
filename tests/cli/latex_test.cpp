// SPDX-License-Identifier: Apache-2.0
// Compiles the documents of latex/ with figures that the program makes, as an author does.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "support/program_run.h"

namespace poinsot {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kSource = POINSOT_SOURCE_DIR;

/// Racket that turns over about 0.96 s after its start, with its two arrows and nothing else.
const std::string kRacket =
    "[body]\ncatalogue = \"racket\"\n[motion]\nspin = \"1 rev/s\"\nspin_axis = \"middle\"\ntilt = \"1 deg\"\n"
    "[time]\nduration = 5\nspeed = 1\n[show]\nellipsoid = false\nplane = false\npolhode = false\nherpolhode = "
    "false\n"
    "contact = false\nheight = false\nprincipal_axes = false\n";

class LatexDocument : public ::testing::Test {
 protected:
  void SetUp() override {
    if (std::system("pdflatex -version >/dev/null 2>&1 && kpsewhich beamer.cls tikz.sty >/dev/null") != 0)
      GTEST_SKIP() << "pdflatex, TikZ or beamer is not installed";
  }

  /// Writes a scene of the gallery without its title, with further lines.
  void put(const std::string& name, const std::string& scene, const std::string& lines) {
    folder_.put(name, bytesOf(kSource + "/scenes/" + scene + ".toml") + lines);
  }
  /// Makes a figure with 8 pt type. Thin lines of small views are widened to 0.25 pt.
  void figure(std::vector<std::string> words) {
    words.insert(words.end(), {"--type", "8pt", "--dpi", "150", "-D", "style.theme=print", "-D",
                               "show.title=", "-D", "show.subtitle=", "-D", "style.line_width=1.7"});
    const RunResult result = run(folder_, words);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    EXPECT_THAT(result.err, Not(HasSubstr("thinnest line")));
    EXPECT_THAT(result.err, Not(HasSubstr("type")));
  }

  /// Compiles a document of latex/ and returns the log.
  std::string compiled(const std::string& name) {
    std::filesystem::copy_file(kSource + "/tests/cli/latex/" + name + ".tex", folder_ / (name + ".tex"));
    const std::string command = "cd '" + (folder_ / ".").string() + "' && pdflatex -interaction=nonstopmode " +
                                "-halt-on-error " + name + ".tex >/dev/null && test -s " + name + ".pdf";
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string log = bytesOf(folder_ / (name + ".log"));
    if (const char* kept = std::getenv("POINSOT_KEEP_LATEX"))
      std::filesystem::copy_file(folder_ / (name + ".pdf"), std::filesystem::path(kept) / (name + ".pdf"),
                                 std::filesystem::copy_options::overwrite_existing);
    return log;
  }

  ScratchFolder folder_;
};

/// Returns the sizes of all labels of a figure for TeX, in points of 1/72 inch. Their font has 10 pt of TeX.
std::set<std::string> sizesOf(const std::string& tex) {
  const std::regex scale("scale=([0-9.]+)");
  std::set<std::string> sizes;
  for (std::sregex_iterator each(tex.begin(), tex.end(), scale), end; each != end; ++each)
    sizes.insert(fmt::format("{:.1f}", 10 * 72 / 72.27 * std::stod((*each)[1])));
  return sizes;
}

// 8 pt, with 10/7 of it for L and omega, and 8/7 for titles: docs/figures.md.
TEST_F(LatexDocument, HandoutHasOneSizeOfType) {
  put("rolling.toml", "poinsot_rolling", "");
  put("plot.toml", "tennis_racket",
      "\n[[plot]]\nquantities = [\"omega_1\", \"omega_2\", \"omega_3\"]\ncursor = false\n");
  put("top.toml", "steady_top", "");
  folder_.put("racket.toml", kRacket);
  figure({"still", "rolling.toml", "--width", "82mm", "--size", "1000x900", "--crop", "-o", "out/rolling.tex"});
  figure({"still", "top.toml", "--width", "82mm", "--size", "1000x800", "--crop", "-o", "out/top.tex"});
  figure({"still", "plot.toml", "--width", "82mm", "--size", "1000x600", "-D", "show.views=false", "-o",
          "out/components.pdf"});
  figure({"sweep", "racket.toml", "--times", "0,0.85,0.96,1.1,1.9", "--width", "170mm", "--size", "1700x480", "-o",
          "out/instants.tex"});
  for (const char* name : {"rolling", "top", "instants"})
    for (const std::string& size : sizesOf(bytesOf(folder_ / "out" / (std::string(name) + ".tex"))))
      EXPECT_THAT(size, AnyOf("8.0", "11.4", "9.1")) << name;
  const std::string log = compiled("handout");
  EXPECT_THAT(log, Not(HasSubstr("Missing character")));
  EXPECT_THAT(log, Not(HasSubstr("Overfull \\hbox")));
  EXPECT_THAT(log, HasSubstr("Output written on handout.pdf (1 page"));
}

TEST_F(LatexDocument, SlideShowsTheFigure) {
  folder_.put("rolling.toml", bytesOf(kSource + "/scenes/poinsot_rolling.toml"));
  figure({"still", "rolling.toml", "--width", "72mm", "--size", "1000x900", "--crop", "-o", "out/rolling.tex"});
  const std::string log = compiled("slide");
  EXPECT_THAT(log, Not(HasSubstr("Missing character")));
  EXPECT_THAT(log, HasSubstr("Output written on slide.pdf (1 page"));
}

}  // namespace
}  // namespace poinsot

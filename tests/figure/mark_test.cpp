// SPDX-License-Identifier: Apache-2.0
#include "figure/mark.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "figure/figure.h"
#include "output/target_check.h"
#include "support/folder_test.h"

namespace poinsot::figure {
namespace {

using ::testing::HasSubstr;

class FigureMarkTest : public FolderTest {
 protected:
  /// Writes a small figure without OpenGL; its image part is blank.
  std::filesystem::path figure(const std::string& name) const {
    draw::Picture picture;
    picture.size_px = {160, 90};
    draw::Text label;
    label.tex = "$\\omega$";
    label.baseline_px = {20, 60};
    picture.texts.push_back(label);
    writeFigure(in(name), picture, image::Image({160, 90}, 3), {.title = "A title", .description = "One. Two."});
    return in(name);
  }
  std::filesystem::path edited(const std::filesystem::path& file, const std::string& from, const std::string& to) {
    const Bytes bytes = content(file);
    std::string text(bytes.begin(), bytes.end());
    text.replace(text.find(from), from.size(), to);
    save(file.filename(), text);
    return file;
  }
};

TEST_F(FigureMarkTest, RecognisesFiguresOfThisProgram) {
  for (const char* name : {"a.pdf", "a.svg", "a.tex"}) EXPECT_TRUE(isOwnFigure(figure(name))) << name;
  EXPECT_NO_THROW(output::checkTarget(in("a.pdf"), false));
}

TEST_F(FigureMarkTest, DoesNotClaimEditedFigures) {
  EXPECT_FALSE(isOwnFigure(edited(figure("a.tex"), "base west", "base east")));
  EXPECT_FALSE(isOwnFigure(edited(figure("a.svg"), "</svg>", "<circle r=\"9\"/></svg>")));
  EXPECT_FALSE(isOwnFigure(edited(figure("b.svg"), "A title", "My title")));
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { output::checkTarget(in("a.tex"), false); }),
              HasSubstr("--force"));
}

TEST_F(FigureMarkTest, DoesNotClaimFilesOfOtherPrograms) {
  save("notes.tex", "% poinsot rolls\n\\documentclass{article}");
  save("drawing.svg", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- poinsot 0.1.0 -->\n<svg/>");
  save("empty.svg", "");
  // pdfTeX keeps the information of a figure that it includes.
  save("notes.pdf",
       "%PDF-1.4\n7 0 obj\n<< /Creator (poinsot 0.1.0) >>\nendobj\n9 0 obj\n<< /Creator (TeX) >>\nendobj\n"
       "trailer\n<< /Info 9 0 R >>\n");
  save("broken.pdf", "%PDF-1.4\ntrailer\n<< /Info x 0 R >>\n/Creator (poinsot 0.1.0)");
  for (const char* name : {"notes.tex", "drawing.svg", "empty.svg", "notes.pdf", "broken.pdf", "missing.pdf", ""})
    EXPECT_FALSE(isOwnFigure(in(name))) << name;
}

TEST_F(FigureMarkTest, AFigureForLatexIsTwoFiles) {
  EXPECT_EQ(figureFiles("out/top.pdf"), std::vector<std::filesystem::path>{"out/top.pdf"});
  EXPECT_EQ(figureFiles("out/top.tex"),
            (std::vector<std::filesystem::path>{"out/top-unlabelled.png", "out/top.tex"}));
  EXPECT_THAT(messageOf(core::ErrorKind::kUsage, [] { figureFiles("50%.tex"); }), HasSubstr("LaTeX cannot load"));
}

}  // namespace
}  // namespace poinsot::figure

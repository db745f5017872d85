// SPDX-License-Identifier: Apache-2.0
#include "app/output_target.h"

#include <gtest/gtest.h>

#include "core/error.h"

namespace poinsot::app {
namespace {

TEST(OutputTarget, KindIsInTheName) {
  for (const char* film : {"out/a.mp4", "a.mov", "a.webm", "a.gif", "a.apng"})
    EXPECT_EQ(parseTarget(film).kind, OutputKind::kFilm) << film;
  EXPECT_EQ(parseTarget("out/a.png").kind, OutputKind::kPicture);
  EXPECT_EQ(parseTarget("out/a_{frame}.png").kind, OutputKind::kSequence);
  EXPECT_EQ(parseTarget("out/{frame:05}.png").kind, OutputKind::kSequence);
  EXPECT_EQ(parseTarget("out/a.png").path, "out/a.png");
}

TEST(OutputTarget, RefusesOtherNames) {
  for (const char* bad : {"", "out/", "a", "a.avi", "a.MP4", ".mp4", "a_{frame}.mp4", "a_{frame:5}.png",
                          "a_{n}.png", "{frame}_{frame}.png", "x{frame}/a.png", "a}.png"}) {
    try {
      parseTarget(bad);
      ADD_FAILURE() << "accepted: " << bad;
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      EXPECT_NE(std::string(error.what()).find("{frame:05}.png"), std::string::npos) << error.what();
    }
  }
}

TEST(OutputTarget, AStillIsAPictureOrAFigure) {
  EXPECT_EQ(parseStillTarget("out/a.png").kind, OutputKind::kPicture);
  for (const char* figure : {"out/a.pdf", "a.svg", "a.b.tex"}) {
    EXPECT_EQ(parseStillTarget(figure).kind, OutputKind::kFigure);
    EXPECT_THROW(parseTarget(figure), core::Error);  // of a film there is none
  }
  for (const char* bad : {"", "a", "a.mp4", "a_{frame}.png", ".pdf", "a.PDF", "out/"}) {
    try {
      parseStillTarget(bad);
      ADD_FAILURE() << "accepted: " << bad;
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      EXPECT_NE(std::string(error.what()).find("NAME.png, NAME.pdf, NAME.svg or NAME.tex"), std::string::npos);
    }
  }
}

TEST(OutputTarget, SaysWhatWorks) {
  try {
    parseTarget("a.avi");
    FAIL() << "accepted an .avi";
  } catch (const core::Error& error) {
    EXPECT_STREQ(error.what(),
                 "output 'a.avi': this kind of file is not written; works: NAME.mp4, NAME.mov, NAME.webm, "
                 "NAME.gif, NAME.apng (a film), NAME.png (one frame), "
                 "NAME_{frame:05}.png (a numbered picture per frame)");
  }
}

}  // namespace
}  // namespace poinsot::app

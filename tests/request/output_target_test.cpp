// SPDX-License-Identifier: Apache-2.0
#include "request/output_target.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "core/text.h"

namespace poinsot::request {
namespace {

TEST(OutputTarget, KindFollowsFromTheFileName) {
  for (const char* film : {"out/a.mp4", "a.mov", "a.webm", "a.gif", "a.apng"})
    EXPECT_EQ(parseTarget(film).kind, OutputKind::kFilm) << film;
  EXPECT_EQ(parseTarget("out/a.png").kind, OutputKind::kPicture);
  EXPECT_EQ(parseTarget("out/a_{frame}.png").kind, OutputKind::kSequence);
  EXPECT_EQ(parseTarget("out/{frame:05}.png").kind, OutputKind::kSequence);
  EXPECT_EQ(parseTarget("out/a.png").path, "out/a.png");
}

TEST(OutputTarget, RejectsUnsupportedNames) {
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
    EXPECT_THROW(parseTarget(figure), core::Error);  // a film cannot be a figure
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

std::string refusal(OutputTarget (*parse)(const std::string&), const std::string& name) try {
  parse(name);
  return "accepted";
} catch (const core::Error& error) {
  return error.what();
}

TEST(OutputTarget, SuggestsLowerCaseEndings) {
  for (const char* name : {"a.MP4", "a.Mov", "a.WEBM", "a.GIF", "a.APNG", "a.PNG", "a_{frame}.PNG"}) {
    const std::string small = core::lowered(name);
    EXPECT_NE(refusal(parseTarget, name).find("unsupported file type; write the ending in lower case: " + small),
              std::string::npos)
        << name;
    EXPECT_NO_THROW(parseTarget(small));
  }
  for (const char* name : {"a.PNG", "a.PDF", "a.Svg", "a.TEX"}) {
    const std::string small = core::lowered(name);
    EXPECT_NE(refusal(parseStillTarget, name).find("NAME.tex; write the ending in lower case: " + small),
              std::string::npos)
        << name;
    EXPECT_NO_THROW(parseStillTarget(small));
  }
  EXPECT_EQ(refusal(parseTarget, "a.AVI").find("lower case"), std::string::npos);
}

TEST(OutputTarget, ExplainsHowToWriteToStandardOutput) {
  for (const char* name : {"-", "/dev/stdout"})
    EXPECT_NE(refusal(parseStillTarget, name)
                  .find("for standard output use poinsot render --format png -o - --frames K"),
              std::string::npos)
        << name;
  EXPECT_NE(
      refusal(parseTarget, "/dev/stdout").find("for standard output give -o - with --format png or --format mp4"),
      std::string::npos);
}

TEST(OutputTarget, ListsPossibleNamesInErrors) {
  try {
    parseTarget("a.avi");
    FAIL() << "accepted an .avi";
  } catch (const core::Error& error) {
    EXPECT_STREQ(error.what(),
                 "output 'a.avi': unsupported file type; possible names: NAME.mp4, NAME.mov, NAME.webm, NAME.gif, "
                 "NAME.apng (a film), NAME.png (one frame), NAME_{frame:05}.png (a numbered picture per frame)");
  }
}

}  // namespace
}  // namespace poinsot::request

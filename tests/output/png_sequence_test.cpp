// SPDX-License-Identifier: Apache-2.0
#include "output/png_sequence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/library_versions.h"
#include "support/folder_test.h"

namespace poinsot::output {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

image::Image grey(std::uint8_t value) {
  image::Image picture({5, 3}, 3);
  picture.pixels.assign(picture.pixels.size(), value);
  return picture;
}

class PngSequenceTest : public FolderTest {};

TEST_F(PngSequenceTest, WritesEachFrameUnderItsNumber) {
  PngSequence sink(FramePattern(in("frames/f_{frame:04}.png")), {{{"Title", "Polhode"}}, {}, false, {}});
  sink.write({grey(10)}, 8);
  EXPECT_EQ(image::readPng(in("frames/f_0008.png")), grey(10));  // at once, not only at the end
  sink.write({grey(20)}, 9);
  sink.finish();
  sink.finish();  // nothing new to sync
  EXPECT_EQ(image::readPng(in("frames/f_0009.png")), grey(20));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(in("frames")), {}), 2);
  EXPECT_TRUE(image::isOwnPng(in("frames/f_0008.png")));
}

TEST_F(PngSequenceTest, WritesSixteenBits) {
  image::DeepImage picture({2, 1}, 3);
  picture.pixels = {0, 257, 514, 20000, 65535, 1};
  PngSequence(FramePattern(in("f_{frame}.png"))).write({picture}, 1);
  EXPECT_EQ(content(in("f_1.png")).at(24), 16);  // bit depth in IHDR
  EXPECT_EQ(image::readPng(in("f_1.png")).pixels, (std::vector<std::uint8_t>{0, 1, 2, 78, 255, 0}));
}

TEST_F(PngSequenceTest, WritesTheSameBytesEachTime) {
  PngSequence(FramePattern(in("a_{frame}.png"))).write({grey(10)}, 1);
  PngSequence(FramePattern(in("b_{frame}.png"))).write({grey(10)}, 1);
  EXPECT_EQ(content(in("a_1.png")), content(in("b_1.png")));
}

TEST_F(PngSequenceTest, CreatesAtMostOneFolder) {
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { PngSequence(FramePattern(in("no/such/f_{frame}.png"))); }),
              HasSubstr("folder cannot be created: No such file or directory"));
  save("file", "x");
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { PngSequence(FramePattern(in("file/f_{frame}.png"))); }),
              HasSubstr("folder cannot be created"));
  EXPECT_THAT(names(), ElementsAre("file"));
}

TEST_F(PngSequenceTest, FinishFailsForAFrameThatIsGone) {
  PngSequence sink(FramePattern(in("f_{frame}.png")));
  sink.write({grey(10)}, 1);
  std::filesystem::remove(in("f_1.png"));
  EXPECT_THAT(messageOf(core::ErrorKind::kIo, [&] { sink.finish(); }), HasSubstr("f_1.png: cannot be synced"));
}

TEST_F(PngSequenceTest, WritesOnePicture) {
  writePng(in("one.png"), grey(30), {{"Title", "one"}});
  EXPECT_EQ(image::readPng(in("one.png")), grey(30));
  EXPECT_THAT(names(), ElementsAre("one.png"));
}

TEST(LibraryVersions, NameTheLoadedLibraries) {
  const auto versions = libraryVersions();
  ASSERT_EQ(versions.size(), 4u);
  const char* expected[] = {"libpng", "libavcodec", "libavformat", "x264"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(versions[i].name, expected[i]);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_THAT(versions[i].version, ::testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+"));
  EXPECT_THAT(versions[3].version, ::testing::MatchesRegex("core [0-9]+.*"));
}

}  // namespace
}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
#include "request/output_target.h"

#include <gtest/gtest.h>

#include "scene/limits.h"

namespace poinsot::request {
namespace {

output::FilmFormat chosen(const std::string& file, const scene::Output& asked = {}, bool transparent = false) {
  PictureOptions form;
  form.transparent = transparent;
  return filmFormat({OutputKind::kFilm, file}, asked, form);
}

// Each codec name of a scene is the name of a codec of the output layer.
TEST(FilmChoice, AcceptsEveryCodecThatASceneCanName) {
  for (const std::string_view word : scene::codecWords()) {
    scene::Output asked;
    asked.codec = word;
    EXPECT_EQ(output::nameOf(chosen("a.mp4", asked).codec), word);
  }
}

TEST(FilmChoice, DefaultsToTheUsualCodecOfTheFileType) {
  EXPECT_EQ(chosen("a.mp4").codec, output::FilmCodec::kH264);
  EXPECT_EQ(chosen("a.webm").codec, output::FilmCodec::kVp9);
  EXPECT_EQ(chosen("a.mov").codec, output::FilmCodec::kProRes);
  EXPECT_EQ(chosen("a.gif").codec, output::FilmCodec::kGif);
  EXPECT_EQ(chosen("a.apng", {}, true).transparent, true);
}

TEST(FilmChoice, TakesCrfChromaAndEffortFromTheScene) {
  scene::Output asked;
  asked.crf = 7;
  EXPECT_EQ(chosen("a.mp4", asked).crf, 7);
  EXPECT_EQ(chosen("a.mp4").chroma, output::Chroma::k420);
  EXPECT_EQ(chosen("a.mp4").effort, output::Effort::kMedium);
  asked.chroma = scene::chromaWords()[1];
  EXPECT_EQ(chosen("a.mp4", asked).chroma, output::Chroma::k444);
  asked.effort = scene::effortWords()[0];
  EXPECT_EQ(chosen("a.mp4", asked).effort, output::Effort::kFast);
  asked.effort = scene::effortWords()[2];
  EXPECT_EQ(chosen("a.mp4", asked).effort, output::Effort::kSlow);
}

}  // namespace
}  // namespace poinsot::request

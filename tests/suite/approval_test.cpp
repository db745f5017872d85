// SPDX-License-Identifier: Apache-2.0
// Only the picture that was drawn and compared may become a reference.
#include "suite/approval.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/atomic_file.h"
#include "image/pixel_digest.h"
#include "image/png_file.h"
#include "support/scratch_folder.h"

namespace poinsot::suite {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

template <class Picture>
Picture counting(image::PixelSize size, int channels) {
  Picture picture(size, channels);
  for (std::size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] = static_cast<typename decltype(picture.pixels)::value_type>(i);
  return picture;
}

TEST(PixelDigest, DistinguishesPicturesAndIsUnchangedByPng) {
  const ScratchFolder folder;
  image::Image changed = counting<image::Image>({4, 6}, 3);
  changed.pixels.back() ^= 1;
  std::set<std::string> digests;
  const auto add = [&](const auto& picture) {
    const std::string digest = image::pixelDigest(picture);
    EXPECT_TRUE(digests.insert(digest).second);
    core::writeFileAtomically(folder / "a.png", image::encodePng(picture, {{"Title", "any"}}));
    EXPECT_EQ(pixelDigestOf(folder / "a.png", false), digest);
  };
  add(counting<image::Image>({4, 6}, 3));
  add(counting<image::Image>({6, 4}, 3));
  add(counting<image::Image>({3, 6}, 4));
  add(counting<image::DeepImage>({4, 6}, 3));
  add(changed);
}

class GoldenApprovalTest : public ::testing::Test {
 protected:
  /// Returns the outcome of a new picture, as a run leaves it.
  compare::Outcome drawn(const std::string& name, int size) const {
    const auto picture = counting<image::Image>({size, size}, 3);
    compare::Outcome outcome;
    outcome.name = name;
    outcome.actual = folder_ / (name + ".png");
    outcome.pixels = image::pixelDigest(picture);
    core::writeFileAtomically(outcome.actual, image::encodePng(picture));
    return outcome;
  }

  static GoldenName nameOf(const compare::Outcome& outcome) { return {outcome.name, ".png"}; }

  ScratchFolder folder_;
  fs::path references_ = folder_ / "ref";
};

TEST_F(GoldenApprovalTest, RejectsAPictureThatChangedAfterComparison) {
  const compare::Outcome a = drawn("a", 4), b = drawn("b", 5);
  drawn("b", 6);  // replaces the picture
  GoldenApproval approval(references_, false);
  approval.add(nameOf(a), a);
  try {
    approval.add(nameOf(b), b);
    ADD_FAILURE() << "approved";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
    EXPECT_THAT(error.what(),
                HasSubstr("b.png: is no longer the picture that was compared; nothing was approved"));
  }
  EXPECT_FALSE(fs::exists(references_ / "a.png"));
}

TEST_F(GoldenApprovalTest, ChangesNothingBeforeItIsCommitted) {
  const compare::Outcome a = drawn("a", 4);
  { GoldenApproval(references_, false).add(nameOf(a), a); }
  EXPECT_TRUE(fs::is_empty(references_));
  GoldenApproval approval(references_, false);
  EXPECT_EQ(approval.add(nameOf(a), a).place, references_ / "a.png");
  approval.commit();
  EXPECT_EQ(pixelDigestOf(references_ / "a.png", false), a.pixels);
  EXPECT_TRUE(fs::exists(references_ / "a.json"));
}

// The file of the test a@x has the name that a reference of the test a for the renderer x would have.
TEST_F(GoldenApprovalTest, KeepsTheReferencesOfOtherTests) {
  compare::Outcome other = drawn("a@x", 4), mine = drawn("a", 5);
  other.origin.renderer = "x";
  mine.origin.renderer = "y";
  const GoldenName name{"a", ".png", {"a@x"}};
  GoldenApproval first(references_, false);
  first.add(nameOf(other), other);
  first.add(name, mine);
  first.commit();
  EXPECT_EQ(referencesOf(references_, name).size(), 1U);
  EXPECT_EQ(referencesOf(references_, nameOf(mine)).size(), 2U);  // if there were no test a@x

  mine.origin.renderer = "x";
  GoldenApproval second(references_, true);
  try {
    second.add(name, mine);
    ADD_FAILURE() << "approved";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
    EXPECT_THAT(error.what(),
                HasSubstr("ref/a@x.png: is the reference of the test 'a@x'; the reference of 'x' would have"));
  }
  GoldenApproval third(references_, false);
  EXPECT_TRUE(third.add(name, mine).removed.empty());
}

}  // namespace
}  // namespace poinsot::suite

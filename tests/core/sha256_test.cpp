// SPDX-License-Identifier: Apache-2.0
// The examples of FIPS 180-4 (NIST's "SHA256.pdf" of example values).
#include "core/sha256.h"

#include <gtest/gtest.h>

namespace poinsot::core {
namespace {

TEST(Sha256, MatchesThePublishedExamples) {
  EXPECT_EQ(toHex(sha256("abc")), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(toHex(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(toHex(sha256("")), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, DoesNotDependOnTheSizeOfChunks) {
  Sha256 sum;
  for (const char c : std::string("abc")) sum.add(std::string_view(&c, 1));
  EXPECT_EQ(sum.finish(), sha256("abc"));
}

}  // namespace
}  // namespace poinsot::core

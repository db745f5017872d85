// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "cli/option_values.h"
#include "core/error.h"

namespace poinsot::cli {
namespace {

std::int64_t parsed(const std::string& word) { return parseFileSize_bytes("--max-size", word); }

TEST(FileSize, AcceptsBytesAndPowersOf1000And1024) {
  EXPECT_EQ(parsed("500000"), 500'000);
  EXPECT_EQ(parsed("800kB"), 800'000);
  EXPECT_EQ(parsed("5MB"), 5'000'000);
  EXPECT_EQ(parsed("1.5 MB"), 1'500'000);
  EXPECT_EQ(parsed("2GB"), 2'000'000'000);
  EXPECT_EQ(parsed("1KiB"), 1024);
  EXPECT_EQ(parsed("2MiB"), 2'097'152);
  EXPECT_EQ(parsed("1GiB"), 1'073'741'824);
}

TEST(FileSize, RejectsOtherTextWithItsValue) {
  for (const char* word : {"0", "-5MB", "5mb", "5M", "5 Mbit", "MB", "nan", "infMB", "1e300", "5MB ", "0x5MB"}) {
    try {
      parsed(word);
      ADD_FAILURE() << word;
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      EXPECT_THAT(error.what(), testing::HasSubstr("--max-size '" + std::string(word) + "': must be")) << word;
      EXPECT_THAT(error.what(), testing::HasSubstr("such as 5MB")) << word;
    }
  }
}

TEST(FileSize, WritesThreeDigits) {
  EXPECT_EQ(fileSizeText(999), "999 bytes");
  EXPECT_EQ(fileSizeText(1000), "1 kB");
  EXPECT_EQ(fileSizeText(212'345), "212 kB");
  EXPECT_EQ(fileSizeText(999'600), "1 MB");
  EXPECT_EQ(fileSizeText(4'630'211), "4.63 MB");
  EXPECT_EQ(fileSizeText(2'500'000'000), "2.5 GB");
}

}  // namespace
}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"

#include <gtest/gtest.h>

#include "core/expect.h"

namespace poinsot::core {
namespace {

TEST(Error, FormatsLocationAndMessage) {
  const Error error(ErrorKind::kScene, "unknown key", SourceLocation{"a.toml", 3, 7});
  EXPECT_STREQ(error.what(), "a.toml:3:7: unknown key");
  EXPECT_EQ(error.message(), "unknown key");
  EXPECT_EQ(error.kind(), ErrorKind::kScene);
  EXPECT_STREQ(Error(ErrorKind::kIo, "full").what(), "full");
  EXPECT_EQ(toString({"a.toml", 3, 0}), "a.toml:3");
  EXPECT_EQ(toString({"a.toml", 0, 0}), "a.toml");
}

TEST(Expect, ThrowsALogicErrorThatNamesTheCondition) {
  try {
    POINSOT_EXPECT(1 + 1 == 3);
    FAIL() << "nothing was thrown";
  } catch (const std::logic_error& error) {
    EXPECT_NE(std::string(error.what()).find("broken contract: 1 + 1 == 3"), std::string::npos) << error.what();
  }
  EXPECT_NO_THROW(POINSOT_EXPECT(true));
}

}  // namespace
}  // namespace poinsot::core

// SPDX-License-Identifier: Apache-2.0
#include "process/line_channel.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "support/pipe.h"

namespace poinsot::process {
namespace {

TEST(LineChannel, JoinsLinesAcrossPartialReads) {
  Pipe pipe;
  LineReader reader(pipe.read.get());
  ASSERT_EQ(writeText(pipe.write.get(), "one\ntwo\nth"), 0);
  ASSERT_TRUE(reader.fill());
  EXPECT_EQ(reader.take(), "one");
  EXPECT_EQ(reader.take(), "two");
  EXPECT_EQ(reader.take(), std::nullopt);
  ASSERT_EQ(writeText(pipe.write.get(), "ree\n\n"), 0);
  EXPECT_EQ(reader.wait(), "three");
  EXPECT_EQ(reader.wait(), "");
  pipe.write.reset();
  EXPECT_EQ(reader.wait(), std::nullopt);
}

TEST(LineChannel, ReportsAClosedReaderInsteadOfExiting) {
  std::signal(SIGPIPE, SIG_IGN);
  Pipe pipe;
  EXPECT_TRUE(writeLine(pipe.write.get(), "heard"));
  pipe.read.reset();
  EXPECT_FALSE(writeLine(pipe.write.get(), "unheard"));
  EXPECT_EQ(writeText(pipe.write.get(), "x"), EPIPE);
}

}  // namespace
}  // namespace poinsot::process

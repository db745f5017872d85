// SPDX-License-Identifier: Apache-2.0
// Segments of one film are made by machines of different ages (docs/clusters.md): the processor does not change a
// byte of what x264 makes. Others are emulated.
#include <gtest/gtest.h>

#include <string>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot::output {
namespace {

struct Printed {
  std::string units, hashes;
};

Printed printedBy(const std::string& emulator) {
  const ScratchFolder folder;
  const ShellResult result = runShell(folder.path(), emulator + " " POINSOT_FILM_HASH " film.mp4");
  EXPECT_EQ(result.exitCode, 0) << result.out;
  const auto line = result.out.find('\n') + 1;
  return {result.out.substr(0, line), result.out.substr(line)};
}

// x264 as it comes picks its ways by the processor: this film is another one with no more than SSE2, and with
// trees of macroblocks another one wherever reciprocals are.
TEST(FilmOnAnotherProcessor, IsTheSameBytes) {
  if (!isInstalled("qemu-x86_64")) GTEST_SKIP() << "qemu-x86_64 is not installed (Debian: qemu-user)";
  const std::string here = printedBy("").hashes;
  EXPECT_EQ(here.size(), 2u * 65);
  const Printed oldest = printedBy("qemu-x86_64 -cpu qemu64"), of2008 = printedBy("qemu-x86_64 -cpu Nehalem");
  EXPECT_EQ(oldest.units, "ssse3=0 avx2=0\n");
  EXPECT_EQ(of2008.units, "ssse3=1 avx2=0\n");
  EXPECT_EQ(oldest.hashes, here);
  EXPECT_EQ(of2008.hashes, here);
}

}  // namespace
}  // namespace poinsot::output

// SPDX-License-Identifier: Apache-2.0
// Another CPU changes no pixel that --reproducible draws, no byte of its PNG file, and no bit of a trajectory. The
// other CPU, of 2008, has neither FMA nor AVX and is emulated.
#include <gtest/gtest.h>

#include <string>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot {
namespace {

struct Printed {
  std::string cpu, hashes;
};

/// Returns the output of a program; the first line describes the CPU.
Printed printedBy(const std::string& command, const std::vector<std::string>& environment = {}) {
  const ScratchFolder folder;
  const ShellResult result = runShell(folder.path(), command, environment);
  EXPECT_EQ(result.exitCode, 0) << command << "\n" << result.out;
  const auto line = result.out.find('\n') + 1;
  return {result.out.substr(0, line), result.out.substr(line)};
}

std::string pictures(const std::string& options = "") {
  std::string command = POINSOT_PICTURE_HASH + options;
  for (const char* name : {"poinsot_construction", "football", "cones_oblate", "t_handle"})
    command += std::string(" " POINSOT_SOURCE_DIR "/scenes/") + name + ".toml";
  return command;
}

class AnyCpu : public testing::Test {
 protected:
  void SetUp() override {
    if (!__builtin_cpu_supports("fma"))
      GTEST_SKIP() << "this CPU has no FMA, so that there is nothing to compare with";
  }
};

class EmulatedCpu : public AnyCpu {
 protected:
  void SetUp() override {
    AnyCpu::SetUp();
    if (!isInstalled("qemu-x86_64")) GTEST_SKIP() << "qemu-x86_64 is not installed (Debian: qemu-user)";
  }
};

const std::string kNehalem = "qemu-x86_64 -cpu Nehalem ";

TEST_F(AnyCpu, DrawsTheSamePixelsIfTheCLibrarySeesNoFma) {
  // Names since glibc 2.33, and the earlier names.
  const std::string hidden = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable";
  EXPECT_EQ(printedBy(pictures(), {hidden}).hashes, printedBy(pictures()).hashes);
}

TEST_F(EmulatedCpu, DrawsTheSamePixelsIntoTheSameFiles) {
  const Printed here = printedBy(pictures()), there = printedBy(kNehalem + pictures());
  EXPECT_EQ(here.cpu, "avx2=1 fma=1\n");
  EXPECT_EQ(there.cpu, "avx2=0 fma=0\n");
  EXPECT_EQ(there.hashes, here.hashes);
  EXPECT_EQ(here.hashes.size(), 4u * 2 * 65);
  // Control: without pinning, the driver uses all features of the CPU, which changes the pixels.
  EXPECT_NE(printedBy(pictures(" --unpinned")).hashes, here.hashes);
}

TEST_F(EmulatedCpu, ComputesTheSameTrajectory) {
  EXPECT_EQ(printedBy(kNehalem + POINSOT_TRAJECTORY_HASH).cpu, printedBy(POINSOT_TRAJECTORY_HASH).cpu);
  // Control: the C library's functions do differ.
  EXPECT_NE(printedBy(kNehalem + POINSOT_TRAJECTORY_HASH " --libm").cpu,
            printedBy(POINSOT_TRAJECTORY_HASH " --libm").cpu);
}

}  // namespace
}  // namespace poinsot

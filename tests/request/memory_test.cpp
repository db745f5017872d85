// SPDX-License-Identifier: Apache-2.0
#include "request/memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

#include "support/scratch_folder.h"

namespace poinsot::request {
namespace {

constexpr double kMib = 1 << 20;

/// Scratch root folder with the /proc and /sys files in which a kernel reports memory.
class FreeMemoryTest : public testing::Test {
 protected:
  void say(const std::string& file, const std::string& text) const {
    std::filesystem::create_directories((folder_ / file).parent_path());
    folder_.put(file, text);
  }
  void sayMachine() const {
    say("proc/meminfo",
        "MemTotal:  4096 kB\nMemFree:  10 kB\nMemAvailable:  3072 kB\nSwapTotal: 9 kB\nSwapFree:  1024 kB\n");
  }
  double machine_MiB() const { return freeMemory(folder_.path()).machine_bytes / kMib; }

  ScratchFolder folder_;
};

TEST_F(FreeMemoryTest, IsTheAvailableMemoryPlusFreeSwap) {
  sayMachine();
  EXPECT_EQ(machine_MiB(), 4);
  EXPECT_GT(freeMemory().machine_bytes, kMib);  // memory of this machine
  EXPECT_TRUE(std::isfinite(freeMemory().machine_bytes));
}

TEST_F(FreeMemoryTest, IsUnboundedIfTheKernelReportsNothing) { EXPECT_TRUE(std::isinf(machine_MiB())); }

// The group uses 1.5 of its 2 MiB. Cached files take 1 MiB, half of which belongs to a tmpfs and cannot be freed.
TEST_F(FreeMemoryTest, IsLimitedByControlGroups) {
  sayMachine();
  say("proc/self/cgroup", "3:cpu:/other\n0::/slurm/job_7\n");
  say("sys/fs/cgroup/slurm/memory.max", "2097152\n");
  say("sys/fs/cgroup/slurm/memory.current", "1572864\n");
  say("sys/fs/cgroup/slurm/memory.stat", "anon 1\nfile 1048576\nshmem 524288\n");
  say("sys/fs/cgroup/slurm/job_7/memory.max", "max\n");
  EXPECT_EQ(machine_MiB(), 1);
  say("sys/fs/cgroup/slurm/job_7/memory.max", "262144\n");
  EXPECT_EQ(machine_MiB(), 0.25);
  say("sys/fs/cgroup/memory.max", "131072\n");  // a limit at the root, as in a container
  EXPECT_EQ(machine_MiB(), 0.125);
}

TEST_F(FreeMemoryTest, IsLimitedByTheAddressSpaceOfAProcess) {
  constexpr rlim_t kLimit_bytes = rlim_t{1} << 46;  // more than AddressSanitizer reserves
  const pid_t child = ::fork();
  if (child == 0) {
    const rlimit limit{kLimit_bytes, kLimit_bytes};
    ::setrlimit(RLIMIT_AS, &limit);
    ::_exit(freeMemory().process_bytes == kLimit_bytes ? 0 : 1);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

TEST(WorkersThatFit, AreLimitedByTheFreeMemory) {
  const double unbounded = INFINITY;
  EXPECT_EQ(workersThatFit(4, 100, {400, unbounded}), 4);
  EXPECT_EQ(workersThatFit(4, 100, {399, unbounded}), 3);
  EXPECT_EQ(workersThatFit(4, 100, {99, unbounded}), 0);
  EXPECT_EQ(workersThatFit(4, 100, {-5, unbounded}), 0);
  EXPECT_EQ(workersThatFit(4, 100, {unbounded, unbounded}), 4);
  EXPECT_EQ(workersThatFit(4, 100, {unbounded, 100}), 4);
  EXPECT_EQ(workersThatFit(4, 100, {unbounded, 99}), 0);
}

TEST(WorkerMemory, GrowsWithThePictureAndTheEncoder) {
  const image::PixelSize small{1920, 1080}, large{3840, 2160};
  output::FilmFormat fine;
  fine.chroma = output::Chroma::k444;
  EXPECT_LT(workerMemory_bytes(small, {}), workerMemory_bytes(small, output::FilmFormat()));
  // Measured with 16 bits at 3840x2160: 768 MiB, or 858 MiB if solids fill the picture.
  EXPECT_NEAR(workerMemory_bytes(large, {}, 16), 768 * kMib, 30 * kMib);
  const OutputTarget sequence{OutputKind::kSequence, "{frame:05}.png"};
  scene::Output asked;
  asked.width = large.width;
  asked.height = large.height;
  EXPECT_EQ(workerMemory_bytes(sequence, asked, {std::nullopt, true, 16}), workerMemory_bytes(large, {}, 16));
  EXPECT_LT(workerMemory_bytes(small, output::FilmFormat()), workerMemory_bytes(small, fine));
  EXPECT_LT(workerMemory_bytes(large, output::FilmFormat()), 1024 * kMib);  // promised limit for 4K
}

// Each cell of a sweep loads its own copy of the scene's meshes.
TEST(WorkerMemory, IncludesTheMeshesOfAllSweepCells) {
  auto mesh = std::make_shared<geometry::Mesh>();
  mesh->triangles.resize(1000);
  scene::Scene scene;
  scene.body.parts.push_back({.figure = mesh});
  const OutputTarget picture{OutputKind::kPicture, "a.png"};
  const double one = workerMemory_bytes(picture, RequestedScene{{}, scene}, {});
  const double nine = workerMemory_bytes(picture, RequestedScene{{}, scene, std::vector(9, scene)}, {});
  EXPECT_EQ(nine - one, 8 * meshMemory_bytes(scene));
  EXPECT_GE(meshMemory_bytes(scene), 1000 * 3 * sizeof(float));
}

}  // namespace
}  // namespace poinsot::request

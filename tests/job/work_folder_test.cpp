// SPDX-License-Identifier: Apache-2.0
#include "job/work_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"
#include "support/scratch_folder.h"

namespace poinsot::job {
namespace {

namespace fs = std::filesystem;

TEST(WorkFolder, IsNextToTheTargetAndIsRemovedAtTheEnd) {
  const ScratchFolder scratch;
  {
    const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kFresh);
    EXPECT_EQ(folder.path(), scratch / ".film.mp4.poinsot");
    std::ofstream(folder.path() / ".segment-1.tmp") << "x";
    std::ofstream(folder.path() / "job.json") << "{}";
  }
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

// Segments are finished work; they are discarded only when all of the film is made.
TEST(WorkFolder, KeepsSegmentsUntilTheyAreDiscarded) {
  const ScratchFolder scratch;
  const fs::path segment = scratch / ".film.mp4.poinsot/segment-000000000-000000029.mp4";
  {
    const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kFresh);
    std::ofstream(segment) << "x";
  }
  EXPECT_TRUE(fs::exists(segment));
  { const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kResumed); }
  EXPECT_TRUE(fs::exists(segment));
  WorkFolder(scratch / "film.mp4", WorkFolderUse::kResumed).discard();
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(WorkFolder, IsSharedByShardsOnly) {
  const ScratchFolder scratch;
  {
    const WorkFolder one(scratch / "film.mp4", WorkFolderUse::kShared);
    const WorkFolder two(scratch / "film.mp4", WorkFolderUse::kShared);
    EXPECT_THROW(WorkFolder(scratch / "film.mp4", WorkFolderUse::kResumed), core::Error);
  }
  EXPECT_TRUE(fs::exists(scratch / ".film.mp4.poinsot"));  // another shard may have just begun
  const WorkFolder whole(scratch / "film.mp4", WorkFolderUse::kResumed);
  EXPECT_THROW(WorkFolder(scratch / "film.mp4", WorkFolderUse::kShared), core::Error);
}

TEST(WorkFolder, IsLockedByOneRenderAtATime) {
  const ScratchFolder scratch;
  const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kFresh);
  try {
    const WorkFolder second(scratch / "film.mp4", WorkFolderUse::kFresh);
    FAIL() << "two renders hold one folder";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
    EXPECT_NE(std::string(error.what()).find("another poinsot"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::is_directory(folder.path()));
}

TEST(WorkFolder, TakesOverTheFolderOfAKilledRun) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / ".film.mp4.poinsot");
  std::ofstream(scratch / ".film.mp4.poinsot/segment-000000000-000000059.mp4") << "half";
  const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kFresh);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WorkFolder, KeepsFilesOfOtherPrograms) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / ".film.mp4.poinsot");
  const auto foreign = scratch / ".film.mp4.poinsot/notes.txt";
  std::ofstream(foreign) << "mine";
  { const WorkFolder folder(scratch / "film.mp4", WorkFolderUse::kFresh); }
  EXPECT_TRUE(fs::exists(foreign));
}

TEST(WorkFolder, MissingParentIsAnError) {
  const ScratchFolder scratch;
  EXPECT_THROW(WorkFolder(scratch / "no/film.mp4", WorkFolderUse::kFresh), core::Error);
}

}  // namespace
}  // namespace poinsot::job

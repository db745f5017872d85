// SPDX-License-Identifier: Apache-2.0
#include "app/work_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"
#include "support/scratch_folder.h"

namespace poinsot::app {
namespace {

namespace fs = std::filesystem;

TEST(WorkFolder, StandsBesideTheTargetAndGoesWithItsOwner) {
  const ScratchFolder scratch;
  {
    const WorkFolder folder(scratch / "film.mp4");
    EXPECT_EQ(folder.path(), scratch / ".film.mp4.poinsot");
    std::ofstream(folder.path() / "segment-0") << "x";
    std::ofstream(folder.path() / ".segment-1.tmp") << "x";
  }
  EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(WorkFolder, IsHeldByOne) {
  const ScratchFolder scratch;
  const WorkFolder folder(scratch / "film.mp4");
  try {
    const WorkFolder second(scratch / "film.mp4");
    FAIL() << "two renders hold one folder";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kIo);
    EXPECT_NE(std::string(error.what()).find("another poinsot"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(fs::is_directory(folder.path()));
}

TEST(WorkFolder, TakesOverWhatAKilledRunLeft) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / ".film.mp4.poinsot");
  std::ofstream(scratch / ".film.mp4.poinsot/segment-000000000-000000059.mp4") << "half";
  const WorkFolder folder(scratch / "film.mp4");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(WorkFolder, LeavesOthersFilesAlone) {
  const ScratchFolder scratch;
  fs::create_directory(scratch / ".film.mp4.poinsot");
  const auto foreign = scratch / ".film.mp4.poinsot/notes.txt";
  std::ofstream(foreign) << "mine";
  { const WorkFolder folder(scratch / "film.mp4"); }
  EXPECT_TRUE(fs::exists(foreign));
}

TEST(WorkFolder, MissingParentIsAnError) {
  const ScratchFolder scratch;
  EXPECT_THROW(WorkFolder(scratch / "no/film.mp4"), core::Error);
}

}  // namespace
}  // namespace poinsot::app

// SPDX-License-Identifier: Apache-2.0
// Mesa's cache of compiled shaders changes no byte, even if the cache is damaged.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "faults/tiny_film.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> filesBeneath(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && entry.file_size() > 0) files.push_back(entry.path());
  return files;
}

class ShaderCache : public testing::Test {
 protected:
  /// Returns the bytes of a film made with a cache: a folder, or a word such as off.
  static std::string filmWith(const std::string& cache) {
    const ScratchFolder folder;
    const RunResult made = run(folder,
                               {"render", POINSOT_SOURCE_DIR "/scenes/tennis_racket.toml", "-o", "t.mp4", "--size",
                                "160x90", "--frames", "0-3", "-j", "1", "--quiet"},
                               Stdout::kFile, {"POINSOT_CACHE=" + cache});
    EXPECT_EQ(made.exitCode, 0);
    EXPECT_EQ(made.err, "");
    return bytesOf(folder / "t.mp4");
  }

  const ScratchFolder cache_;
  const std::string kept_ = cache_.path().string();
  const std::string without_ = filmWith("off");
};

TEST_F(ShaderCache, ChangesNoByteWhetherColdOrWarm) {
  EXPECT_EQ(filmWith(kept_), without_);
  EXPECT_GT(filesBeneath(kept_).size(), 10u);
  // When a process ends, its last files are not on disk yet: 2 of 56 on a quiet machine, 8 on a busy one. The
  // second run finds the other files and leaves fewer.
  EXPECT_EQ(filmWith(kept_), without_);
  const auto files = filesBeneath(kept_);
  EXPECT_EQ(filmWith(kept_), without_);
  EXPECT_LE(filesBeneath(kept_).size(), files.size() + 5);
}

TEST_F(ShaderCache, ChangesNoByteWhenItIsDamaged) {
  filmWith(kept_);
  for (const fs::path& file : filesBeneath(kept_)) {
    std::string bytes = bytesOf(file);
    for (std::size_t i = bytes.size() / 3; i < bytes.size(); i += 97) bytes[i] = static_cast<char>(~bytes[i]);
    std::ofstream(file, std::ios::binary) << bytes;
  }
  EXPECT_EQ(filmWith(kept_), without_);
}

TEST_F(ShaderCache, ChangesNoByteWhenItIsCutShort) {
  filmWith(kept_);
  for (const fs::path& file : filesBeneath(kept_)) fs::resize_file(file, fs::file_size(file) / 2);
  EXPECT_EQ(filmWith(kept_), without_);
}

TEST_F(ShaderCache, IsSkippedIfItsFolderCannotBeCreated) {
  EXPECT_EQ(filmWith("/dev/null"), without_);
  EXPECT_EQ(filmWith("/proc/no/such/folder"), without_);
}

}  // namespace
}  // namespace poinsot::faults

// SPDX-License-Identifier: Apache-2.0
#include "core/file_batch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>
#include <vector>

#include "support/folder_test.h"

namespace poinsot::core {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

class FileBatchTest : public FolderTest {
 protected:
  AtomicFile written(const std::string& name, std::string_view text) const {
    AtomicFile file(in(name));
    file.write({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    return file;
  }

  std::string text(const std::string& name) const {
    const Bytes bytes = content(in(name));
    return {bytes.begin(), bytes.end()};
  }

  /// Adds a film with captions and a manifest, as a run does.
  void fill(FileBatch& batch) const {
    batch.add(written("film.mp4", "new film"));
    batch.writeBeside(in("film.srt"), "new captions");
    batch.removeBeside(in("film.vtt"));
    batch.add(written("manifest.json", "new manifest"));
  }
};

TEST_F(FileBatchTest, CommitsAllFilesTogether) {
  FileBatch batch;
  EXPECT_TRUE(batch.empty());
  fill(batch);
  EXPECT_FALSE(batch.empty());
  EXPECT_FALSE(std::filesystem::exists(in("film.mp4")));
  batch.commit();
  EXPECT_THAT(names(), ElementsAre("film.mp4", "film.srt", "manifest.json"));
  EXPECT_EQ(text("film.srt"), "new captions");
}

TEST_F(FileBatchTest, ReplacesAndRemovesOldFiles) {
  for (const char* name : {"film.mp4", "film.srt", "film.vtt", "manifest.json"}) save(name, "old");
  FileBatch batch;
  fill(batch);
  batch.commit();
  EXPECT_THAT(names(), ElementsAre("film.mp4", "film.srt", "manifest.json"));
  EXPECT_EQ(text("film.mp4"), "new film");
  EXPECT_EQ(text("manifest.json"), "new manifest");
}

TEST_F(FileBatchTest, ChangesNothingWithoutCommit) {
  save("film.mp4", "old");
  {
    FileBatch batch;
    fill(batch);
  }
  EXPECT_THAT(names(), ElementsAre("film.mp4"));
  EXPECT_EQ(text("film.mp4"), "old");
}

// A folder at the path of one file stands in for every reason why a rename can fail.
TEST_F(FileBatchTest, RestoresOldFilesIfAnyRenameFails) {
  const std::vector<std::string> all{"film.mp4", "film.srt", "film.vtt", "manifest.json"};
  for (const std::string& blocked : all) {
    for (const std::string& name : all) save(name, "old " + name);
    std::filesystem::remove(in(blocked));
    std::filesystem::create_directories(in(blocked) / "inside");
    const std::string message = messageOf(ErrorKind::kIo, [&] {
      FileBatch batch;
      fill(batch);
      batch.commit();
    });
    EXPECT_THAT(message, HasSubstr(blocked + ": cannot be put in place: Is a directory"));
    EXPECT_EQ(names(), all);
    EXPECT_TRUE(std::filesystem::is_directory(in(blocked) / "inside"));
    std::filesystem::remove_all(in(blocked));
    for (const std::string& name : all) EXPECT_EQ(text(name), name == blocked ? "" : "old " + name) << blocked;
  }
}

TEST_F(FileBatchTest, RemovesNewFilesIfARenameFails) {
  std::filesystem::create_directories(in("manifest.json"));
  EXPECT_NE(messageOf(ErrorKind::kIo,
                      [&] {
                        FileBatch batch;
                        fill(batch);
                        batch.commit();
                      }),
            "");
  EXPECT_THAT(names(), ElementsAre("manifest.json"));
}

// A second hard link to the old file must keep the old content.
TEST_F(FileBatchTest, KeepsOldContentUnderOtherHardLinks) {
  save("film.mp4", "old");
  std::filesystem::create_hard_link(in("film.mp4"), in("mine.mp4"));
  FileBatch batch;
  batch.add(written("film.mp4", "new"));
  batch.commit();
  EXPECT_EQ(text("mine.mp4"), "old");
  EXPECT_EQ(text("film.mp4"), "new");
}

// A golden suite may have more references than a process may have files open.
TEST_F(FileBatchTest, CommitsMoreFilesThanMayBeOpenAtOnce) {
  constexpr int kFiles = 20;
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &usual), 0);
  const rlimit few{kFiles + 12, usual.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &few), 0);
  FileBatch batch;
  for (int i = 0; i < kFiles; ++i) {
    batch.add(written("a" + std::to_string(i), "new"));
    batch.writeBeside(in("b" + std::to_string(i)), "new");
  }
  batch.commit();
  setrlimit(RLIMIT_NOFILE, &usual);
  EXPECT_EQ(names().size(), 2 * kFiles);
}

TEST_F(FileBatchTest, FindsTheContentOfAnUncommittedFile) {
  save("film.mp4", "old");
  FileBatch batch;
  batch.write(in("film.mp4"), std::string_view("new"));
  const Bytes bytes = content(batch.contentOf(in("film.mp4")));
  EXPECT_EQ(std::string(bytes.begin(), bytes.end()), "new");
  EXPECT_EQ(batch.contentOf(in("other")), in("other"));
}

TEST_F(FileBatchTest, RemovesFilesOnCommit) {
  save("map.png", "old");
  FileBatch batch;
  batch.remove(in("map.png"));
  EXPECT_FALSE(batch.empty());
  batch.write(in("page.html"), std::string_view("new"));
  batch.commit();
  EXPECT_THAT(names(), ElementsAre("page.html"));
}

TEST_F(FileBatchTest, AppendsTextOnlyIfAllOtherFilesAreInPlace) {
  save("summary.md", "mine, ");
  const auto commit = [&] {
    FileBatch batch;
    batch.write(in("page.html"), std::string_view("new"));
    batch.append(in("summary.md"), "ours");
    batch.commit();
  };
  std::filesystem::create_directory(in("page.html"));
  EXPECT_NE(messageOf(ErrorKind::kIo, commit), "");
  EXPECT_EQ(text("summary.md"), "mine, ");
  std::filesystem::remove(in("page.html"));
  commit();
  EXPECT_EQ(text("summary.md"), "mine, ours");
  std::filesystem::remove(in("summary.md"));
  std::filesystem::create_directory(in("summary.md"));
  save("page.html", "old");
  EXPECT_NE(messageOf(ErrorKind::kIo, commit), "");
  EXPECT_EQ(text("page.html"), "old");
}

TEST_F(FileBatchTest, AcceptsOtherBatchesAndCompleteFiles) {
  save("complete.tmp", "new");
  FileBatch one, all;
  one.add(AtomicFile::of(in("complete.tmp"), in("a.png")));
  all.add(std::move(one));
  all.commit();
  EXPECT_THAT(names(), ElementsAre("a.png"));
  save("complete.tmp", "new");
  { const AtomicFile unused = AtomicFile::of(in("complete.tmp"), in("a.png")); }
  EXPECT_THAT(names(), ElementsAre("a.png"));
}

TEST_F(FileBatchTest, RejectsASideFileWithoutAMainFile) {
  FileBatch batch;
  EXPECT_THROW(batch.writeBeside(in("film.srt"), ""), std::logic_error);
  EXPECT_THROW(batch.removeBeside(in("film.srt")), std::logic_error);
}

}  // namespace
}  // namespace poinsot::core

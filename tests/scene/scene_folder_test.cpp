// SPDX-License-Identifier: Apache-2.0
// A scene reaches nothing outside its folder.
#include "scene/scene_folder.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "core/error.h"
#include "scene/limits.h"

namespace poinsot::scene {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) / "poinsot_scene_folder_test";
    fs::remove_all(root_);
    fs::create_directories(root_ / "scene" / "meshes");
    put("secret.txt", "outside");
    put("scene/a.txt", "beside");
    put("scene/meshes/b.txt", "below");
  }
  void TearDown() override { fs::remove_all(root_); }

  void put(const fs::path& name, const std::string& text) const { std::ofstream(root_ / name) << text; }

  std::string read(const std::string& path) const { return SceneFolder(root_ / "scene").read(path); }

  std::string problemOf(const std::string& path) const {
    try {
      read(path);
      return "";
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kScene);
      return error.message();
    }
  }

  fs::path root_;
};

TEST_F(SceneFolderTest, ReadsFilesInItAndBelow) {
  EXPECT_EQ(read("a.txt"), "beside");
  EXPECT_EQ(read("./meshes/b.txt"), "below");
}

TEST_F(SceneFolderTest, IsNotLeft) {
  EXPECT_THAT(problemOf("../secret.txt"), HasSubstr("without \"..\""));
  EXPECT_THAT(problemOf("meshes/../a.txt"), HasSubstr("without \"..\""));
  EXPECT_THAT(problemOf((root_ / "secret.txt").string()), HasSubstr("must be relative to the scene's folder"));
  EXPECT_THAT(problemOf(""), HasSubstr("the name is empty"));
}

TEST_F(SceneFolderTest, FollowsNoLinks) {
  fs::create_symlink(root_ / "secret.txt", root_ / "scene" / "link.txt");
  fs::create_directory_symlink(root_, root_ / "scene" / "up");
  EXPECT_THAT(problemOf("link.txt"), HasSubstr("it is a symbolic link"));
  EXPECT_NE(problemOf("up/secret.txt"), "");
}

TEST_F(SceneFolderTest, ReadsRegularFilesOnly) {
  ASSERT_EQ(::mkfifo((root_ / "scene" / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(problemOf("fifo"), "cannot read fifo: it is not a regular file");  // and does not wait for a writer
  EXPECT_EQ(problemOf("meshes"), "cannot read meshes: it is a directory");
  EXPECT_EQ(problemOf("none.txt"), "cannot read none.txt: No such file or directory");
  EXPECT_EQ(problemOf("a.txt/b"), "cannot read a.txt/b: Not a directory");
}

TEST_F(SceneFolderTest, ReadsSoMuchAndNoMore) {
  fs::resize_file(root_ / "scene" / "a.txt", kMostFileBytes);
  EXPECT_EQ(read("a.txt").size(), kMostFileBytes);
  fs::resize_file(root_ / "scene" / "a.txt", kMostFileBytes + 1);
  EXPECT_EQ(problemOf("a.txt"), "cannot read a.txt: it has more than 64 MiB");
}

}  // namespace
}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
// A scene cannot read files outside its folder.
#include "scene/assembly/scene_folder.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include <fstream>

#include "core/error.h"
#include "scene/limits.h"
#include "support/scratch_folder.h"

namespace poinsot::scene {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class SceneFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(root_ / "scene" / "meshes");
    put("secret.txt", "outside");
    put("scene/a.txt", "beside");
    put("scene/meshes/b.txt", "below");
  }

  void put(const fs::path& name, const std::string& text) const { std::ofstream(root_ / name) << text; }

  std::string read(const std::string& path) const { return SceneFolder(root_ / "scene").read(path); }

  std::string problemOf(const std::string& path, core::ErrorKind kind = core::ErrorKind::kScene) const {
    try {
      read(path);
      return "";
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), kind);
      return error.message();
    }
  }

  const ScratchFolder scratch_;
  const fs::path root_ = scratch_.path();
};

TEST_F(SceneFolderTest, ReadsFilesInAndBelowTheFolder) {
  EXPECT_EQ(read("a.txt"), "beside");
  EXPECT_EQ(read("./meshes/b.txt"), "below");
}

TEST_F(SceneFolderTest, RejectsPathsOutOfTheFolder) {
  EXPECT_THAT(problemOf("../secret.txt"), HasSubstr("without \"..\""));
  EXPECT_THAT(problemOf("meshes/../a.txt"), HasSubstr("without \"..\""));
  EXPECT_THAT(problemOf((root_ / "secret.txt").string()), HasSubstr("must be relative to the scene's folder"));
  EXPECT_THAT(problemOf(""), HasSubstr("the name is empty"));
}

TEST_F(SceneFolderTest, RejectsSymbolicLinks) {
  fs::create_symlink(root_ / "secret.txt", root_ / "scene" / "link.txt");
  fs::create_directory_symlink(root_, root_ / "scene" / "up");
  EXPECT_THAT(problemOf("link.txt"), HasSubstr("it is a symbolic link"));
  EXPECT_NE(problemOf("up/secret.txt"), "");
}

TEST_F(SceneFolderTest, ReadsRegularFilesOnly) {
  ASSERT_EQ(::mkfifo((root_ / "scene" / "fifo").c_str(), 0600), 0);
  EXPECT_EQ(problemOf("fifo"), "cannot read fifo: it is not a regular file");  // must not wait for a writer
  EXPECT_EQ(problemOf("meshes"), "cannot read meshes: it is a directory");
  EXPECT_EQ(problemOf("none.txt"), "cannot read none.txt: No such file or directory in the scene's folder");
  EXPECT_EQ(problemOf("a.txt/b"), "cannot read a.txt/b: Not a directory");
}

TEST_F(SceneFolderTest, RejectsNamesThatNeedExpansionAndUrls) {
  for (const char* name : {"~/a.txt", "~root", "$HOME/a.txt", "$(id)", "`id`", "meshes/$x"})
    EXPECT_THAT(problemOf(name), HasSubstr("file names are not expanded")) << name;
  for (const char* name : {"file:a.txt", "FILE:///etc/passwd", "https://example.org/a.obj"})
    EXPECT_THAT(problemOf(name), HasSubstr("it is a URL")) << name;
  EXPECT_THAT(problemOf(std::string("a.txt\0b", 7)), HasSubstr("must not contain control characters"));
  EXPECT_THAT(problemOf("a\n.txt"), HasSubstr("must not contain control characters"));
  for (const char* name : {"%61.txt", "A.TXT", "a.txt.", "a.txt "})
    EXPECT_THAT(problemOf(name), HasSubstr("No such file")) << name;
}

TEST_F(SceneFolderTest, SearchesAssetRootsAfterTheFolder) {
  fs::create_directories(root_ / "shared");
  put("shared/a.txt", "never seen");
  put("shared/c.txt", "shared");
  fs::create_symlink(root_ / "secret.txt", root_ / "scene" / "link.txt");
  put("shared/link.txt", "not in its place");
  const SceneFolder folder(root_ / "scene", {{}, {root_ / "none", root_ / "shared"}});
  EXPECT_EQ(folder.read("a.txt"), "beside");
  EXPECT_EQ(folder.read("c.txt"), "shared");
  EXPECT_EQ(folder.filesRead()[0].place, root_ / "scene" / "a.txt");
  EXPECT_EQ(folder.filesRead()[1].place, root_ / "shared" / "c.txt");
  EXPECT_THROW(folder.read("../secret.txt"), core::Error);
  EXPECT_THROW(folder.read("link.txt"), core::Error);
  try {
    folder.read("none.txt");
    FAIL();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.message(),
              "cannot read none.txt: No such file or directory in the scene's folder, nor in a "
              "folder of --asset-root");
  }
}

TEST_F(SceneFolderTest, LimitsTheBytesOfAllFiles) {
  Allowance allowance;
  allowance.limits.set(Limit::kFilesBytes, 11);  // "beside" and "below"
  const SceneFolder enough(root_ / "scene", allowance);
  enough.read("a.txt");
  EXPECT_EQ(enough.read("meshes/b.txt"), "below");
  allowance.limits.set(Limit::kFilesBytes, 10);
  const SceneFolder tooLittle(root_ / "scene", allowance);
  tooLittle.read("a.txt");
  try {
    tooLittle.read("meshes/b.txt");
    FAIL();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
    EXPECT_EQ(error.message(),
              "cannot read meshes/b.txt: it has 5 bytes, more than the allowed 4; together the files of the scene "
              "exceed their limit; --limit files_bytes=N raises the limit");
  }
}

TEST_F(SceneFolderTest, LimitsTheTrianglesOfAllMeshes) {
  const std::string two = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n";
  put("scene/two.obj", two);
  put("scene/more.obj", two);
  Allowance allowance;
  allowance.limits.set(Limit::kTriangles, 4);
  const SceneFolder enough(root_ / "scene", allowance);
  EXPECT_EQ(enough.readMesh("two.obj").mesh.triangles.size() + enough.readMesh("more.obj").mesh.triangles.size(),
            4u);
  allowance.limits.set(Limit::kTriangles, 3);
  const SceneFolder tooLittle(root_ / "scene", allowance);
  tooLittle.readMesh("two.obj");
  try {
    tooLittle.readMesh("more.obj");
    FAIL();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
    EXPECT_EQ(error.message(),
              "the mesh has more than the allowed 1 triangles; the meshes of a scene may have 3 triangles in all; "
              "--limit triangles=N raises the limit");
  }
}

TEST_F(SceneFolderTest, LimitsTheBytesOfEachFile) {
  const auto most = static_cast<std::uintmax_t>(rowOf(Limit::kFileBytes).usual);
  fs::resize_file(root_ / "scene" / "a.txt", most);
  EXPECT_EQ(read("a.txt").size(), most);
  fs::resize_file(root_ / "scene" / "a.txt", most + 1);
  EXPECT_EQ(problemOf("a.txt", core::ErrorKind::kLimit),
            "cannot read a.txt: it has 134217729 bytes, more than the allowed 134217728; --limit file_bytes=N "
            "raises the limit");
}

}  // namespace
}  // namespace poinsot::scene

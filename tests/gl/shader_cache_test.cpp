// SPDX-License-Identifier: Apache-2.0
// Checks where compiled shaders are cached: as in the XDG Base Directory Specification 0.8, and only where nobody
// else may write.
#include "gl/shader_cache.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <map>

#include "support/scratch_folder.h"

namespace poinsot::gl {
namespace {

namespace fs = std::filesystem;

class ShaderCacheTest : public testing::Test {
 protected:
  ~ShaderCacheTest() override {
    for (const char* name : {"XDG_CACHE_HOME", "HOME", "POINSOT_CACHE"}) unsetenv(name);
  }

  static fs::path folderWith(const std::map<std::string, std::string>& environment) {
    for (const char* name : {"XDG_CACHE_HOME", "HOME", "POINSOT_CACHE"}) unsetenv(name);
    for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
    return shaderCacheFolder(false);
  }

  const ScratchFolder scratch_;
  const std::string home_ = scratch_.path().string();
};

TEST_F(ShaderCacheTest, FollowsTheFirstOfThreeVariables) {
  EXPECT_EQ(folderWith({{"HOME", home_}}).parent_path(), scratch_ / ".cache" / "poinsot");
  EXPECT_EQ(folderWith({{"HOME", home_}, {"XDG_CACHE_HOME", home_ + "/x"}}).parent_path(),
            scratch_ / "x" / "poinsot");
  EXPECT_EQ(folderWith({{"XDG_CACHE_HOME", home_ + "/x"}, {"POINSOT_CACHE", home_ + "/p"}}).parent_path(),
            scratch_ / "p");
}

TEST_F(ShaderCacheTest, IsCreatedReadableByTheUserOnly) {
  const fs::path folder = folderWith({{"HOME", home_}});
  for (const fs::path& made : {folder, folder.parent_path(), scratch_ / ".cache"})
    EXPECT_EQ(fs::status(made).permissions(), fs::perms::owner_all) << made;
  EXPECT_EQ(shaderCacheFolder(false), folder);  // and found again
}

TEST_F(ShaderCacheTest, IsDisabledWithoutAUsableVariable) {
  EXPECT_EQ(folderWith({}), fs::path());
  EXPECT_EQ(folderWith({{"HOME", "here"}, {"XDG_CACHE_HOME", "there"}}), fs::path());
  EXPECT_EQ(folderWith({{"HOME", home_}, {"POINSOT_CACHE", "off"}}), fs::path());
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(ShaderCacheTest, IsNotSharedByTheTwoProfiles) {
  const fs::path native = folderWith({{"HOME", home_}});
  EXPECT_NE(shaderCacheFolder(true), native);
  EXPECT_EQ(shaderCacheFolder(true).parent_path(), native.parent_path());
}

/// Parts of the cache are its home, its folder, and the files that Mesa makes in the folder.
TEST_F(ShaderCacheTest, IsNotUsedIfOthersMayWriteToIt) {
  const fs::path folder = folderWith({{"HOME", home_}}), mesas = folder / "mesa_shader_cache";
  fs::create_directories(mesas / "1c");
  scratch_.put((mesas / "1c" / "code").lexically_relative(scratch_.path()), "");
  for (const fs::path& part : {mesas, mesas / "1c", mesas / "1c" / "code"}) ::chmod(part.c_str(), 0700);
  for (const fs::path& part : {folder.parent_path(), folder, mesas, mesas / "1c", mesas / "1c" / "code"}) {
    EXPECT_EQ(folderWith({{"HOME", home_}}), folder);
    for (const mode_t mode : {0720, 0702, 0777}) {
      ::chmod(part.c_str(), mode);
      EXPECT_EQ(folderWith({{"HOME", home_}}), fs::path()) << part << " " << std::oct << mode;
    }
    ::chmod(part.c_str(), 0700);
  }
  fs::create_symlink("/dev/null", mesas / "link");
  EXPECT_EQ(folderWith({{"HOME", home_}}), fs::path());
  fs::remove(mesas / "link");
  fs::rename(folder, scratch_ / "elsewhere");
  fs::create_symlink(scratch_ / "elsewhere", folder);
  EXPECT_EQ(folderWith({{"HOME", home_}}), fs::path());
}

TEST_F(ShaderCacheTest, IsNotUsedIfItBelongsToAnotherUser) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  const fs::path folder = folderWith({{"HOME", home_}});
  scratch_.put((folder / "code").lexically_relative(scratch_.path()), "");
  for (const fs::path& part : {folder / "code", folder, folder.parent_path()}) {
    ASSERT_EQ(::chown(part.c_str(), 65534, 65534), 0);
    EXPECT_EQ(folderWith({{"HOME", home_}}), fs::path()) << part;
    ASSERT_EQ(::chown(part.c_str(), 0, 0), 0);
    EXPECT_EQ(folderWith({{"HOME", home_}}), folder);
  }
  fs::remove_all(scratch_ / ".cache");
  ASSERT_EQ(::chown(home_.c_str(), 65534, 65534), 0);
  EXPECT_EQ(folderWith({{"HOME", home_}}), fs::path());  // as with sudo
  EXPECT_TRUE(fs::is_empty(home_));
}

}  // namespace
}  // namespace poinsot::gl

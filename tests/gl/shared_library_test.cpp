// SPDX-License-Identifier: Apache-2.0
#include "gl/shared_library.h"

#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace poinsot::gl {
namespace {

std::string whyNot(const std::string& library) {
  try {
    const SharedLibrary opened(library.c_str(), "some-package");
    return "opened";
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kGraphics);
    return error.message();
  }
}

TEST(SharedLibrary, AMissingOneNamesItsPackage) {
  EXPECT_EQ(whyNot("libno-such-thing.so.9"),
            "libno-such-thing.so.9 cannot be opened: cannot open shared object file: No such file or directory; "
            "install it with: apt-get install some-package");
}

TEST(SharedLibrary, ABrokenOneIsNotToBeInstalledAgain) {
  const ScratchFolder folder;
  const std::string file = folder.put("broken.so", "no library").string();
  EXPECT_EQ(whyNot(file), file + " cannot be opened: file too short");  // glibc's words
}

}  // namespace
}  // namespace poinsot::gl

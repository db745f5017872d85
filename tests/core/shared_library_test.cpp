// SPDX-License-Identifier: Apache-2.0
#include "core/shared_library.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scratch_folder.h"

namespace poinsot::core {
namespace {

template <typename Action>
std::string messageOf(Action action) {
  try {
    action();
    return "done";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kEncode);
    return error.message();
  }
}

std::string whyNot(const std::string& library) {
  return messageOf([&] { const SharedLibrary opened(library.c_str(), "some-package", ErrorKind::kEncode); });
}

TEST(SharedLibrary, NamesThePackageOfAMissingLibrary) {
  EXPECT_EQ(whyNot("libno-such-thing.so.9"),
            "libno-such-thing.so.9 cannot be opened: cannot open shared object file: No such file or directory; "
            "install it with: apt-get install some-package");
}

TEST(SharedLibrary, SuggestsNoPackageForABrokenLibrary) {
  const ScratchFolder folder;
  const std::string file = folder.put("broken.so", "no library").string();
  EXPECT_EQ(whyNot(file), file + " cannot be opened: file too short");  // glibc's message
}

TEST(SharedLibrary, LoadsFunctionsAndNamesMissingOnes) {
  const SharedLibrary library("libm.so.6", "libc6", ErrorKind::kEncode);
  double (*hypotenuse)(double, double) = nullptr;
  library.load(hypotenuse, "hypot");
  EXPECT_EQ(hypotenuse(3, 4), 5);
  library.find(hypotenuse, "hypotenuse");
  EXPECT_EQ(hypotenuse, nullptr);
  EXPECT_EQ(messageOf([&] { library.load(hypotenuse, "hypotenuse"); }), "libm.so.6 has no function hypotenuse");
}

}  // namespace
}  // namespace poinsot::core

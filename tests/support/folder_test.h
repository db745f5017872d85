// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "support/scratch_folder.h"

namespace poinsot {

using Bytes = std::vector<std::uint8_t>;

/// Fixture with a temporary folder, which is removed when the test ends.
class FolderTest : public ::testing::Test {
 protected:
  std::filesystem::path in(const std::string& name) const { return folder_ / name; }

  std::filesystem::path save(const std::string& name, std::string_view content) const {
    return folder_.put(name, std::string(content));
  }

  static Bytes content(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  /// Returns the names of all entries, sorted; nothing temporary may be among them.
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      all.push_back(entry.path().filename());
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  ScratchFolder folder_;
};

/// Returns the message of the core::Error that `call` throws, and checks its kind. Returns "" if `call` throws
/// none.
template <class Call>
std::string messageOf(core::ErrorKind kind, Call call) {
  try {
    call();
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    return error.what();
  }
  return "";
}

}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "support/program_run.h"
#include "support/raw_png.h"

namespace poinsot {

inline Bytes flat(int level) {
  return pngBytes({16, 12, 8, 0, {}}, Bytes(16 * 12, static_cast<std::uint8_t>(level)));
}

inline Bytes flatRgb(int level) {
  return pngBytes({16, 12, 8, 2, {}}, Bytes(16 * 12 * 3, static_cast<std::uint8_t>(level)));
}

/// Fixture with a golden.toml whose references are in ref; the variable CI is empty.
class GoldenImagesFixture : public ::testing::Test {
 protected:
  RunResult golden(std::vector<std::string> words = {}) {
    words.insert(words.begin(), "golden");
    return poinsot(words);
  }
  RunResult poinsot(const std::vector<std::string>& words) { return run(folder_, words, Stdout::kFile, {"CI="}); }
  void approve(std::vector<std::string> words = {}) {
    words.emplace_back("--update");
    const RunResult made = golden(words);
    ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
  }
  void manifest(const std::string& text) { folder_.put("golden.toml", "references = 'ref'\n" + text); }
  void save(const std::string& name, const Bytes& bytes) { saveBytes(folder_ / name, bytes); }

  ScratchFolder folder_;
};

}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
// Compares the table of environment variables with the sources and with the page.
#include "cli/variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <regex>
#include <set>

#include "support/text_of.h"

namespace poinsot::cli {
namespace {

namespace fs = std::filesystem;

/// Returns arguments such as ("HOME") in the files that call getenv(), directly or through a function of their
/// own.
std::set<std::string> namesInSources() {
  static const std::regex kCall(R"re(\("([A-Z][A-Z_]+)"\))re");
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(POINSOT_SOURCE_DIR "/src")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const std::string text = textOf(entry.path());
    if (text.find("getenv(") == std::string::npos) continue;
    for (std::sregex_iterator call(text.begin(), text.end(), kCall), end; call != end; ++call)
      names.insert((*call)[1]);
  }
  return names;
}

TEST(EnvironmentVariables, MatchTheVariablesThatTheSourcesRead) {
  std::set<std::string> names;
  for (const Variable& variable : variables()) names.insert(variable.name);
  names.erase("TZ");  // read by the C library, for localtime()
  EXPECT_EQ(names, namesInSources());
}

TEST(EnvironmentVariables, MatchTheTableInTheDocs) {
  std::string rows;
  for (const Variable& variable : variables())
    rows += std::string("| `") + variable.name + "` | " + variable.help + " |\n";
  EXPECT_THAT(textOf(POINSOT_SOURCE_DIR "/docs/defaults.md"), testing::HasSubstr("| --- | --- |\n" + rows + "\n"));
}

TEST(EnvironmentVariables, AreClearedExceptThoseThatPoinsotUses) {
  for (const char* name :
       {"LP_NO_RAST", "FREETYPE_PROPERTIES", "LC_ALL", "glsl_zero_init", "HOMES", "POINSOT_NEW"})
    setenv(name, "1", 1);
  for (const Variable& variable : variables()) setenv(variable.name, "kept", 1);
  setenv("LD_LIBRARY_PATH", "kept", 1);
  clearOtherVariables();
  for (const Variable& variable : variables()) EXPECT_STREQ(std::getenv(variable.name), "kept") << variable.name;
  EXPECT_STREQ(std::getenv("LD_LIBRARY_PATH"), "kept");
  for (const char* name :
       {"LP_NO_RAST", "FREETYPE_PROPERTIES", "LC_ALL", "glsl_zero_init", "HOMES", "POINSOT_NEW"})
    EXPECT_EQ(std::getenv(name), nullptr) << name;
}

}  // namespace
}  // namespace poinsot::cli

// SPDX-License-Identifier: Apache-2.0
#include "golden/suite_run.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "support/text_of.h"

namespace poinsot {

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.name; }

std::string textWith(const Fault& fault, const std::string& folder) {
  std::string text = textOf(folder + "/" + fault.file);
  const auto at = text.find(fault.from);
  EXPECT_NE(at, std::string::npos) << fault.file << " has changed: seed the fault anew";
  return at == std::string::npos ? text : text.replace(at, std::string(fault.from).size(), fault.to);
}

ShellResult runSuite(const ScratchFolder& folder, const std::string& program, const std::string& manifest,
                     const std::string& tests, const std::vector<std::string>& environment) {
  return runShell(POINSOT_SOURCE_DIR,
                  fmt::format("{} golden {} -o {} --only {}", program, manifest, (folder / "out").string(), tests),
                  environment);
}

void expectCaught(const ShellResult& suite) {
  EXPECT_EQ(suite.exitCode, 1) << suite.out;
  EXPECT_THAT(suite.out,
              testing::AllOf(testing::HasSubstr("different  "), testing::Not(testing::HasSubstr("error"))));
}

}  // namespace poinsot

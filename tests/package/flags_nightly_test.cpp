// SPDX-License-Identifier: Apache-2.0
// Compiles both examples under every set of flags that changes Eigen or the standard library, with both compilers.
// The examples give the results of the plain build, or are refused with the reason.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "package/flags.h"

namespace poinsot {
namespace {

using ::testing::HasSubstr;

const std::vector<std::string> kFlags{"-mavx",
                                      "-mavx2",
                                      "-mavx512f -mfma",
                                      "-march=native",
                                      "-march=x86-64-v3",
                                      "-DEIGEN_DONT_VECTORIZE",
                                      "-DEIGEN_MAX_ALIGN_BYTES=0",
                                      "-D_GLIBCXX_DEBUG"};

std::vector<Compilation> allCompilations(const std::string& optimisation) {
  std::vector<Compilation> all;
  for (const char* compiler : {"g++", "clang++"})
    for (const std::string& flags : kFlags)
      if (isInstalled(compiler)) all.push_back({compiler, optimisation + " " + flags});
  return all;
}

class ExamplesWithFlags : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  }
};

std::string outcomeOf(const InstalledTree& tree, const std::string& example) {
  return tree.run(example == "picture" ? "./picture book.png && sha256sum book.png" : "./" + example);
}

TEST_P(ExamplesWithFlags, GiveTheResultsOfThePlainBuild) {
  const InstalledTree tree;
  for (const auto& [example, modules] : {std::pair{std::string("trajectory"), kPhysics}, {"picture", kPictures}}) {
    const std::string source = kExamples + "/" + example + ".cpp";
    Compilation{"g++", "-O2"}.make(tree, source, modules, example);
    const std::string plain = outcomeOf(tree, example);
    for (const Compilation& compilation : allCompilations(GetParam())) {
      SCOPED_TRACE(example + ": " + compilation.text());
      if (compilation.flags.ends_with("_GLIBCXX_DEBUG")) {
        EXPECT_THAT(compilation.refusal(tree, source, modules), HasSubstr("poinsot: _GLIBCXX_DEBUG changes"));
        continue;
      }
      compilation.make(tree, source, modules, example);
      if (compilation.runsHere())
        EXPECT_EQ(outcomeOf(tree, example), plain);
      else
        std::printf("built only, as this CPU lacks the instructions: %s\n", compilation.text().c_str());
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Optimisation, ExamplesWithFlags, ::testing::Values("-O0", "-O3"),
                         [](const auto& level) { return std::string(level.param + 1); });

// Eigen requires -mfma with this flag.
TEST(AllFlags, IncludeAFlagThatEigenRejects) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  EXPECT_THAT((Compilation{"g++", "-mavx512f"}.refusal(InstalledTree(), kExamples + "/trajectory.cpp", kPhysics)),
              HasSubstr("Please add -mfma"));
}

TEST(AllFlags, GiveTheSameLayoutOfPublicTypes) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  std::vector<Compilation> compilations = allCompilations("-O0");
  std::erase_if(compilations, [](const auto& one) { return one.flags.ends_with("_GLIBCXX_DEBUG"); });
  expectSameLayout(InstalledTree(), compilations);
}

// With -mfma, a caller's compiler fuses a sum with a product. Callers compile the inline functions of public
// headers, and the linker may keep the caller's copy instead of the library's.
TEST(PublicHeaders, ContainNoFloatingPointFormulas) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  const InstalledTree tree;
  const std::string fused = tree.run(
      "find $PREFIX/include/poinsot -name '*.h' -printf '#include \"%P\"\\n' >all.cpp\n"
      "modules=$(cd $PREFIX/lib/pkgconfig && ls | sed 's/[.]pc$//')\n"
      "g++ -std=c++20 -O2 -mfma -fkeep-inline-functions -c all.cpp $(pkg-config --cflags $modules)\n"
      "objdump -d -C --no-show-raw-insn all.o | awk '/^[0-9a-f]+ </ { f = $0 } /vfn?m(add|sub)/ { print f }' "
      ">fused\n"
      "wc -l <fused; grep '<poinsot::' fused | sort -u || true");
  EXPECT_THAT(fused, ::testing::MatchesRegex("[0-9][0-9]+\n")) << "Eigen's are there, ours are not";
}

TEST(AllGladVersions, KeepTheirFunctionPointers) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  const InstalledTree tree;
  for (const char* version : {"3.1", "3.3", "4.6"}) expectKeepsItsGlad(tree, {"g++", "-O2"}, version);
}

}  // namespace
}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
// Tests programs that are compiled with other flags than the library, and the names that the archives define.
#include "package/flags.h"

#include <cxxabi.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <regex>
#include <sstream>

#include "package/state_bits.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Each build would reveal another kind of fault: vectors of 32 bytes, and inline functions of the program in the
// library (-O0 inlines none, and the linker finds the program's first); vectors of 8 bytes; sums fused with
// products.
TEST(Flags, DoNotChangeTheLibrarysResults) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  const InstalledTree tree;
  tree.folder().put("bits.cpp",
                    "#include \"package/state_bits.h\"\nint main() { std::fputs(poinsot::stateBits().c_str(), "
                    "stdout); }\n");
  for (const Compilation& compilation :
       {Compilation{"g++", "-O0 -mavx2 -mfma"}, Compilation{"g++", "-O2 -DEIGEN_MAX_ALIGN_BYTES=0"},
        Compilation{"clang++", "-O2 -march=x86-64-v3"}}) {
    if (!isInstalled(compilation.compiler)) continue;
    Compilation{compilation.compiler, compilation.flags + " -I" POINSOT_SOURCE_DIR "/tests"}.make(
        tree, "bits.cpp", kPhysics, "bits");
    if (compilation.runsHere()) {
      EXPECT_EQ(tree.run("./bits"), stateBits()) << compilation.text();
    }
  }
}

TEST(Flags, AreRejectedWithAReasonIfTheyChangeLayouts) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  const InstalledTree tree;
  const auto refusal = [&](const std::string& header, const std::string& flags) {
    tree.folder().put("refused.cpp", "#include \"" + header + "\"\n");
    return Compilation{"g++", flags}.refusal(tree, "refused.cpp", kPictures);
  };
  EXPECT_THAT(refusal("core/error.h", "-D_GLIBCXX_DEBUG"), HasSubstr("poinsot: _GLIBCXX_DEBUG changes"));
  EXPECT_THAT(refusal("core/error.h", "-D_GLIBCXX_USE_CXX11_ABI=0"),
              HasSubstr("poinsot: _GLIBCXX_USE_CXX11_ABI=0 selects"));
  EXPECT_THAT(refusal("core/error.h", "-DEIGEN_DEFAULT_TO_ROW_MAJOR"),
              HasSubstr("poinsot: EIGEN_DEFAULT_TO_ROW_MAJOR changes"));
  // GLM aligns its types if the language has extensions.
  for (const std::string header : {"draw/camera.h", "draw/color.h"})
    EXPECT_THAT(refusal(header, "-mavx -DGLM_FORCE_DEFAULT_ALIGNED_GENTYPES -DGLM_FORCE_INTRINSICS"),
                HasSubstr("poinsot: GLM_FORCE_DEFAULT_ALIGNED_GENTYPES, or another of GLM's macros, changes"));
  // The size of a type reveals a flag that has no check of its own.
  EXPECT_THAT(refusal("physics/rigid_body_state.h", "-fpack-struct=1"),
              HasSubstr("poinsot: a flag or macro of this compilation gives this type another layout"));
}

TEST(Flags, AreRejectedIfTheySelectAnOlderLanguage) {
  const InstalledTree tree;
  for (const std::string header : {"core/error.h", "physics/motion.h", "geometry/primitives.h", "stage/stage.h"}) {
    tree.folder().put("old.cpp", "#include \"" + header + "\"\n");
    EXPECT_THAT(tree.run("! $CXX -std=c++17 -fsyntax-only -Wfatal-errors old.cpp $(pkg-config --cflags " +
                         kPictures + ") 2>&1"),
                HasSubstr("poinsot: C++20 is required"))
        << header;
  }
}

// The pointers in a program's glad belong to its own window.
TEST(Flags, LeaveGladPointersOfTheProgramUnchanged) {
  if (const std::string reason = whyNoFlags(); !reason.empty()) GTEST_SKIP() << reason;
  expectKeepsItsGlad(InstalledTree(), {"g++", "-O0 -mavx2"}, "3.3");
}

/// Returns why another program may define this name too; empty if only poinsot can.
std::string whyForeign(const std::string& name, char type) {
  static const std::regex ours("_Z(T[A-Z]|G[A-Z])*Z*N[VKRO]*7poinsot.*|(poinsot|POINSOT)_.*");
  if (std::regex_match(name, ours)) return "";
  // The language merges these in the whole program: type information, statics of inline functions.
  if (type == 'V' || type == 'u') return "";
  if (name.starts_with("__clang_")) return "";  // the compiler's own, always alike
  if (type != 'W') return "a global name outside poinsot";
  return name.ends_with(".poinsot") || !POINSOT_OWN_INLINES ? "" : "an inline function of somebody else's";
}

// A program may use every name outside poinsot.
TEST(Archives, DefineOnlyTheirOwnGlobalNames) {
  const InstalledTree tree;
  std::istringstream lines(
      tree.run("nm --print-file-name --extern-only --defined-only --format=posix $PREFIX/lib/*.a"));
  std::vector<std::string> foreign;
  int ours = 0;
  for (std::string file, name, line; lines >> file >> name && std::getline(lines, line);) {
    const std::string why = whyForeign(name, line.at(1));
    if (why.empty())
      ++ours;
    else
      foreign.push_back(file + " " + name + ": " + why);
  }
  EXPECT_THAT(foreign, IsEmpty());
  EXPECT_GT(ours, 5000) << "nm has told of too few";
}

// Functions in single precision differ in the last bit between C libraries. glibc 2.41 rounds them correctly,
// glibc 2.36 does not, and cones differed between Debian 13 and 12. A function in double precision, rounded to
// single, gives the same value with both. hypotf is allowed, because glibc computes it in double.
TEST(Archives, UseNoSinglePrecisionFunctionOfTheCLibrary) {
  const InstalledTree tree;
  std::istringstream lines(tree.run("nm --print-file-name --undefined-only --format=posix $PREFIX/lib/*.a"));
  static const std::regex single(
      "a?(sin|cos|tan)h?f|(atan2|sincos|exp|exp2|expm1|log|log2|log10|log1p|pow|cbrt|tgamma|erf)f");
  std::vector<std::string> found;
  bool seesDouble = false;
  for (std::string file, name, line; lines >> file >> name && std::getline(lines, line);) {
    if (std::regex_match(name, single)) found.push_back(file + " " + name);
    seesDouble = seesDouble || name == "tan";
  }
  EXPECT_THAT(found, IsEmpty());
  EXPECT_TRUE(seesDouble) << "nm has told of too few";
}

/// Returns whether a header includes core/abi.h, directly or indirectly.
bool leadsToAbi(const std::filesystem::path& include, const std::string& header) {
  if (header == "core/abi.h") return true;
  const std::string text = textOf(include / header);
  static const std::regex local("#include \"([^\"]+)\"");
  for (std::sregex_iterator found(text.begin(), text.end(), local), end; found != end; ++found)
    if (leadsToAbi(include, (*found)[1])) return true;
  return false;
}

// Every header includes core/abi.h, which refuses flags, and uses no type that Eigen aligns. The nightly test
// checks the layouts themselves.
TEST(PublicHeaders, HaveOneLayoutForAllFlags) {
  const InstalledTree tree;
  EXPECT_EQ(tree.run("cd $PREFIX/include/poinsot; grep -rohE 'Eigen::[A-Z]\\w+' . | sort -u | tr '\\n' ' '"),
            "Eigen::DontAlign Eigen::EigenBase Eigen::Matrix Eigen::Matrix3d Eigen::Quaternion Eigen::Quaterniond "
            "Eigen::Vector2d "
            "Eigen::Vector3d ")
      << "DontAlign goes with Matrix and Quaternion; EigenBase only takes vectors; the aligned ones stand in "
         "comments";
  EXPECT_EQ(tree.run("cd $PREFIX/include/poinsot; grep -rn Eigen:: . | sed 's|//.*||' | "
                     "grep -E 'Eigen::(Matrix<|Quaternion<|Quaterniond|Vector2d)' | grep -v 'DontAlign>' || true"),
            "");
  std::istringstream headers(tree.run("cd $PREFIX/include/poinsot; find . -name '*.h' -printf '%P\\n' | sort"));
  std::vector<std::string> without;
  for (std::string header; std::getline(headers, header);)
    if (!leadsToAbi(tree.prefix() / "include" / "poinsot", header)) without.push_back(header);
  EXPECT_THAT(without, ElementsAre("core/expect.h", "core/version.h")) << "these define no type";
}

}  // namespace
}  // namespace poinsot

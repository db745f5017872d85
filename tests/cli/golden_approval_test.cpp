// SPDX-License-Identifier: Apache-2.0
// Tests approval by `poinsot golden` and `diff`: the approved pictures, the printed command, variants and reports.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/golden_images_fixture.h"

namespace poinsot {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

constexpr const char* kStorage = "stored as RGB instead of grey, same pixels; --exact requires the same storage";

class GoldenApproval : public GoldenImagesFixture {
 protected:
  void suite(const std::string& more = "") { manifest("[[test]]\nname = 's'\nimage = 'new.png'\n" + more); }
};

TEST_F(GoldenApproval, ApprovesAnotherStorageFormatWithOptionExact) {
  save("new.png", flat(90));
  suite();
  approve();
  save("new.png", flatRgb(90));
  EXPECT_EQ(golden().out, "1 identical\n");
  const RunResult exact = golden({"--exact", "--junit", "j.xml", "--markdown", "m.md", "--report", "r.html"});
  EXPECT_EQ(exact.exitCode, 1);
  EXPECT_THAT(exact.out, AllOf(StartsWith(std::string("identical  s: ") + kStorage + "\n"),
                               HasSubstr("approve it: poinsot golden golden.toml --exact --update --only s\n")));
  EXPECT_THAT(bytesOf(folder_ / "j.xml"), HasSubstr(std::string("message=\"") + kStorage + "\""));
  EXPECT_THAT(bytesOf(folder_ / "m.md"),
              HasSubstr("stored as RGB instead of grey, same pixels; &#45;&#45;exact requires"));
  approve();  // compares pixels only, without --exact
  EXPECT_EQ(golden({"--exact"}).exitCode, 1);
  EXPECT_EQ(golden({"--exact", "--update", "--only", "s"}).out,
            "ref/s.png: approved, stored as RGB instead of grey, same pixels\n");
  EXPECT_EQ(golden({"--exact"}).out, "1 identical\n");
}

TEST_F(GoldenApproval, ApprovesAnotherStorageFormatInDiffExact) {
  save("r/a.png", flat(90));
  save("t/a.png", flatRgb(90));
  EXPECT_EQ(poinsot({"diff", "r", "t", "--exact", "--junit", "j.xml"}).exitCode, 1);
  EXPECT_THAT(bytesOf(folder_ / "j.xml"),
              AllOf(HasSubstr(kStorage), HasSubstr("approve by poinsot diff r t --exact --update a.png\n")));
  EXPECT_THAT(poinsot({"diff", "r", "t", "--update", "*"}).out, StartsWith("nothing to approve"));
  EXPECT_EQ(poinsot({"diff", "r", "t", "--exact", "--update", "a.png"}).out,
            "r/a.png: approved, stored as RGB instead of grey, same pixels\n");
  EXPECT_EQ(poinsot({"diff", "r", "t", "--exact"}).exitCode, 0);
}

// The printed command must keep the references of other variants and must repeat the options of the run.
TEST_F(GoldenApproval, PrintsACommandWithTheOptionsOfTheRun) {
  save("new.png", flat(90));
  suite();
  approve();
  save("new.png", flat(120));
  suite("variant = 'mesa'\n[[test]]\nname = 'plain'\nimage = 'new.png'\n");
  approve({"--beside"});
  save("new.png", flat(200));
  const RunResult changed = golden({"-o", "o", "--max-memory", "1GiB", "--limit", "side=4096"});
  EXPECT_THAT(changed.out,
              HasSubstr("approve them: poinsot golden golden.toml --limit side=4096 --max-memory 1GiB "
                        "-o o --beside --update --only s plain\n"));
  approve({"--beside", "--only", "s", "plain"});
  EXPECT_TRUE(fs::exists(folder_ / "ref/s.png"));
  EXPECT_TRUE(fs::exists(folder_ / "ref/s@mesa.png"));
  EXPECT_FALSE(fs::exists(folder_ / "ref/plain@other.png"));
  EXPECT_EQ(golden().out, "2 identical\n");
}

TEST_F(GoldenApproval, RejectsAVariantThatNoTestHas) {
  save("new.png", flat(90));
  suite("variant = 'mesa'\n");
  approve();
  const std::string second = "[[test]]\nname = 'b'\nimage = 'new.png'\nvariant = '";
  suite("variant = 'soft'\n" + second + "mesa'\n");
  folder_.put("ref/b.png", bytesOf(folder_ / "ref/s.png"));  // has no description, so no variant
  EXPECT_EQ(golden({"--only", "s"}).exitCode, 2);
  suite("variant = 'mesa'\n" + second + "mesa'\n");
  EXPECT_EQ(golden().out, "2 identical\n");
  EXPECT_EQ(golden({"--only", "b"}).out, "1 identical\n");
}

TEST_F(GoldenApproval, RejectsAVariantWithTheFileNameOfAnother) {
  save("new.png", flat(90));
  suite();
  approve();
  save("new.png", flat(120));
  approve({"--beside", "--variant", "mesa 1"});
  const std::string first = bytesOf(folder_ / "ref/s@mesa_1.png");
  save("new.png", flat(200));
  const RunResult refused = golden({"--update", "--beside", "--variant", "mesa_1"});
  EXPECT_EQ(refused.exitCode, 2);
  EXPECT_THAT(refused.err,
              HasSubstr("ref/s@mesa_1.png: is the reference of 'mesa 1'; the reference of 'mesa_1' would"));
  EXPECT_EQ(bytesOf(folder_ / "ref/s@mesa_1.png"), first);
}

TEST_F(GoldenApproval, RemovesReportsOfAnEarlierRun) {
  save("new.png", flat(90));
  suite();
  approve();
  const std::vector<std::string> reports{"--junit", "j.xml", "--report", "r.html"};
  EXPECT_EQ(golden(reports).exitCode, 0);
  suite("colour = 3\n");
  EXPECT_EQ(golden(reports).exitCode, 2);
  EXPECT_FALSE(fs::exists(folder_ / "j.xml"));
  EXPECT_FALSE(fs::exists(folder_ / "r.html"));
  folder_.put("j.xml", "<theirs/>");
  EXPECT_EQ(golden({"--junit", "j.xml"}).exitCode, 4);
  EXPECT_EQ(bytesOf(folder_ / "j.xml"), "<theirs/>");
}

TEST_F(GoldenApproval, RejectsReportOptions) {
  save("new.png", flat(90));
  suite();
  for (const char* option : {"--junit", "--report", "--markdown", "--outcome"}) {
    const RunResult refused = golden({"--update", option, "file"});
    EXPECT_EQ(refused.exitCode, 2);
    EXPECT_THAT(refused.err,
                HasSubstr(std::string("--update: approves, and writes no reports; leave out ") + option));
    EXPECT_FALSE(fs::exists(folder_ / "file"));
  }
  EXPECT_EQ(golden({"--update", "--json"}).exitCode, 2);
  EXPECT_FALSE(fs::exists(folder_ / "ref"));
}

TEST_F(GoldenApproval, ExplainsHowToRepairATruncatedReference) {
  save("new.png", flat(90));
  suite();
  approve();
  const std::string whole = bytesOf(folder_ / "ref/s.png");
  folder_.put("ref/s.png", whole.substr(0, whole.size() / 2));
  for (const RunResult& torn : {golden(), golden({"--update"})}) {
    EXPECT_EQ(torn.exitCode, 1);
    EXPECT_THAT(torn.out, AllOf(StartsWith("error      s: ref/s.png: "),
                                HasSubstr("; remove ref/s.png and approve again\n")));
  }
}

TEST_F(GoldenApproval, NamesTheSuiteByTheFolderOfItsFile) {
  save("suite/new.png", flat(90));
  folder_.put("suite/golden.toml", "[[test]]\nimage = 'new.png'\n");
  fs::create_directory(folder_ / "suite/deep");
  for (const char* path : {"suite/golden.toml", "suite/./golden.toml", "suite/deep/../golden.toml"}) {
    golden({path, "--junit", "j.xml"});
    EXPECT_THAT(bytesOf(folder_ / "j.xml"), HasSubstr("<testsuite name=\"suite\"")) << path;
  }
}

}  // namespace
}  // namespace poinsot

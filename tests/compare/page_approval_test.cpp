// SPDX-License-Identifier: Apache-2.0
// tests/golden/approval_page_test.py tests pages that the program wrote. This test makes pages that it never
// writes.
#include "compare/page_approval.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/base64.h"
#include "core/error.h"
#include "core/sha256.h"
#include "figure/mark.h"
#include "support/scratch_folder.h"

namespace poinsot::compare {
namespace {

using ::testing::HasSubstr;

class PageApproval : public ::testing::Test {
 protected:
  /// Returns why a page with this data is refused; empty if it is accepted. Commits nothing.
  std::string refusal(const std::string& data) {
    const auto page = folder_ / "report.html";
    std::ofstream(page) << figure::marked(figure::kHtmlMark,
                                          R"(<script id="data" type="application/json">)" + data + "</script>");
    try {
      core::FileBatch batch;
      approveOnPage(batch, page, {"a"}, folder_.path());
      return "";
    } catch (const core::Error& error) {
      return error.what();
    }
  }

  static std::string rowWith(const std::string& file) {
    return R"({"entries": [{"name": "a", "files": [)" + file + "]}]}";
  }

  /// Returns a file entry with a text as its new content.
  static std::string fileAt(const std::string& place) {
    return R"({"place": ")" + place + R"(", "old": null, "text": "new", "new": {"sha256": ")" +
           core::toHex(core::sha256("new")) + R"("}})";
  }

  ScratchFolder folder_;
};

TEST_F(PageApproval, AcceptsAPlaceBelowTheRoot) { EXPECT_EQ(refusal(rowWith(fileAt("golden/a.json"))), ""); }

TEST_F(PageApproval, RefusesPlacesOutsideTheRoot) {
  for (const char* place :
       {"../a.png", "golden/../../a.png", "/etc/a.png", ".git/hooks/a.sh", "sub/.git/a.png", ""})
    EXPECT_THAT(refusal(rowWith(fileAt(place))), HasSubstr("is not the name of a reference")) << place;
}

TEST_F(PageApproval, RefusesPlacesBehindALink) {
  std::filesystem::create_directory_symlink("/tmp", folder_ / "linked");
  EXPECT_NE(refusal(rowWith(fileAt("linked/a.png"))), "");
  EXPECT_FALSE(std::filesystem::exists("/tmp/a.png"));
}

TEST_F(PageApproval, RefusesDamagedData) {
  for (const char* data : {"", "{", "[]", "3", "{}", R"({"entries": 3})"})
    EXPECT_THAT(refusal(data), HasSubstr("has damaged data")) << data;
  for (const char* file : {"3", R"({"place": 3})", R"({"place": "a.png", "new": {"sha256": 3}})"})
    EXPECT_THAT(refusal(rowWith(file)), HasSubstr("has damaged data")) << file;
}

TEST_F(PageApproval, RefusesContentWithAnotherDigest) {
  std::string file = fileAt("a.json");
  file.replace(file.find("\"new\", \"new\""), 12, "\"changed\", \"new\"");
  EXPECT_THAT(refusal(rowWith(file)), HasSubstr("is no longer the picture of the report"));
}

// Oracle: `git hash-object`.
TEST(GitBlob, EqualsTheIdentifierOfGit) {
  EXPECT_EQ(core::toHex(core::gitBlob("")), "e69de29bb2d1d6434b8b29ae775ad8c2e48c5391");
  EXPECT_EQ(core::toHex(core::gitBlob("hello\n")), "ce013625030ba8dba906f756967f9e9ca394464a");
}

// Oracle: the test vectors of RFC 4648, section 10.
TEST(Base64, ReadsWhatItWrites) {
  for (const char* text : {"", "f", "fo", "foo", "foob", "fooba", "foobar"})
    EXPECT_EQ(core::fromBase64(core::base64(text)), text);
  EXPECT_EQ(core::fromBase64("Zm9vYg=="), "foob");
  EXPECT_EQ(core::fromBase64("Zm9v!Ygg"), "foo");
}

}  // namespace
}  // namespace poinsot::compare

// SPDX-License-Identifier: Apache-2.0
// Tests the reports of `poinsot golden` after an update of poinsot or Mesa. Every report names the makers of the
// reference and of the new picture. The test writes the earlier versions into the descriptions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>

#include "cli/golden_images_fixture.h"
#include "core/version.h"
#include "image/png_file.h"

namespace poinsot {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class GoldenOriginReport : public GoldenImagesFixture {
 protected:
  GoldenOriginReport() {
    manifest("size = [64, 48]\n[[test]]\nscene = 's.toml'\n");
    folder_.put("s.toml", kGoodScene);
  }

  nlohmann::json described() const { return nlohmann::json::parse(bytesOf(folder_ / "ref/s.json")); }

  void describe(const std::string& software, const std::string& driver) {
    auto origin = described();
    origin["software"] = software;
    origin["driver"] = driver;
    folder_.put("ref/s.json", origin.dump());
  }

  /// Changes one value of the reference by one level, which counts as near.
  void changeByOneLevel() {
    image::Image picture = image::readPng(folder_ / "ref/s.png");
    std::uint8_t& value = picture.pixels.front();
    value = value > 0 ? value - 1 : 1;
    save("ref/s.png", image::encodePng(picture));
  }

  const std::string software_ = std::string("poinsot ") + core::version();
};

TEST_F(GoldenOriginReport, RecordsTheVersionOfMesa) {
  approve();
  const std::string driver = described()["driver"];
  EXPECT_THAT(driver, StartsWith("Mesa "));
  EXPECT_THAT(std::regex_replace(poinsot({"doctor"}).out, std::regex("\\s+"), " "), HasSubstr(driver));
  EXPECT_EQ(described()["software"], software_);
}

TEST_F(GoldenOriginReport, NamesTheSoftwareOfBothPicturesIfNear) {
  approve();
  const std::string driver = described()["driver"];
  describe("poinsot 0.0.9", "Mesa 1.2.3");
  EXPECT_EQ(golden().out, "1 identical\n");
  changeByOneLevel();
  const std::string change =
      "approved by poinsot 0.0.9 with Mesa 1.2.3, drawn by " + software_ + " with " + driver;
  const RunResult near = golden({"--junit", "j.xml", "--report", "r.html"});
  EXPECT_EQ(near.exitCode, 0);
  EXPECT_EQ(near.out, "near       s: " + change + "\n1 near\n");
  EXPECT_THAT(bytesOf(folder_ / "j.xml"),
              AllOf(HasSubstr("<system-out>near: " + change + "</system-out>"), HasSubstr("failures=\"0\"")));
  EXPECT_THAT(bytesOf(folder_ / "r.html"), HasSubstr("\"message\":\"" + change + "\""));
  const auto json = nlohmann::json::parse(golden({"--json"}).out)["pictures"][0];
  EXPECT_EQ(json["message"], change);
  EXPECT_EQ(json["approved_by"]["software"], "poinsot 0.0.9");
  EXPECT_EQ(json["drawn_by"]["driver"], driver);
  EXPECT_EQ(json["approved_by"]["scene_sha256"], json["drawn_by"]["scene_sha256"]);
}

TEST_F(GoldenOriginReport, NamesTheSoftwareOfBothPicturesIfDifferent) {
  approve();
  describe("poinsot 0.0.9", described()["driver"]);
  folder_.put("s.toml", std::string(kGoodScene) + "[style]\ntheme = 'dark'\n");
  const std::string change = "; approved by poinsot 0.0.9, drawn by " + software_;
  const RunResult different =
      golden({"--junit", "j.xml", "--report", "r.html", "--markdown", "m.md", "--outcome", "o.js"});
  EXPECT_EQ(different.exitCode, 1);
  EXPECT_THAT(different.out, AllOf(StartsWith("different  s: largest difference "), HasSubstr(change)));
  for (const char* report : {"j.xml", "r.html", "o.js"})
    EXPECT_THAT(bytesOf(folder_ / report), HasSubstr(change)) << report;
  EXPECT_THAT(bytesOf(folder_ / "m.md"), HasSubstr("approved by poinsot 0&#46;0&#46;9, drawn by "));
  EXPECT_THAT(nlohmann::json::parse(golden({"--json"}).out)["pictures"][0]["message"].get<std::string>(),
              HasSubstr(change));
}

TEST_F(GoldenOriginReport, ChangesWhenAPictureIsApproved) {
  approve();
  describe("poinsot 0.0.9", "Mesa 1.2.3");
  EXPECT_THAT(golden({"--update"}).out, StartsWith("nothing to approve"));
  EXPECT_EQ(described()["software"], "poinsot 0.0.9");
  changeByOneLevel();
  approve();
  EXPECT_EQ(described()["software"], software_);
  EXPECT_EQ(golden().out, "1 identical\n");
}

TEST_F(GoldenOriginReport, OmitsFactsThatTheDescriptionLacks) {
  approve();
  auto origin = described();
  origin.erase("driver");
  folder_.put("ref/s.json", origin.dump());
  changeByOneLevel();
  EXPECT_EQ(golden().out, "near       s\n1 near\n");
}

TEST_F(GoldenOriginReport, NamesTheSoftwareInPngsOfOtherPrograms) {
  const auto drawnBy = [&](const std::string& version, int level) {
    const std::string text = std::string("Software\0", 9) + version;
    save("new.png", pngBytes({16, 12, 8, 0, {pngChunk("tEXt", {text.begin(), text.end()})}},
                             Bytes(16 * 12, static_cast<std::uint8_t>(level))));
  };
  manifest("[[test]]\nimage = 'new.png'\n");
  drawnBy("Matplotlib version3.10.0", 90);
  approve();
  drawnBy("Matplotlib version3.11.0", 95);
  EXPECT_THAT(golden().out, HasSubstr("approved by Matplotlib version3.10.0, drawn by Matplotlib version3.11.0"));
}

}  // namespace
}  // namespace poinsot

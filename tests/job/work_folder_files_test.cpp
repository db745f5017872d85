// SPDX-License-Identifier: Apache-2.0
// Files in a work folder may come from anyone, and are accepted only if they are what this program writes.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json.h"
#include "job/job_record.h"
#include "job/segment_record.h"
#include "support/scratch_folder.h"
#include "support/text_of.h"

namespace poinsot::job {
namespace {

using Json = nlohmann::ordered_json;

const request::OutputTarget kFilm{request::OutputKind::kFilm, "film.mp4"};

JobRecord filmJob() {
  JobRecord job;
  job.digest = "5f";
  job.scene = "a0";
  job.settings = "{}";
  job.film = {output::FilmContainer::kMp4, {30, 1}};
  job.frames = {0, 89};
  job.title = "Rolling";
  job.subtitles = {{0, 1500, "L is fixed"}};
  return job;
}

class JobRecords : public testing::Test {
 protected:
  JobRecords() {
    writeJobRecord(folder_.path(), filmJob());
    written_ = Json::parse(textOf(folder_ / "job.json"));
  }

  /// Returns whether the job record is accepted with one of its values replaced.
  bool isTaken(const std::string& key, const Json& value) const {
    Json changed = written_;
    changed[key] = value;
    return parseJobRecord(changed.dump(), kFilm).has_value();
  }

  ScratchFolder folder_;
  Json written_;
};

TEST_F(JobRecords, RoundTripThroughTheirFile) {
  const auto read = readJobRecord(folder_.path(), kFilm);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames, (request::FrameRange{0, 89}));
  EXPECT_EQ(read->title, "Rolling");
  EXPECT_EQ(read->subtitles.at(0).text, "L is fixed");
  EXPECT_EQ(read->segments().size(), 3u);
}

TEST_F(JobRecords, RejectNumbersOutOfRange) {
  EXPECT_TRUE(isTaken("frames", {0, kMostJobFrames - 1}));
  EXPECT_FALSE(isTaken("frames", {0, kMostJobFrames}));
  EXPECT_FALSE(isTaken("frames", {0, 9'000'000'000'000'000'000}));
  EXPECT_FALSE(isTaken("frames", {std::numeric_limits<std::int64_t>::min(), 1}));
  EXPECT_FALSE(isTaken("frames", {5, 4}));
  EXPECT_TRUE(isTaken("segment_frames", kMostJobFrames));
  EXPECT_FALSE(isTaken("segment_frames", std::numeric_limits<std::int64_t>::max()));
  EXPECT_FALSE(isTaken("segment_frames", 0));
  EXPECT_TRUE(isTaken("shards", request::kMostShards));
  EXPECT_FALSE(isTaken("shards", request::kMostShards + 1));
  EXPECT_FALSE(isTaken("shards", 0));
  EXPECT_FALSE(isTaken("shards", (std::int64_t{1} << 32) + 1));
  EXPECT_FALSE(isTaken("shards", 1.0));
  EXPECT_FALSE(isTaken("segment_frames", 1e300));
}

TEST_F(JobRecords, RejectAnotherKindOfTarget) {
  EXPECT_FALSE(isTaken("kind", static_cast<int>(request::OutputKind::kSequence)));
  EXPECT_FALSE(isTaken("kind", 77));
  EXPECT_FALSE(isTaken("container", "gif"));
  EXPECT_FALSE(isTaken("fps", "0"));
  EXPECT_FALSE(readJobRecord(folder_.path(), {request::OutputKind::kSequence, "f_{frame}.png"}));
}

TEST(Json, LimitsNesting) {
  const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(core::parseJson(nested(core::kDeepestJson)).size(), 1u);
  EXPECT_THROW(core::parseJson(nested(core::kDeepestJson + 1)), core::Error);
  EXPECT_THROW(core::parseJson(std::string(1'000'000, '[')), core::Error);
  EXPECT_THROW(core::parseJson("{\"a\": \xff}"), core::Error);
}

TEST(Json, AcceptsOnlyWholeNumbersOf64Bits) {
  EXPECT_EQ(core::wholeNumber(core::parseJson("-9223372036854775808")), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(core::wholeNumber(core::parseJson("9223372036854775807")), std::numeric_limits<std::int64_t>::max());
  for (const char* other : {"9223372036854775808", "1e300", "1.0", "true", "\"1\"", "[1]"})
    EXPECT_THROW(core::wholeNumber(core::parseJson(other)), core::Error) << other;
}

TEST(Json, LimitsTheSizeOfAFile) {
  const ScratchFolder folder;
  const auto blanks = folder.put("a.json", "[]" + std::string(core::kMostJsonBytes - 2, ' '));
  EXPECT_TRUE(core::readJson(blanks).empty());
  folder.put("a.json", "[]" + std::string(core::kMostJsonBytes - 1, ' '));
  EXPECT_THROW(core::readJson(blanks), core::Error);
}

/// Fixture with the record of frames 3 to 5 of a sequence, whose pictures lie beside the work folder.
class SegmentRecordTest : public testing::Test {
 protected:
  SegmentRecordTest() {
    std::filesystem::create_directory(work());
    SegmentRecord record{{3, 5}, "5f", "llvmpipe", {"a", "b", "c"}, {}};
    for (const char* name : {"f_3.png", "f_4.png", "f_5.png"})
      record.files.push_back(recordOf(folder_.put(name, name)));
    records().keep(record);
    whole_ = text();
  }

  std::filesystem::path work() const { return folder_ / ".work"; }
  SegmentRecords records() const {
    return {work(), {request::OutputKind::kSequence, (folder_ / "f_{frame}.png").string()}};
  }
  std::string text() const { return textOf(records().fileOf({3, 5})); }
  /// Returns the state of the record with a piece of its text replaced.
  SegmentState stateWith(const std::string& old, const std::string& changed) const {
    std::string forged = whole_;
    forged.replace(forged.find(old), old.size(), changed);
    folder_.put(".work/segment-000000003-000000005.json", forged);
    return records().stateOf({3, 5}, "5f");
  }

  ScratchFolder folder_;
  std::string whole_;
};

TEST_F(SegmentRecordTest, RoundTripsAndDetectsChangedFiles) {
  EXPECT_NE(text().find("\"../f_3.png\""), std::string::npos) << text();
  EXPECT_EQ(records().stateOf({3, 5}, "5f"), SegmentState::kDone);
  EXPECT_EQ(records().stateOf({3, 5}, "60"), SegmentState::kStale);
  EXPECT_EQ(stateWith("\"bytes\":7", "\"bytes\":8"), SegmentState::kCorrupt);
}

// None of these names is opened, even if a file has it.
TEST_F(SegmentRecordTest, RejectsNamesOfOtherFiles) {
  for (const char* name : {"/etc/passwd", "../../f_3.png", "../f_4.png", "f_3.png", "../f_3.png/", ""})
    EXPECT_EQ(stateWith("../f_3.png", name), SegmentState::kMissing) << name;
  EXPECT_EQ(stateWith("\"frames\":[3,5]", "\"frames\":[3,4]"), SegmentState::kMissing);
}

TEST_F(SegmentRecordTest, RejectsFilesThatAreNotRegular) {
  std::filesystem::remove(folder_ / "f_4.png");
  ASSERT_EQ(::mkfifo((folder_ / "f_4.png").c_str(), 0600), 0);
  EXPECT_EQ(records().stateOf({3, 5}, "5f"), SegmentState::kCorrupt);  // and does not wait
  std::filesystem::remove(folder_ / "f_4.png");
  std::filesystem::create_symlink("/dev/zero", folder_ / "f_4.png");
  EXPECT_EQ(records().stateOf({3, 5}, "5f"), SegmentState::kCorrupt);  // and comes to an end
}

}  // namespace
}  // namespace poinsot::job

// SPDX-License-Identifier: Apache-2.0
#include "cluster/submission.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cluster/submission_text.h"
#include "core/error.h"
#include "request/memory.h"
#include "support/hostile_words.h"
#include "support/shell_run.h"

namespace poinsot::cluster {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

Division divided(const DivisionRequest& request, std::int64_t frames, image::PixelSize size = {1920, 1080}) {
  const request::FrameRange all{0, frames - 1};
  return divisionOf(request, all, request::segmentsOf(all), size,
                    request::workerMemory_bytes(size, output::FilmFormat()));
}

TEST(Division, MakesTasksOfTheRequestedTime) {
  // 3600 frames of 1 s on a CPU are an hour.
  EXPECT_EQ(divided({.task_s = 600, .frame_s = 1}, 3600).shards, 6);
  EXPECT_EQ(divided({.cpus = 2, .task_s = 600, .frame_s = 1}, 3600).shards, 3);
  EXPECT_DOUBLE_EQ(divided({.task_s = 600, .frame_s = 1}, 3600).task_s, 600);
  EXPECT_DOUBLE_EQ(divided({.cpus = 2, .task_s = 600, .frame_s = 1}, 3600).task_s, 600);
  EXPECT_EQ(divided({.task_s = 600, .frame_s = 1}, 3601).shards, 7);
}

TEST(Division, HasNoTaskWithoutWork) {
  EXPECT_EQ(divided({.frame_s = 1000}, 60).shards, 2);  // two segments
  EXPECT_EQ(divided({.shards = 7}, 60).shards, 2);
  EXPECT_EQ(divided({.frame_s = 1e-3}, 60).shards, 1);
}

TEST(Division, StaysWithinTheArrayLimitOfSlurmByDefault) {
  EXPECT_EQ(divided({.frame_s = 1000}, 300'000).shards, 1000);
  EXPECT_EQ(divided({.shards = 5000}, 300'000).shards, 5000);
}

// The longest task counts: if two tasks share three segments, one of them has two.
TEST(Division, ReportsTheTimeOfTheLongestTask) {
  EXPECT_DOUBLE_EQ(divided({.shards = 2, .frame_s = 1}, 90).task_s, 60);
  EXPECT_DOUBLE_EQ(divided({.shards = 2, .frame_s = 1}, 65).task_s, 35);
}

TEST(Division, ALargePictureTakesMoreTimeAndMemory) {
  const Division small = divided({}, 300, {640, 360}), large = divided({}, 300, {3840, 2160});
  EXPECT_GT(large.frame_s, 5 * small.frame_s);
  EXPECT_GT(large.memory, small.memory);
  EXPECT_EQ(large.memory, 1536);  // a worker takes 920 MiB, its parent 40
}

Submission tiny() {
  Submission submission;
  submission.program = {"/opt/poinsot"};
  submission.folder = "/work";
  submission.output = {request::OutputKind::kFilm, "out/film.mp4"};
  submission.render = {"render", "a.toml", "-o", "out/film.mp4", "-j", "2"};
  submission.assemble = {"assemble", "out/film.mp4"};
  submission.inputs = {"a.toml"};
  submission.frames = 90;
  submission.pieces = "3 segments";
  submission.division = {3, 2, 1.0, 15, 768};
  return submission;
}

TEST(Scripts, AreValidBashWithAnyNames) {
  for (const std::string& word : kHostileWords) {
    Submission submission = tiny();
    submission.folder = "/work/" + word;
    submission.render = {"render", word, "-D", word};
    const bool slurmCan = word.find('\\') == std::string::npos;
    const auto check = [&](const std::string& script) {
      return runShell("/", "bash -n <<'END OF THE SCRIPT'\n" + script + "END OF THE SCRIPT\n").out;
    };
    EXPECT_EQ(check(parallelScript(submission)), "") << word;
    submission.setup = {word, "true # " + word};
    EXPECT_EQ(check(linesScript(submission)), "") << word;
    if (slurmCan)
      EXPECT_EQ(check(slurmScript(submission)), "") << word;
    else
      EXPECT_THROW(slurmScript(submission), core::Error) << word;
  }
}

TEST(Scripts, RequestCpusMemoryAndTimeFromSlurm) {
  const std::string script = slurmScript(tiny());
  EXPECT_THAT(script, AllOf(HasSubstr(" --shards-left 3) && exit "), HasSubstr("--cpus-per-task=2 "),
                            HasSubstr("--requeue"), HasSubstr("--mem-per-cpu=768M --time=6 ")));
  EXPECT_THAT(script, HasSubstr(" --mem-per-cpu=256M --time=6 --output=\"$log/%j_join.txt\")"));
  EXPECT_THAT(script, AllOf(HasSubstr("--dependency=\"afterok:$array\" --kill-on-invalid-dep=yes"),
                            HasSubstr("--shard \"$SLURM_ARRAY_TASK_ID/3\"")));
}

TEST(Scripts, RejectNamesThatMakeCannotHandle) {
  for (const std::string name : {"a%b.toml", "a;b.toml", "a|b.toml", "a\\b.toml", "a\nb.toml"}) {
    Submission submission = tiny();
    submission.inputs.push_back(name);
    try {
      makeScript(submission);
      ADD_FAILURE() << name;
    } catch (const core::Error& error) {
      EXPECT_EQ(error.kind(), core::ErrorKind::kUsage);
      EXPECT_THAT(error.what(), HasSubstr("make cannot handle the '"));
    }
  }
}

TEST(FilledTemplate, ReplacesOnlyKnownNamesBetweenAtSigns) {
  EXPECT_EQ(filled("run @a@ \"$@\" ${x[@]}@b@ --signal=USR1@60 @a", {{"a", "@b@"}, {"b", "2"}}),
            "run @b@ \"$@\" ${x[@]}2 --signal=USR1@60 @a");
  EXPECT_EQ(filled("@a@", {{"a", ""}}), "");
}

}  // namespace
}  // namespace poinsot::cluster

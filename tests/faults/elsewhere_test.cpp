// SPDX-License-Identifier: Apache-2.0
// The bytes of --reproducible are the same at another time, on another machine and with another CPU's
// instructions.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "faults/tiny_film.h"
#include "support/shell_run.h"

namespace poinsot::faults {
namespace {

const std::filesystem::path kMark = ".harness-told";

std::vector<std::string> words() {
  return {"render",   POINSOT_SOURCE_DIR "/scenes/football.toml",
          "-o",       "t.mp4",
          "--size",   "320x180",
          "--frames", "0-11",
          "-j",       "1",
          "--quiet",  "--reproducible"};
}

/// The film that is made in those surroundings.
std::string film(const ScratchFolder& folder, std::vector<std::string> environment = {}) {
  environment.emplace_back("LD_PRELOAD=" POINSOT_ELSEWHERE);
  const RunResult made = run(folder, words(), Stdout::kFile, environment);
  EXPECT_EQ(made.exitCode, 0) << made.err;
  return bytesOf(folder / "t.mp4");
}

std::string film(const std::vector<std::string>& environment) { return film(ScratchFolder(), environment); }

const std::string& filmHere() {
  static const std::string bytes = film(std::vector<std::string>());
  return bytes;
}

/// With the instructions that x264 calls by this name; empty where this x264 cannot be told.
std::string filmWithAsm(const std::string& name) {
  const ScratchFolder folder;
  const std::string mark = (folder / kMark).string();
  std::string bytes = film(folder, {"ELSEWHERE_ASM=" + name, "ELSEWHERE_MARK=" + mark});
  return std::filesystem::exists(mark) ? bytes : "";
}

TEST(Elsewhere, ItsInstructionsEncodeTheSameStream) {
  const std::string plain = filmWithAsm("SSE2");
  if (plain.empty()) GTEST_SKIP() << "libavcodec has no x264 of the interfaces that elsewhere.cpp knows";
  EXPECT_EQ(filmWithAsm("SSSE3"), filmHere());
  EXPECT_EQ(filmWithAsm("AVX2"), filmHere());
  // The control: x264 goes by what it is told. This is what a CPU of before 2006 would make.
  EXPECT_NE(plain, filmHere());
  for (const char* name : {"x264", "Lav"}) EXPECT_EQ(filmHere().find(name), std::string::npos) << name;
}

/// The film of nobody, where root may become that.
std::string filmOfNobody() {
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  std::string command = "exec setpriv --reuid=65534 --regid=65534 --clear-groups " POINSOT_PROGRAM;
  for (const std::string& word : words()) command += ' ' + word;
  const ShellResult made = runShell(folder.path(), command, {"HOME=/nonexistent"});
  EXPECT_EQ(made.exitCode, 0) << made.out;
  return bytesOf(folder / "t.mp4");
}

/// How a render to it ends where libavcodec lacks these.
RunResult renderWithout(const std::string& encoders, const std::string& target) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  RunResult refused = run(folder, {"render", "tiny.toml", "-o", target}, Stdout::kFile,
                          {"LD_PRELOAD=" POINSOT_ELSEWHERE, "ELSEWHERE_LACKS=" + encoders});
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"tiny.toml"});
  return refused;
}

TEST(Elsewhere, AnEncoderThatItLacksIsNamedBesideThoseThatItHas) {
  const RunResult mp4 = renderWithout("libx264", "t.mp4");
  EXPECT_EQ(mp4.exitCode, 3);
  EXPECT_THAT(mp4.err,
              testing::HasSubstr("the FFmpeg of this machine has no encoder libx264, which a film of h264 "
                                 "takes; it can make: hevc, prores, vp9, av1, gif, apng\n"));
  const RunResult webm = renderWithout("libvpx-vp9,libx265", "t.webm");
  EXPECT_EQ(webm.exitCode, 3);
  EXPECT_THAT(webm.err, testing::HasSubstr("no encoder libvpx-vp9, which a film of vp9 takes; it can make: h264, "
                                           "prores, av1, gif, apng\n"));
  // A GIF's segments are kept with another encoder.
  const RunResult gif = renderWithout("ffv1", "t.gif");
  EXPECT_EQ(gif.exitCode, 3);
  EXPECT_THAT(gif.err, testing::HasSubstr("no encoder ffv1, which a film of gif takes; it can make: h264, hevc, "
                                          "prores, vp9, av1\n"));
  const RunResult any = renderWithout("libx264,libx265,prores_ks,libvpx-vp9,libsvtav1,gif,apng", "t.mp4");
  EXPECT_THAT(any.err, testing::HasSubstr("it can make: no film\n"));
}

TEST(Elsewhere, ItsClockItsNameItsCLibraryAndItsUserDoNotShow) {
  EXPECT_EQ(film({"ELSEWHERE_DAYS=400", "ELSEWHERE_HOST=elsewhere",
                  "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"}),
            filmHere());
  if (::geteuid() == 0) {
    EXPECT_EQ(filmOfNobody(), filmHere());
  }
}

}  // namespace
}  // namespace poinsot::faults

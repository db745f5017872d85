// SPDX-License-Identifier: Apache-2.0
// The bytes of --reproducible are the same at another time, on another machine and with another CPU's
// instructions.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <regex>

#include "faults/tiny_film.h"
#include "support/sanitized.h"
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

/// Returns the film made with the instructions that x264 calls `name`; empty if this x264 does not accept them.
std::string filmWithAsm(const std::string& name, std::vector<std::string> environment = {}) {
  const ScratchFolder folder;
  const std::string mark = (folder / kMark).string();
  environment.insert(environment.end(), {"ELSEWHERE_ASM=" + name, "ELSEWHERE_MARK=" + mark});
  std::string bytes = film(folder, environment);
  return std::filesystem::exists(mark) ? bytes : "";
}

TEST(OtherMachine, EncodesTheSameStreamWithOtherCpuInstructions) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const std::string plain = filmWithAsm("SSE2");
  if (plain.empty()) GTEST_SKIP() << "libavcodec has no x264 of the interfaces that elsewhere.cpp knows";
  EXPECT_EQ(plain, filmHere());  // as a CPU from before 2006 would make it
  EXPECT_EQ(filmWithAsm("SSSE3"), filmHere());
  EXPECT_EQ(filmWithAsm("AVX2"), filmHere());
  // Control: x264 obeys the settings. If it may choose its algorithms by the instructions, it makes another film.
  EXPECT_NE(filmWithAsm("AVX2", {"ELSEWHERE_WAYS=1"}), filmHere());
  for (const char* name : {"x264", "Lav"}) EXPECT_EQ(filmHere().find(name), std::string::npos) << name;
}

// If a driver setting gets past all checks, nothing is made and nothing approved.
TEST(OtherMachine, RejectsADriverThatDrawsNothing) {
  POINSOT_NOT_SANITIZED("functions are put in the place of others");
  const std::vector<std::vector<std::string>> commands{{"render", "tiny.toml", "-o", "t.mp4", "--size", "64x36"},
                                                       {"render", "tiny.toml", "-o", "t.mp4", "--shard", "1/2"},
                                                       {"still", "tiny.toml", "-o", "t.png"},
                                                       {"still", "tiny.toml", "-o", "t.pdf"},
                                                       {"golden", "--update"}};
  for (const auto& command : commands)
    for (const char* setting : {"LP_NO_RAST=1", "GALLIUM_NOOP=1", "ST_DEBUG=wf"}) {
      const ScratchFolder folder;
      folder.put("tiny.toml", kTinyScene);
      folder.put("golden.toml", "size = [64, 36]\n[[test]]\nscene = 'tiny.toml'\n");
      const RunResult made =
          run(folder, command, Stdout::kFile,
              {"LD_PRELOAD=" POINSOT_ELSEWHERE, std::string("ELSEWHERE_SETS=") + setting, "CI="});
      // An error in one test of a suite gives exit code 1 and a line in its report.
      EXPECT_EQ(made.exitCode, command[0] == "golden" ? 1 : 3) << command[0] << ' ' << setting;
      // With GALLIUM_NOOP, Mesa 25 ends its process.
      EXPECT_THAT(made.out + made.err, testing::ContainsRegex("does not draw|was killed by signal 11"))
          << command[0] << ' ' << setting;
      for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
        EXPECT_THAT(entry.path().extension(), testing::Not(testing::AnyOf(".png", ".mp4", ".pdf")))
            << entry.path();
    }
}

/// Returns the film made as user nobody, if this test runs as root.
std::string filmOfNobody() {
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  std::string command = "exec setpriv --reuid=65534 --regid=65534 --clear-groups " POINSOT_PROGRAM;
  for (const std::string& word : words()) command += ' ' + word;
  const ShellResult made = runShell(folder.path(), command, {"HOME=/dev/null/home"});
  EXPECT_EQ(made.exitCode, 0) << made.out;
  return bytesOf(folder / "t.mp4");
}

/// Renders with a setting and returns the refusal. Expects that no file is left.
RunResult refusedRender(const std::string& target, const std::string& setting) {
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  RunResult refused = run(folder, {"render", "tiny.toml", "-o", target}, Stdout::kFile,
                          {"LD_PRELOAD=" POINSOT_ELSEWHERE, setting});
  EXPECT_EQ(refused.exitCode, 3);
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"tiny.toml"});
  return refused;
}

RunResult renderWithout(const std::string& encoders, const std::string& target) {
  return refusedRender(target, "ELSEWHERE_LACKS=" + encoders);
}

TEST(OtherMachine, NamesAMissingEncoderAndTheAlternatives) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const RunResult mp4 = renderWithout("libx264", "t.mp4");
  EXPECT_THAT(mp4.err, testing::HasSubstr("the FFmpeg of this machine has no encoder libx264, which a film in "
                                          "h264 needs; choose another output.codec (hevc, prores, vp9, av1, gif, "
                                          "apng) or install an FFmpeg that has it, such as Debian's\n"));
  const RunResult webm = renderWithout("libvpx-vp9,libx265", "t.webm");
  EXPECT_THAT(webm.err, testing::HasSubstr("no encoder libvpx-vp9, which a film in vp9 needs; choose another "
                                           "output.codec (h264, prores, av1, gif, apng) or install"));
  // Segments of a GIF are stored with another encoder.
  const RunResult gif = renderWithout("ffv1", "t.gif");
  EXPECT_THAT(gif.err, testing::HasSubstr("no encoder ffv1, which a film in gif needs; choose another "
                                          "output.codec (h264, hevc, prores, vp9, av1) or install"));
  const RunResult any = renderWithout("libx264,libx265,prores_ks,libvpx-vp9,libsvtav1,gif,apng", "t.mp4");
  EXPECT_THAT(any.err, testing::HasSubstr("which a film in h264 needs; install an FFmpeg that has it"));
}

/// Runs a command with a Mesa setting that is applied after the program has cleared its environment.
RunResult withMesa(const ScratchFolder& folder, const std::string& setting, const std::vector<std::string>& words,
                   std::vector<std::string> more = {}) {
  folder.put("tiny.toml", kTinyScene);
  more.insert(more.end(), {"LD_PRELOAD=" POINSOT_ELSEWHERE, "ELSEWHERE_SETS=" + setting});
  return run(folder, words, Stdout::kFile, more);
}

std::string oneLine(const std::string& text) { return std::regex_replace(text, std::regex("\\s+"), " "); }

// Mesa falls back to softpipe if it was built without LLVM. This setting has the same effect with LLVM.
TEST(OtherMachine, NotesAMesaWithoutLlvmpipeAndWhatToInstall) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const ScratchFolder folder;
  const std::string softpipe = "GALLIUM_DRIVER=softpipe";
  folder.put("golden.toml", "size = [64, 36]\n[[test]]\nscene = 'tiny.toml'\n");
  const std::string note =
      "this Mesa has no llvmpipe, and softpipe draws more slowly and some pixels differently; "
      "install a Mesa that has it (Debian: libgl1-mesa-dri)";
  const RunResult doctor = withMesa(folder, softpipe, {"doctor"});
  EXPECT_EQ(doctor.exitCode, 0);
  const std::string found = oneLine(doctor.out);
  EXPECT_THAT(found, testing::ContainsRegex("ok OpenGL egl softpipe, OpenGL [^;]*; this Mesa"));
  EXPECT_THAT(found, testing::HasSubstr(note));
  const RunResult still = withMesa(folder, softpipe, {"still", "tiny.toml", "-o", "t.png"});
  EXPECT_EQ(still.exitCode, 0) << still.err;
  EXPECT_THAT(still.err, testing::HasSubstr("poinsot: note: " + note + "\n"));
  for (const auto& words : std::vector<std::vector<std::string>>{{"gallery", "tiny.toml", "-o", "g", "--no-sheet"},
                                                                 {"golden", "golden.toml", "-o", "new"}})
    EXPECT_THAT(withMesa(folder, softpipe, words).err, testing::HasSubstr("poinsot: note: " + note + "\n"));
  const RunResult usual = withMesa(folder, "GALLIUM_DRIVER=llvmpipe", {"still", "tiny.toml", "-o", "u.png"});
  EXPECT_EQ(usual.exitCode, 0) << usual.err;
  EXPECT_THAT(usual.err, testing::Not(testing::HasSubstr("note:")));
}

TEST(OtherMachine, ReportsAMesaWithoutDriversAndWhatToInstall) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const ScratchFolder folder;
  const std::vector<std::string> noOsMesa{"ELSEWHERE_HIDES=libOSMesa"};
  const std::string advice =
      "EGL has no surfaceless Mesa display; install it with: apt-get install libgl1-mesa-dri";
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"doctor"}, {"still", "tiny.toml", "-o", "t.png"}}) {
    const RunResult refused = withMesa(folder, "__EGL_VENDOR_LIBRARY_DIRS=/nowhere", words, noOsMesa);
    EXPECT_EQ(refused.exitCode, words[0] == "doctor" ? 1 : 3);
    EXPECT_THAT(oneLine(refused.out + refused.err), testing::HasSubstr(advice));
  }
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{"tiny.toml"});
}

TEST(OtherMachine, ReportsAMissingLibraryBeforeDrawing) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const auto named = [](const std::string& library, const std::string& package) {
    return testing::ContainsRegex(library + " cannot be opened: .*No such file or directory; install it with: " +
                                  "apt-get install " + package + "\n");
  };
  const std::string noCodecs = "ELSEWHERE_HIDES=libavcodec", noPalettes = "ELSEWHERE_HIDES=libimagequant";
  EXPECT_THAT(refusedRender("t.mp4", noCodecs).err, named("libavcodec.so.[0-9]+", "libavcodec[0-9]+"));
  EXPECT_THAT(refusedRender("t.apng", noCodecs).err, named("libavcodec.so.[0-9]+", "libavcodec[0-9]+"));
  EXPECT_THAT(refusedRender("t.gif", noPalettes).err, named("libimagequant.so.0", "libimagequant0"));
}

TEST(OtherMachine, WritesAllOutputsExceptFilmsWithoutFfmpeg) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  const ScratchFolder folder;
  folder.put("tiny.toml", kTinyScene);
  folder.put("t.mp4", "no film");
  const std::vector<std::string> there{"LD_PRELOAD=" POINSOT_ELSEWHERE, "ELSEWHERE_HIDES=libav"};
  const auto ends = [&](const std::vector<std::string>& words) {
    return run(folder, words, Stdout::kFile, there);
  };
  const RunResult version = ends({"--version"});
  EXPECT_EQ(version.exitCode, 0);
  EXPECT_THAT(version.out, testing::ContainsRegex("\nFFmpeg not found: libavutil.so.[0-9]+ cannot be opened: .*"));
  EXPECT_EQ(ends({"still", "tiny.toml", "-o", "t.png", "--quiet"}).exitCode, 0);
  EXPECT_EQ(ends({"render", "tiny.toml", "-o", "t_{frame}.png", "--frames", "0-1", "--quiet"}).exitCode, 0);
  const RunResult diff = ends({"diff", "t.mp4", "t.mp4"});
  EXPECT_EQ(diff.exitCode, 3);
  EXPECT_THAT(diff.err, testing::HasSubstr("cannot be opened"));
  // Without the libraries, the program cannot recognise its own file.
  EXPECT_EQ(ends({"render", "tiny.toml", "-o", "t.mp4"}).exitCode, 3);
  EXPECT_EQ(bytesOf(folder / "t.mp4"), "no film");
}

TEST(OtherMachine, GivesTheSameBytesWithOtherClockHostAndUser) {
  POINSOT_NOT_SANITIZED("libraries are put in the place of others");
  EXPECT_EQ(film({"ELSEWHERE_DAYS=400", "ELSEWHERE_HOST=elsewhere",
                  "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"}),
            filmHere());
  if (::geteuid() == 0) {
    EXPECT_EQ(filmOfNobody(), filmHere());
  }
}

}  // namespace
}  // namespace poinsot::faults

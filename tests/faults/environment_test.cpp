// SPDX-License-Identifier: Apache-2.0
// Settings that libraries read from the environment change no byte. Each setting is compared, one at a time, with
// an environment without settings.
#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <sstream>

#include "core/environment.h"
#include "faults/tiny_film.h"
#include "support/sanitized.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScene =
    "[body]\nprincipal_moments = [1, 2, 2.5]\n"
    "[motion]\nomega_body = [0.05, \"20 rpm\", 0]\n"
    "[time]\nduration = 0.2\nfps = 10\n";

/// Options for drivers of EGL: one may change pixels, the other changes the renderer's name in a film.
constexpr const char* kDriverSettings =
    "<driconf><device><application name=\"any\"><option name=\"force_glsl_abs_sqrt\" value=\"true\"/>"
    "<option name=\"force_gl_renderer\" value=\"another\"/></application></device></driconf>";

using Words = std::vector<std::string>;

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

/// Returns the commands that make the files, indexed by Made.
const std::vector<Words>& makings() {
  static const Words film{"render", "s.toml", "--size", "64x36", "-j", "1", "--quiet", "-o"};
  static const Words still{"still", "s.toml", "--size", "64x36", "--quiet", "-o"};
  static const std::vector<Words> all{
      with(film, {"a.mp4"}),  with(film, {"a.gif"}),  with(film, {"e.mp4", "--backend", "egl"}),
      with(still, {"a.png"}), with(still, {"a.pdf"}), {"golden", "--update"}};
  return all;
}
enum Made : int { kMp4, kGif, kEglFilm, kStill, kPdf, kGolden };

/// File that each command makes, indexed by Made.
constexpr const char* kMadeFiles[] = {"a.mp4", "a.gif", "e.mp4", "a.png", "a.pdf", "golden/s.png"};

/// Settings, and the outputs that they might change. Each setting is tried with one of these outputs in turn, and
/// at night with all outputs.
struct Family {
  std::vector<int> made;
  Words settings;
};
const std::vector<Family> kFamilies{
    // llvmpipe and its surroundings: driver, JIT compiler, vertices, state tracker, caches, debugging layers
    {{kStill, kGolden, kStill, kMp4},
     {"LP_NO_RAST=1",
      "LP_NUM_THREADS=7",
      "LP_NATIVE_VECTOR_WIDTH=128",
      "LP_PERF=no_blend,no_depth",
      "LP_DEBUG=tex,setup",
      "LP_CL=1",
      "GALLIUM_NOOP=1",
      "GALLIUM_NOSSE=1",
      "GALLIUM_TRACE=trace.xml",
      "GALLIUM_DDEBUG=always",
      "GALLIUM_DRIVER=softpipe",
      "GALLIUM_OVERRIDE_CPU_CAPS=sse2",
      "GALLIUM_DUMP_CPU=1",
      "GALLIUM_PRINT_OPTIONS=1",
      "GALLIVM_PERF=rho_approx,nopt",
      "GALLIVM_DEBUG=perf",
      "DRAW_USE_LLVM=0",
      "DRAW_FSE=1",
      "DRAW_NO_FSE=1",
      "ST_DEBUG=wf",
      "ST_DEBUG=mesa,tgsi",
      "SOFTPIPE_DEBUG=no_rast",
      "TGSI_PRINT_SANITY=1",
      "NIR_DEBUG=print",
      "GLSL_VALIDATE=1",
      "INTEL_BLACKHOLE_DEFAULT=1",
      "MESA_GLSL=nopt,dump",
      "MESA_GL_VERSION_OVERRIDE=2.1",
      "MESA_GLSL_VERSION_OVERRIDE=120",
      "MESA_EXTENSION_OVERRIDE=-GL_ARB_texture_rectangle -GL_EXT_texture_integer",
      "MESA_SHADER_READ_PATH=.",
      "MESA_SHADER_DUMP_PATH=.",
      "MESA_SHADER_CAPTURE_PATH=.",
      "MESA_DEBUG=flush",
      "MESA_INFO=1",
      "MESA_LOG_FILE=mesa.log",
      "MESA_SHADER_CACHE_DIR=.",
      "MESA_DISK_CACHE_SINGLE_FILE=1",
      "MESA_GLSL_CACHE_DISABLE=1",
      "MESA_VERBOSE=api,draw"}},
    {{kEglFilm},
     {"LIBGL_ALWAYS_SOFTWARE=0", "LIBGL_DRIVERS_PATH=.", "LIBGL_DEBUG=verbose", "EGL_PLATFORM=x11",
      "EGL_LOG_LEVEL=debug", "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null", "MESA_LOADER_DRIVER_OVERRIDE=zink",
      "GALLIUM_HUD=fps", "PP_DEBUG=1", "pp_nored=1", "glsl_zero_init=true", "force_gl_renderer=another",
      "force_glsl_abs_sqrt=true", "HOME=home", "DISPLAY=:9", "GALLIUM_NOOP=1"}},
    // FreeType, HarfBuzz, cairo and the libraries that cairo links
    {{kPdf, kStill},
     {"FREETYPE_PROPERTIES=cff:no-stem-darkening=0", "FREETYPE_PROPERTIES=cff:hinting-engine=freetype",
      "HB_SHAPER_LIST=fallback", "HB_OPTIONS=unicode", "CAIRO_DEBUG_PDF=1", "PIXMAN_DISABLE=sse2 ssse3 fast",
      "FONTCONFIG_FILE=/dev/null", "G_SLICE=always-malloc"}},
    // FFmpeg, the encoders, libimagequant, OpenSSL
    {{kMp4, kGif},
     {"VPX_SIMD_CAPS=0", "SVT_LOG=4", "OMP_NUM_THREADS=5", "FFREPORT=file=ff.log", "AV_LOG_FORCE_COLOR=1",
      "OPENSSL_CONF=/dev/null", "OPENSSL_ia32cap=0", "LIBGCRYPT_FORCE_FIPS_MODE=1"}},
    // the C library, the clock and the terminal
    {{kPdf, kStill, kMp4, kGolden},
     {"TZ=Asia/Kolkata", "TZ=:/dev/null", "SOURCE_DATE_EPOCH=1", "SOURCE_DATE_EPOCH=soon", "LC_ALL=de_DE.UTF-8",
      "LC_NUMERIC=de_DE.UTF-8", "LANG=tr_TR.UTF-8", "MALLOC_PERTURB_=165",
      "GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable", "TMPDIR=.", "COLUMNS=20", "TERM=dumb",
      "NO_COLOR=1"}}};

bool isNight() { return std::getenv("POINSOT_EVERY_OUTPUT") != nullptr; }

class Environment : public testing::TestWithParam<int> {
 protected:
  Environment() {
    core::clearEnvironment([](std::string_view name) {
      return name.starts_with("POINSOT_") || name.starts_with("LD_") || name.ends_with("SAN_OPTIONS");
    });
  }

  /// Runs a command and expects success. Returns all files that it makes, by name and bytes.
  static std::string madeWith(const Words& settings, int which = GetParam()) {
    const ScratchFolder folder;
    folder.put("s.toml", kScene);
    folder.put("golden.toml", "size = [64, 36]\n[[test]]\nscene = 's.toml'\n");
    fs::create_directory(folder / "home");
    folder.put("home/.drirc", kDriverSettings);
    const RunResult result = run(folder, makings()[static_cast<std::size_t>(which)], Stdout::kFile, settings);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    const fs::path wanted = folder / kMadeFiles[which];
    EXPECT_TRUE(fs::exists(wanted)) << wanted;
    std::string made;
    std::set<fs::path> files(fs::recursive_directory_iterator(folder.path()), {});
    for (const fs::path& file : files)
      if (fs::is_regular_file(file) && !file.filename().native().starts_with(".harness"))
        made += fs::relative(file, folder.path()).string() + ":\n" + bytesOf(file) + "\n";
    return made;
  }

  static Words settings() {
    Words due;
    for (const Family& family : kFamilies)
      for (std::size_t i = 0; i < family.settings.size(); ++i)
        if (isNight() || family.made[i % family.made.size()] == GetParam()) due.push_back(family.settings[i]);
    return due;
  }
};

TEST_P(Environment, ChangesNoByteOfTheOutput) {
  const std::string undisturbed = madeWith({});
  for (const std::string& setting : settings())
    EXPECT_TRUE(madeWith({setting}) == undisturbed) << setting << ": " << madeWith({setting}).substr(0, 300);
}

std::string nameOf(const testing::TestParamInfo<int>& info) {
  constexpr const char* kNames[] = {"Film", "Gif", "EglFilm", "Still", "Pdf", "Golden"};
  return kNames[info.param];
}

INSTANTIATE_TEST_SUITE_P(Each, Environment, testing::Range(0, kGolden + 1), nameOf);

TEST(EnvironmentSettings, NumberAtLeastSixty) {
  std::set<std::string> all;
  for (const Family& family : kFamilies) all.insert(family.settings.begin(), family.settings.end());
  EXPECT_GE(all.size(), 60u);
}

/// Fixture for every variable that any library in the process reads, except the documented variables.
class LibraryVariables : public Environment {
 protected:
  static std::set<std::string> asked() {
    const ScratchFolder folder;
    const std::string file = (folder / "asked").string();
    madeWith({"LD_PRELOAD=" POINSOT_VARIABLE_WATCH, "VARIABLES_ASKED=" + file});
    std::istringstream lines(bytesOf(file));
    std::set<std::string> names;
    const std::set<std::string> meant{"HOME", "TMPDIR", "CI", "XDG_CACHE_HOME", "XDG_CONFIG_HOME"};
    for (std::string name; std::getline(lines, name);)
      if (!name.starts_with("POINSOT_") && !meant.contains(name)) names.insert(name);
    return names;
  }
};

TEST_P(LibraryVariables, ChangeNoByteOfTheOutput) {
  POINSOT_NOT_SANITIZED("functions are put in the place of others");
  const std::set<std::string> names = asked();
  EXPECT_GT(names.size(), 20u) << "the watch sees them";
  const std::string undisturbed = madeWith({});
  if (!isNight()) {
    Words all;
    for (const std::string& name : names) all.push_back(name + "=1");
    EXPECT_TRUE(madeWith(all) == undisturbed) << madeWith(all).substr(0, 300);
  } else {
    for (const std::string& name : names) EXPECT_TRUE(madeWith({name + "=1"}) == undisturbed) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, LibraryVariables, testing::Range(0, kGolden + 1), nameOf);

}  // namespace
}  // namespace poinsot::faults

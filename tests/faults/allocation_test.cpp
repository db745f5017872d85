// SPDX-License-Identifier: Apache-2.0
// Lets allocations of a small render fail, once or from then on. The exit code reports the failure, no
// unfinished file is left, and no memory is lost (row M1 of the promises in SECURITY.md). Pictures are drawn
// without OpenGL, because Mesa's compiler ends the process if it gets no memory
// (RenderCommand.ReportsTheFramesOfADeadWorker).
#include <cairo.h>
#include <gmock/gmock.h>
#include <sys/mman.h>
#include <unistd.h>

#include <functional>

#include "cli/exit_code.h"
#include "core/file_handle.h"
#include "figure/figure.h"
#include "output/film.h"
#include "output/png_sequence.h"
#include "output/video_segment.h"
#include "request/scene_request.h"
#include "stage/stage.h"
#include "support/failing_memory.h"
#include "support/program_run.h"
#include "support/sanitized.h"

namespace poinsot::faults {
namespace {

namespace fs = std::filesystem;

// Scene with the objects shown by default, solids, curves, glass and labels, and with a title.
const char* const kScene = R"([body]
principal_moments = [1, 2, 3]
[motion]
omega_body = [0.1, 2, 0.1]
[time]
duration = 1
fps = 2
[show]
title = 'Élan: ẋ, $\omega$ and $\mathbf{L}$'
[output]
size = [64, 36]
)";

scene::Scene parsed() { return request::loadRequested({"tiny.toml", kScene, {}, {}, {}}); }

/// Composes the scene's pictures in full and draws only the paper.
class FlatFrames {
 public:
  explicit FlatFrames(const scene::Scene& scene)
      : stage_(scene),
        size_{scene.output.width, scene.output.height},
        fps_(static_cast<double>(scene.time.fps.num) / static_cast<double>(scene.time.fps.den)) {}

  image::Frame frame(std::int64_t k) {
    picture_ = stage_.compose(static_cast<double>(k) / fps_, {size_.width, size_.height});
    image::Image flat(size_, 3);
    flat.pixels.assign(flat.pixels.size(), static_cast<std::uint8_t>(200 + k));
    image_ = std::move(flat);
    return image_;
  }
  const draw::Picture& picture() const { return picture_; }
  const image::Image& image() const { return std::get<image::Image>(image_); }

 private:
  stage::Stage stage_;
  image::PixelSize size_;
  double fps_;
  draw::Picture picture_;
  image::AnyImage image_;
};

void writeFrames(FlatFrames& frames, output::FrameSink& sink) {
  for (std::int64_t k = 0; k < 2; ++k) sink.write(frames.frame(k), k);
  sink.finish();
}

void makeFilm(const scene::Scene& scene, FlatFrames& frames, const fs::path& folder) {
  const fs::path segment = folder / ".segment.mp4";
  {
    output::VideoSegmentWriter writer(segment, {scene.output.width, scene.output.height}, scene.time.fps, {}, 0);
    writeFrames(frames, writer);
  }
  output::joinSegments({segment}, folder / "film.mp4", {output::FilmContainer::kMp4, scene.time.fps},
                       {.title = "film", .origin = "frames of a test; "});
}

void makeSequence(const scene::Scene&, FlatFrames& frames, const fs::path& folder) {
  output::PngSequence sequence(output::FramePattern((folder / "film_{frame}.png").string()));
  writeFrames(frames, sequence);
}

void makeFigure(FlatFrames& frames, const fs::path& file) {
  frames.frame(0);
  figure::writeFigure(file, frames.picture(), frames.image(), {86, "title", "words"});
}

using Make = std::function<void(const scene::Scene&, FlatFrames&, const fs::path&)>;

struct Kind {
  const char* name;
  Make make;
  Whose whose = Whose::kAll;
};

void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.name; }

/// Redirects stderr to a buffer during its lifetime.
class Silence {
 public:
  Silence() : kept_(dup(STDERR_FILENO)), file_(memfd_create("said", 0)) { dup2(file_.get(), STDERR_FILENO); }
  ~Silence() { dup2(kept_.get(), STDERR_FILENO); }
  Silence(const Silence&) = delete;

  std::string said() const {
    std::string text(4096, 0);
    const ssize_t size = pread(file_.get(), text.data(), text.size(), 0);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return text;
  }

 private:
  core::FileHandle kept_, file_;
};

/// Returns whether a library caused the failure: toml++ 3.3 reads numbers with a stream, which swallows
/// std::bad_alloc.
bool isOfALibrary(const std::string& said) {
  return said.find("error while parsing floating-point") != std::string::npos;
}

/// One allocation of so many fails. The variable's value 1 lets every allocation fail, which takes two hours.
std::size_t strideAmong(std::size_t all) {
  if (const char* const wanted = std::getenv("POINSOT_ALLOCATION_STRIDE"))
    return std::strtoul(wanted, nullptr, 10);
  return all < 1000 ? 1 : all / 40;
}

class OutOfMemoryInOutput : public testing::TestWithParam<Kind> {
 protected:
  int render() const {
    return cli::translatingErrors([&] {
      FlatFrames frames(scene_);
      GetParam().make(scene_, frames, folder_.path());
      return 0;
    });
  }

  std::vector<std::pair<std::string, std::string>> takeFiles() const {
    std::vector<std::pair<std::string, std::string>> files;
    for (const auto& entry : fs::directory_iterator(folder_.path())) {
      const std::string name = entry.path().filename();
      if (!name.starts_with('.')) files.emplace_back(name, bytesOf(entry.path()));
      fs::remove_all(entry.path());
    }
    std::ranges::sort(files);
    return files;
  }

  struct Outcome {
    int status = 0;
    std::string said;
    std::vector<std::pair<std::string, std::string>> files;
    std::ptrdiff_t kept = 0;
  };

  Outcome failingAt(std::size_t n, bool onwards) const {
    Outcome outcome;
    const Silence silence;
    {
      const MemoryWatch watch(n, onwards, GetParam().whose);
      outcome.status = render();
      cairo_debug_reset_static_data();  // cairo keeps fonts and glyphs for the next figure
      outcome.kept = watch.kept();
    }
    outcome.said = silence.said();
    outcome.files = takeFiles();
    return outcome;
  }

  void tryAt(std::size_t n, bool onwards) {
    const Outcome outcome = failingAt(n, onwards);
    const std::string at = "at allocation " + std::to_string(n) + (onwards ? " and after" : "");
    if (outcome.status == 0)  // the render did without this allocation
      EXPECT_EQ(outcome.files, whole_) << at;
    else
      EXPECT_EQ(outcome.status, 3) << at << outcome.said;
    for (const auto& file : outcome.files) EXPECT_THAT(whole_, testing::Contains(file)) << at;
    EXPECT_LE(outcome.kept, 0) << "blocks lost " << at;
    ++(outcome.status == 0 ? spared_ : told_);
  }

  const scene::Scene scene_ = parsed();
  ScratchFolder folder_;
  std::vector<std::pair<std::string, std::string>> whole_;
  std::size_t told_ = 0, spared_ = 0;
};

TEST_P(OutOfMemoryInOutput, IsReportedWithoutLeaks) {
  POINSOT_NOT_SANITIZED("the test has a malloc() of its own");
  // Renders twice, because some objects are made only once: fonts, tables, caches of libraries.
  for (int i = 0; i < 2; ++i) {
    ASSERT_EQ(render(), 0);
    whole_ = takeFiles();
  }
  cairo_debug_reset_static_data();
  std::size_t all = 0;
  {
    const MemoryWatch watch;
    ASSERT_EQ(render(), 0);
    all = watch.allocations();
    cairo_debug_reset_static_data();
    EXPECT_EQ(watch.kept(), 0);
  }
  takeFiles();
  const std::size_t stride = strideAmong(all);
  for (std::size_t n = 1; n <= all && !HasFailure(); n += stride) {
    tryAt(n, false);
    tryAt(n, true);
  }
  EXPECT_GT(told_, spared_);
  RecordProperty("allocations", static_cast<int>(all));
  std::printf("%zu allocations; told %zu times, done without %zu times\n", all, told_, spared_);
}

// Only one allocation fails, because toml++ 3.3 ends the process if it gets no memory for an error message.
TEST(OutOfMemory, IsReportedWhileASceneIsRead) {
  for (int i = 0; i < 2; ++i) parsed();
  std::size_t all = 0;
  {
    const MemoryWatch watch;
    parsed();
    all = watch.allocations();
    EXPECT_EQ(watch.kept(), 0);
  }
  const std::size_t stride = strideAmong(all);
  for (std::size_t n = 1; n <= all && !HasFailure(); n += stride) {
    std::ptrdiff_t kept = 0;
    int status = 0;
    const Silence silence;
    {
      const MemoryWatch watch(n);
      status = cli::translatingErrors([] { return parsed().time.fps.num == 2 ? 0 : 1; });
      kept = watch.kept();
    }
    const int expected = status == 0 || isOfALibrary(silence.said()) ? status : 3;
    EXPECT_EQ(status, expected) << "at allocation " << n << silence.said();
    EXPECT_LE(kept, 0) << "blocks lost at allocation " << n;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Each, OutOfMemoryInOutput,
    testing::Values(
        // If libavformat 59 gets no memory for texts of an MP4's trailer, it omits them and reports success.
        Kind{"Film", makeFilm, Whose::kOwn}, Kind{"Sequence", makeSequence},
        // cairo 1.16 cleans up objects that it failed to make (cairo_surface_destroy).
        Kind{"Pdf", [](const auto&, auto& frames, const auto& folder) { makeFigure(frames, folder / "a.pdf"); },
             Whose::kOwn},
        Kind{"Svg", [](const auto&, auto& frames, const auto& folder) { makeFigure(frames, folder / "a.svg"); }},
        Kind{"Tex", [](const auto&, auto& frames, const auto& folder) { makeFigure(frames, folder / "a.tex"); }}),
    [](const auto& each) { return std::string(each.param.name); });

}  // namespace
}  // namespace poinsot::faults

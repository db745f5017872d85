// SPDX-License-Identifier: Apache-2.0
// Changes that a rule for golden images must accept, and defects that it must catch, all drawn by this program.
// Rules of other programs are tried, too. docs/golden.md has the resulting table (POINSOT_UPDATE_DOCS=1 rewrites
// it).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>

#include "compare/near_rule.h"
#include "golden/other_rules.h"
#include "image/png_file.h"
#include "render/renderer.h"
#include "scene/scene_file.h"
#include "stage/stage.h"
#include "support/back_ends.h"
#include "support/scratch_folder.h"
#include "support/shell_run.h"
#include "support/text_of.h"

namespace poinsot {
namespace {

using draw::DrawList;
using image::Image;

constexpr glm::ivec2 kSize{640, 480};
const std::string kRoot = POINSOT_SOURCE_DIR;

// ---- drawing

std::string sceneOf(const std::string& body) {
  return "[body]\n" + body +
         "mass = 1\n[motion]\nomega_body = [0.1, 2, 0.3]\n[time]\nduration = 20\nstill = 3\n[show]\ntitle = 'A "
         "body'\n";
}

const std::string kBox = sceneOf("shape = 'box'\nsize = [1.5, 1.0, 0.5]\n");
const std::string kSolid = sceneOf("shape = 'icosahedron'\nedge = 1\n");

scene::Scene loaded(const std::string& text) {
  const ScratchFolder folder;
  return scene::loadScene(folder.put("scene.toml", text));
}

/// Scene whose draw list can be changed before drawing.
class Studio {
 public:
  explicit Studio(const std::string& text) : stage_(loaded(text)) {}

  Image drawn(const std::function<void(DrawList&)>& change = {}, const render::RenderOptions& options = {},
              double later_s = 0) const {
    draw::Picture picture = stage_.compose(stage_.scene().time.stillTime_s() + later_s, kSize);
    if (change) change(picture.panels.at(0).list);
    return renderer().render(picture, options);
  }

 private:
  static render::Renderer& renderer() {
    static const auto context = [] {
      gl::pinEnvironment(true);
      return gl::openContext(gl::Backend::kAuto);
    }();
    static render::Renderer made(*context);
    return made;
  }

  stage::Stage stage_;
};

const Studio& box() {
  static const Studio studio(kBox);
  return studio;
}

const Studio& solid() {
  static const Studio studio(kSolid);
  return studio;
}

Image byProgram(const std::string& words) {
  const ScratchFolder folder;
  folder.put("scene.toml", kBox);
  const ShellResult run =
      runShell(folder.path(),
               fmt::format("{} still scene.toml --size 640x480 --quiet -o a.png {}", POINSOT_PROGRAM, words));
  EXPECT_EQ(run.exitCode, 0) << run.out;
  return image::readPng(folder / "a.png");
}

// ---- changes

void turnBody(DrawList& list, double angle_deg) {
  const glm::mat3 turn(
      glm::rotate(glm::mat4(1), static_cast<float>(glm::radians(angle_deg)), glm::vec3(0.3f, 0.5f, 0.8f)));
  for (draw::Box& body : list.boxes) body.halfAxes_V = turn * body.halfAxes_V;
  for (draw::Mesh& body : list.meshes) body.axes_V = turn * body.axes_V;
}

template <class F>
Image mapped(Image picture, F value) {
  for (std::uint8_t& v : picture.pixels) v = static_cast<std::uint8_t>(std::clamp(value(int{v}), 0, 255));
  return picture;
}

Image shifted(const Image& in) {
  Image out = in;
  for (int y = 0; y < in.size.height; ++y)
    for (int x = 1; x < in.size.width; ++x) std::copy_n(in.at(x - 1, y), 3, out.at(x, y));
  return out;
}

/// Converts a value from sRGB's curve to a power of 2.2.
int byPower(int v) {
  const double c = v / 255.0, light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<int>(std::lround(255 * std::pow(light, 1 / 2.2)));
}

Image withDot(Image picture) {
  std::fill_n(picture.at(400, 300), 3, std::uint8_t{255});
  std::fill_n(picture.at(400, 300), 1, static_cast<std::uint8_t>(255 - picture.at(400, 300)[0] / 2));
  return picture;
}

/// Moves a vertex of the first mesh towards the middle by `share`.
void dent(DrawList& list, float share) {
  auto mesh = std::make_shared<draw::TriangleMesh>(*list.meshes.at(0).mesh);
  mesh->vertices_M.at(0) *= 1 - share;
  list.meshes[0].mesh = mesh;
}

/// Draws the first mesh without its first visible triangle.
Image withoutFacet(const Studio& studio) {
  const Image whole = studio.drawn();
  for (std::ptrdiff_t facet = 0;; ++facet) {
    const Image picture = studio.drawn([&](DrawList& list) {
      auto mesh = std::make_shared<draw::TriangleMesh>(*list.meshes.at(0).mesh);
      mesh->triangles.erase(mesh->triangles.begin() + facet);
      list.meshes[0].mesh = mesh;
    });
    if (picture != whole) return picture;
  }
}

/// Removes the last `share` of the points of the longest curve.
void shorten(DrawList& list, double share) {
  const auto longest =
      std::ranges::max_element(list.curves, {}, [](const draw::Curve& c) { return c.points_V.size(); });
  auto& points = longest->points_V;
  points.erase(points.end() - static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(points.size()))),
               points.end());
  longest->closed = false;
}

/// Changes some pixels by one level, as rounding in another library does.
Image wobbled(Image picture) {
  for (int i = 0; i < 200; ++i) {
    std::uint8_t& v = picture.at((37 * i) % kSize.x, (53 * i) % kSize.y)[i % 3];
    v = static_cast<std::uint8_t>(v == 255 ? 254 : v + 1);
  }
  return picture;
}

/// Simulates the picture of another driver: a quarter of the pixels differ by one level, and thirty pixels at
/// edges by sixty levels.
Image byAnotherDriver(Image picture) {
  std::vector<std::uint8_t*> edges;
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 1; x < kSize.x; ++x) {
      std::uint8_t* const p = picture.at(x, y);
      if (std::abs(p[0] - picture.at(x - 1, y)[0]) > 60) edges.push_back(p);
      if ((7 * x + 13 * y) % 4 == 0) p[x % 3] = static_cast<std::uint8_t>(p[x % 3] == 255 ? 254 : p[x % 3] + 1);
    }
  constexpr std::size_t kEdges = 30;
  for (std::size_t i = 0; i < kEdges; ++i) {
    std::uint8_t* const p = edges.at(i * edges.size() / kEdges);
    for (int c = 0; c < 3; ++c) p[c] = static_cast<std::uint8_t>(p[c] > 127 ? p[c] - 60 : p[c] + 60);
  }
  return picture;
}

struct Change {
  const char* name;
  bool isDefect;
  Image reference, test;
  bool isOfThisCpu = false;  ///< figures depend on the CPU
};

std::vector<Change> changes() {
  const Image a = box().drawn(), t = solid().drawn();
  const auto turned = [](double angle_deg) { return [=](DrawList& list) { turnBody(list, angle_deg); }; };
  return {
      {"EGL in place of OSMesa", false, byProgram("--reproducible --backend " + backEndNames().front()),
       byProgram("--reproducible --backend egl")},
      {"this processor's own instructions", false, byProgram("--reproducible"), byProgram(""), true},
      {"200 values by one level", false, a, wobbled(a)},
      {"a facet missing", true, t, withoutFacet(solid())},
      {"a vertex of the mesh 1 % inwards", true, t, solid().drawn([](DrawList& list) { dent(list, 0.01f); })},
      {"body turned by 0.01 degrees", true, a, box().drawn(turned(0.01))},
      {"body turned by 0.1 degrees", true, a, box().drawn(turned(0.1))},
      {"body turned by 1 degree", true, a, box().drawn(turned(1))},
      {"one frame later (1/30 s)", true, a, box().drawn({}, {}, 1.0 / 30)},
      {"edges not smooth", true, a, box().drawn({}, {.sharpness = 1000})},
      {"the end of a curve lost (2.5 %)", true, a, box().drawn([](DrawList& list) { shorten(list, 0.025); })},
      {"an arrow lost", true, a, box().drawn([](DrawList& list) { list.frustums.pop_back(); })},
      {"a label lost", true, a, box().drawn([](DrawList& list) { list.texts.pop_back(); })},
      {"a grid line's width by 2 %", true, a,
       box().drawn([](DrawList& list) { list.planes.at(0).lineWidth_px *= 1.02f; })},
      {"all channels one level brighter", true, a, mapped(a, [](int v) { return v + 1; })},
      {"all channels two levels darker", true, a, mapped(a, [](int v) { return v - 2; })},
      {"one wrong pixel", true, a, withDot(a)},
      {"shifted by one pixel", true, a, shifted(a)},
      {"a power of 2.2 for the sRGB curve", true, a, mapped(a, byPower)},
  };
}

// ---- the table

std::string headText() {
  std::string first = "| change | pixels | largest | FLIP mean | FLIP max |",
              second = "| --- | --- | --- | --- | --- |";
  for (const ComparisonRule& rule : comparisonRules()) {
    first += fmt::format(" {} |", rule.name);
    second += " --- |";
  }
  return first + "\n" + second + "\n";
}

/// Returns a table row with the verdict of each rule.
std::string rowText(const Change& change, const std::vector<bool>& fails) {
  const auto d = compare::compare(change.reference, change.test).difference;
  std::string row = fmt::format("| {}{} |", change.isDefect ? "" : "*legal:* ", change.name);
  if (change.isOfThisCpu)
    row += " a few | 1 | | |";
  else
    row += fmt::format(" {} | {:.0f} | {:.1e} | {:.3f} |", d.differingPixels, d.maxAbs, d.flip.mean, d.flip.max);
  for (const bool failed : fails)
    row += failed ? (change.isDefect ? " caught |" : " **false alarm** |") : change.isDefect ? " |" : " passed |";
  return row + "\n";
}

/// Compares a table with the one in docs/golden.md, which stands between two comments.
void expectInDocs(const std::string& name, const std::string& table) {
  const std::string file = kRoot + "/docs/golden.md";
  std::string text = textOf(file);
  const std::string begin = "<!-- " + name + " -->\n", end = "<!-- end -->";
  const auto first = text.find(begin), last = text.find(end, first);
  ASSERT_TRUE(first != std::string::npos && last != std::string::npos);
  const auto from = first + begin.size();
  if (const char* wish = std::getenv("POINSOT_UPDATE_DOCS"); wish && *wish == '1') {
    std::ofstream(file) << text.replace(from, last - from, table);
    return;
  }
  EXPECT_EQ(text.substr(from, last - from), table) << "POINSOT_UPDATE_DOCS=1 writes it anew";
}

TEST(Defects, AreAllCaughtWithoutFalseAlarms) {
  std::string rows, counts = "| **defects caught, false alarms** | | | | |";
  std::vector<int> caught(comparisonRules().size()), alarms(caught.size());
  int defects = 0;
  for (const Change& change : changes()) {
    std::vector<bool> fails;
    for (std::size_t i = 0; i < caught.size(); ++i) {
      fails.push_back(comparisonRules()[i].fails(change.reference, change.test));
      if (fails.back()) ++(change.isDefect ? caught : alarms)[i];
    }
    defects += change.isDefect ? 1 : 0;
    EXPECT_EQ(fails.back(), change.isDefect) << change.name << ": " << rowText(change, fails);
    rows += rowText(change, fails);
  }
  for (std::size_t i = 0; i < caught.size(); ++i)
    counts += fmt::format(" {} of {}, {} |", caught[i], defects, alarms[i]);
  expectInDocs("defects_test", headText() + rows + counts + "\n");
}

bool refuses(const compare::NearRule& rule, const Change& change) {
  return compare::verdict(compare::compare(change.reference, change.test).difference, rule) ==
         compare::Verdict::kDifferent;
}

compare::NearRule rule(std::string_view name) {
  return std::ranges::find(compare::namedRules(), name, &compare::NamedRule::name)->rule;
}

/// Verdicts of the named rules on the same changes, and on another driver. The test above holds "near" to its
/// verdicts. For "other_driver", the defects that it misses must be documented.
TEST(Defects, AreCaughtByNamedRulesAsDocumented) {
  std::vector<Change> all = changes();
  std::erase_if(all, [](const Change& change) { return change.isOfThisCpu; });
  const Image a = box().drawn();
  all.insert(all.begin() + 2, {"another driver, simulated", false, a, byAnotherDriver(a)});
  std::string first = "| change |", second = "| --- |", counts = "| **defects caught** |", rows;
  std::vector<int> caught(compare::namedRules().size());
  for (const compare::NamedRule& named : compare::namedRules()) {
    first += fmt::format(" {} |", named.name);
    second += " --- |";
  }
  for (const Change& change : all) {
    rows += fmt::format("| {}{} |", change.isDefect ? "" : "*legal:* ", change.name);
    for (std::size_t i = 0; i < caught.size(); ++i) {
      const bool refused = refuses(compare::namedRules()[i].rule, change);
      if (refused && change.isDefect) ++caught[i];
      rows += change.isDefect ? (refused ? " caught |" : " |") : refused ? " refused |" : " passed |";
    }
    rows += "\n";
    const std::string name = change.name;
    const bool mustBeCaught = name == "a label lost" || name == "an arrow lost" || name == "a facet missing";
    const bool passesOtherDriver = !refuses(rule("other_driver"), change);
    EXPECT_TRUE(change.isDefect || passesOtherDriver) << name;
    EXPECT_FALSE(mustBeCaught && passesOtherDriver) << name;
    EXPECT_EQ(refuses(rule("near"), change), refuses({}, change)) << name;
  }
  const auto defects = std::ranges::count_if(all, [](const Change& change) { return change.isDefect; });
  for (const int count : caught) counts += fmt::format(" {} of {} |", count, defects);
  expectInDocs("defects_test rules", first + "\n" + second + "\n" + rows + counts + "\n");
}

}  // namespace
}  // namespace poinsot

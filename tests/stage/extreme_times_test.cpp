// SPDX-License-Identifier: Apache-2.0
// Pictures of every kind of motion at extreme film times consist of finite numbers, or fail with the documented
// error. Each kind is drawn in a process of its own, so that one that aborts does not hide the others.
#include "support/extreme_times.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <string>

#include "core/error.h"
#include "scene/motion/make_motion.h"
#include "scene_samples.h"

namespace poinsot::stage {
namespace {

constexpr glm::ivec2 kSize{64, 36};

/// Checks all numbers that place something. A class, so that each overload sees the others.
struct Numbers {
  static bool finite(float x) { return std::isfinite(x); }
  static bool finite(const glm::vec2& v) { return finite(v.x) && finite(v.y); }
  static bool finite(const glm::vec3& v) { return finite(v.x) && finite(v.y) && finite(v.z); }
  static bool finite(const glm::mat3& m) { return finite(m[0]) && finite(m[1]) && finite(m[2]); }
  template <typename T>
  static bool finite(const std::vector<T>& all) {
    for (const T& one : all)
      if (!finite(one)) return false;
    return true;
  }
  static bool finite(const draw::Camera& c) {
    return finite(c.eye_V) && finite(c.R_VC) && finite(c.tanHalfFovY) && finite(c.halfHeight_V) &&
           finite(c.near) && finite(c.far) && finite(c.centre_px);
  }
  static bool finite(const draw::Ellipsoid& e) { return finite(e.centre_V) && finite(e.semiAxes_V); }
  static bool finite(const draw::Frustum& f) { return finite(f.from_V) && finite(f.to_V); }
  static bool finite(const draw::Box& b) { return finite(b.centre_V) && finite(b.halfAxes_V); }
  static bool finite(const draw::Mesh& m) {
    return finite(m.origin_V) && finite(m.axes_V) && finite(m.mesh->vertices_M);
  }
  static bool finite(const draw::Curve& c) { return finite(c.points_V); }
  static bool finite(const draw::GlassEllipsoid& e) { return finite(e.centre_V) && finite(e.semiAxes_V); }
  static bool finite(const draw::GlassCone& c) { return finite(c.apex_V) && finite(c.axis_V); }
  static bool finite(const draw::GlassPolygon& p) { return finite(p.corners_V); }
  static bool finite(const draw::GridPlane& p) { return finite(p.centre_V) && finite(p.u_V) && finite(p.v_V); }
  static bool finite(const draw::Text& t) {
    return finite(t.baseline_px) && t.tex.find("nan") == std::string::npos;
  }
  static bool finite(const draw::Stroke& s) { return finite(s.points_px) && finite(s.opacity); }
  static bool finite(const draw::Area& a) { return finite(a.points_px) && finite(a.opacity); }
  static bool finite(const draw::Panel& panel) {
    const draw::DrawList& l = panel.list;
    return finite(l.camera) && finite(l.ellipsoids) && finite(l.frustums) && finite(l.boxes) && finite(l.meshes) &&
           finite(l.curves) && finite(l.glassEllipsoids) && finite(l.glassCones) && finite(l.glassPolygons) &&
           finite(l.planes) && finite(l.texts);
  }
  static bool finite(const draw::Picture& p) {
    return finite(p.panels) && finite(p.areas) && finite(p.strokes) && finite(p.texts);
  }
};

/// Motion, or another thing that depends on the film's time.
struct Kind {
  const char* name;
  std::string scene;
  bool everywhere = false;  ///< whether far motion times have pictures, too
};

std::ostream& operator<<(std::ostream& out, const Kind& kind) { return out << kind.name; }

std::string body(const std::string& moments, const std::string& omega, const std::string& more = "") {
  return "[body]\nprincipal_moments = " + moments + "\n[motion]\nomega_body = " + omega + "\n" + more;
}

const std::string kTop = "[1.40625, 1.40625, 0.65625]", kSpin = "[0, 0, 9.15625]",
                  kTilted = "orientation = [0.9659258262890683, 0.25881904510252074, 0, 0]\n";

const Kind kKinds[] = {
    {"sphere", body("[2, 2, 2]", "[1, 2, 3]"), true},
    {"symmetric", body("[1, 1, 2]", "[0.1, 0.2, 3]", "[show]\ncones = true\n"), true},
    {"asymmetric", body("[1, 2, 2.5]", "[0.05, 2, 0.1]", "[show]\ntrace = true\nghosts = true\n"), true},
    {"steady", body("[1, 2, 3]", "[0, 0, 2]"), true},
    {"separatrix", body("[1, 2, 3]", "[1.7320508075688772, 1, 1]"), true},
    {"fast", body("[1, 2, 3]", "[1e5, 1, 0]"), true},
    {"dissipation", body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.dissipation]\nalpha = 0.01\n")},
    {"torque of the body", body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.torque]\nbody = [0, 0.1, 0.2]\n")},
    {"torque in space", body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.torque]\nspace = [0, 0.1, 0.2]\n")},
    {"drag", body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.drag]\nrate = [0.1, 0.2, 0.3]\n")},
    {"even drag", body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.drag]\nrate = 0.2\n")},
    {"heavy top", body(kTop, kSpin, kTilted + "[motion.gravity]\nmgr_body = [0, 0, 2.84375]\n")},
    {"flight", "[body]\nmass = 1\n" +
                   body("[1, 2, 3]", "[0.1, 0.2, 3]", "[motion.flight]\nvelocity = [0, 1, 2]\n").substr(7)},
    {"plot and read-out",
     body("[1, 2, 3]", "[1, 2, 3]", "[[plot]]\nquantities = [\"omega_1\"]\n[[readout]]\nquantity = \"theta\"\n"),
     true},
    {"timeline",
     body("[1, 2, 3]", "[1, 2, 3]",
          "[[timeline]]\nat = 1\nspeed = 4\n[[timeline]]\nat = 3\nhold = 1\nspeed = 2\ncamera.zoom = 2\n"),
     true},
    {"backwards", body("[1, 2, 3]", "[1, 2, 3]", "[time]\nspeed = -3\nstart = 5\n")},
};

/// Prints what is wrong, and ends the process with 1.
[[noreturn]] void fail(const std::string& where, const char* wrong) {
  std::fprintf(stderr, "%s: %s\n", where.c_str(), wrong);
  std::_Exit(1);
}

void drawAtAllTimes(const std::string& text) {
  const scene::Scene scene = scene::parseScene(text, "sample.toml");
  const Stage stage(scene);
  for (const bool still : {false, true})
    for (const double t_s : extremeTimes()) {
      const char* wrong = nullptr;
      try {
        if (!Numbers::finite(stage.compose({t_s, still}, kSize))) wrong = "a number that is not finite";
        if (!(t_s >= 0)) wrong = "no error for a time that is no film's";
      } catch (const core::Error& error) {
        if (error.kind() != core::ErrorKind::kLimit || std::abs(t_s) <= scene.time.duration_s)
          wrong = error.what();
      } catch (const std::logic_error& error) {
        if (std::string(error.what()).find("filmTime_s") == std::string::npos || (t_s >= 0 && std::isfinite(t_s)))
          wrong = error.what();
      }
      if (wrong) fail("at " + std::to_string(t_s), wrong);
    }
}

/// Draws both ends of films that start or end at far motion times.
void drawFarMotions(const Kind& kind) {
  std::vector<const char*> far = {"1e20"};
  if (kind.everywhere) far.insert(far.end(), {"1e6", "-1e14", "9007199254740992.0", "1e18"});
  for (const char* key : {"start", "speed"})
    for (const char* value : far) {
      const std::string time = std::string("[time]\n") + key + " = " + value + "\n";
      try {
        const scene::Scene scene = scene::parseScene(kind.scene + time, "sample.toml");
        const Stage stage(scene);
        for (const double t_s : {0.0, scene.time.duration_s})
          if (!Numbers::finite(stage.compose({t_s, true}, kSize))) fail(time, "a number that is not finite");
      } catch (const core::Error& error) {
        if (kind.everywhere || error.kind() != core::ErrorKind::kLimit) fail(time, error.what());
      }
    }
}

class ExtremeTimes : public ::testing::TestWithParam<Kind> {};

TEST_P(ExtremeTimes, GivePicturesOrTheDocumentedError) {
  EXPECT_EXIT(
      {
        drawAtAllTimes(GetParam().scene);
        std::_Exit(0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST_P(ExtremeTimes, OfTheMotionGivePicturesOrTheDocumentedError) {
  if (GetParam().scene.find("[time]") != std::string::npos) GTEST_SKIP() << "has times of its own";
  EXPECT_EXIT(
      {
        drawFarMotions(GetParam());
        std::_Exit(0);
      },
      ::testing::ExitedWithCode(0), "");
}

INSTANTIATE_TEST_SUITE_P(Each, ExtremeTimes, ::testing::ValuesIn(kKinds), [](const auto& kind) {
  std::string name = kind.param.name;
  std::erase_if(name, [](char c) { return c == ' ' || c == '-'; });
  return name;
});

}  // namespace
}  // namespace poinsot::stage

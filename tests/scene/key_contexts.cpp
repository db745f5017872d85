// SPDX-License-Identifier: Apache-2.0
#include "key_contexts.h"

#include <algorithm>
#include <map>

#include "scene/shapes.h"

namespace poinsot::scene {
namespace {

const std::string kMoments = "body.principal_moments = [1.0, 2.0, 2.5]\n";
const std::string kOmega = "motion.omega_body = [0.01, 3.0, 0.0]\n";
const std::string kBox = "body.shape = \"box\"\nbody.size = [3, 2, 1]\n";

bool holds(const KeyNames& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Returns lines such as "size = [...]": the examples of the keys that describe a shape in one way.
std::string examples(const std::string& table, const NamedShape& shape, const KeyNames& way) {
  std::string text;
  for (const std::string_view name : way) {
    const std::string path = table + "." + std::string(name);
    const bool flat = name == "size" && shape.extents == 2;
    text += std::string(name) + " = " + (flat ? "[0.3, 0.2]" : std::string(findKey(path)->example)) + "\n";
  }
  return text;
}

/// Returns the first shape with this key, except the rod, which has no moment about its line.
std::string shapeWith(const std::string& table, std::string_view name) {
  for (const NamedShape& shape : namedShapes())
    for (const KeyNames& way : shape.ways)
      if (shape.word != "rod" && (holds(way, name) || holds(shape.optional, name)))
        return "shape = \"" + std::string(shape.word) + "\"\n" + examples(table, shape, way);
  return "shape = \"box\"\nsize = [3, 2, 1]\n";
}

const std::string kCone =
    "body.shape = \"cone\"\nbody.radius = 0.75\nbody.height = 1\nbody.mass = 2\nbody.pivot = [0, 0, 0.75]\n";
const std::string kRolling = "motion.rolling.rate = 1\n";

bool ofAThrownBody(const Key& key) {
  constexpr std::string_view kNames[] = {"show.flight", "show.total_L", "camera.follow"};
  return std::ranges::any_of(kNames, [&](auto name) { return key.path.find(name) != std::string::npos; });
}

bool ofASymmetricTop(const Key& key) {
  constexpr std::string_view kNames[] = {"show.cones", "show.decomposition", "show.triad", "show.L_parts"};
  return std::ranges::any_of(kNames, [&](auto name) { return key.path.find(name) != std::string::npos; });
}

/// Returns the text that each key needs, if the usual body and start do not suffice.
const std::map<std::string_view, std::string>& contexts() {
  static const std::string part = "[[body.part]]\nshape = \"box\"\nsize = [3, 2, 1]\n";
  static const std::string points =
      "[[body.point_mass]]\nmass = 1\nposition = [1, 2, 3]\n[[body.point_mass]]\nmass = 2\nposition = [1, -2, 1]\n"
      "[[body.point_mass]]\nmass = 3\nposition = [-1, 0, 5]\n";
  static const std::string top =
      "body.principal_moments = [2, 2, 1]\nmotion.gravity.mgr_body = [0, 0, 3]\nmotion.lean = 1\n";
  static const std::map<std::string_view, std::string> all = {
      {"body.principal_moments", kOmega},
      {"body.inertia", kOmega},
      {"body.catalogue", kOmega},
      {"body.mass", kOmega + kBox},
      {"body.density", kOmega + kBox},
      {"body.pivot", kOmega + kBox + "body.mass = 1\n"},
      {"body.centre_of_mass", kOmega + kMoments + "body.mass = 1\n"},
      {"body.moments_about", kOmega + kMoments + "body.mass = 1\nbody.pivot = [0, 0, 0]\n"},
      {"body.part[].mass", kOmega + part},
      {"body.part[].density", kOmega + part},
      {"body.part[].offset", kOmega + part + "mass = 1\n"},
      {"body.part[].rotation", kOmega + part + "mass = 1\n"},
      {"body.part[].axis", kOmega + part + "mass = 1\nangle = 1\n"},
      {"body.part[].angle", kOmega + part + "mass = 1\naxis = [0, 1, 0]\n"},
      {"body.point_mass[].mass", kOmega + points},
      {"body.point_mass[].position", kOmega + points},
      {"body.own_axes.x", kMoments + kOmega + "body.own_axes.y = [0, 1, 0]\n"},
      {"body.own_axes.y", kMoments + kOmega + "body.own_axes.x = [1, 0, 0]\n"},
      {"motion.flight.point", kOmega + kBox + "body.mass = 1\nmotion.flight.velocity = [1, 0, 2]\n"},
      {"motion.omega_space", kMoments},
      {"motion.L_body", kMoments},
      {"motion.L_space", kMoments},
      {"motion.spin", kMoments + "motion.spin_axis = \"1\"\n"},
      {"motion.spin_axis", kMoments + "motion.spin = 1\n"},
      {"motion.tilt", kMoments + "motion.spin = 1\nmotion.spin_axis = \"1\"\n"},
      {"motion.tilt_towards", kMoments + "motion.spin = 1\nmotion.spin_axis = \"1\"\nmotion.tilt = 0.1\n"},
      {"motion.precession", top + "motion.spin = 50\nmotion.spin_axis = \"3\"\n"},
      {"motion.nutation", top + "motion.spin = 50\nmotion.spin_axis = \"3\"\n"},
      {"motion.P_phi", "body.principal_moments = [1, 1.5, 2]\nmotion.P_psi = \"60 h\"\nmotion.mode = \"SAM\"\n"},
      {"motion.P_psi", "body.principal_moments = [1, 1.5, 2]\nmotion.P_phi = \"60 h\"\nmotion.mode = \"SAM\"\n"},
      {"motion.mode", "body.principal_moments = [1, 1.5, 2]\nmotion.P_phi = 10\nmotion.P_psi = 30\n"},
      {"motion.lean", kMoments + kOmega + "motion.spin_axis = \"3\"\n"},
      {"motion.euler_rates.precession", kMoments + "motion.euler_rates.spin = 1\n"},
      {"motion.euler_rates.nutation", kMoments + "motion.euler_rates.spin = 1\n"},
      {"motion.euler_rates.spin", kMoments + "motion.euler_rates.precession = 1\n"},
      {"motion.energy", kMoments + "motion.L = 4.2\n"},
      {"motion.L", kMoments + "motion.energy = 4.5\n"},
      {"motion.phase", kMoments + "motion.energy = 4.5\nmotion.L = 4.2\n"},
      {"motion.branch", kMoments + "motion.energy = 4.5\nmotion.L = 4.2\n"},
      {"motion.rolling.rate", kCone},
      {"motion.rolling.g", kCone + kRolling},
      {"motion.gravity.g", kOmega + kBox + "body.mass = 1\nbody.pivot = [0, 0, -1]\n"},
      {"motion.torque.file_axes", kMoments + kOmega + "motion.torque.file = \"torque.csv\"\n"},
      {"motion.torque.interpolation", kMoments + kOmega + "motion.torque.file = \"torque.csv\"\n"},
      {"motion.torque.step[].from", kMoments + kOmega + "[[motion.torque.step]]\nbody = [1, 2, 3]\n"},
      {"motion.torque.step[].body", kMoments + kOmega + "[[motion.torque.step]]\nfrom = 1\n"},
      {"vector[].frame", kOmega + "body.principal_moments = [1, 1, 2]\n[[vector]]\ncomponents = [0, 0, 1]\n"},
      {"motion.torque.step[].space", kMoments + kOmega + "[[motion.torque.step]]\nfrom = 1\n"},
  };
  return all;
}

}  // namespace

std::string pathIn(const Key& key) {
  std::string path = key.path;
  if (const std::size_t element = path.find("[]"); element != std::string::npos) path.insert(element + 1, "0");
  return path;
}

std::string sceneFor(const Key& key) {
  if (ofAThrownBody(key))
    return kOmega + kBox + "body.mass = 1\nmotion.flight.velocity = [1, 0, 2]\n" +
           (key.path.starts_with("view") ? "[[view]]\n" : "");
  if (key.path.starts_with("motion.force[]")) {
    const std::string_view part = nameOf(key.path);
    return kMoments + kOmega + "[[motion.force]]\n" + (part == "at" ? "" : "at = [1, 0, 0]\n") +
           (part == "space" || part == "body" ? "" : "body = [0, 1, 0]\n");
  }
  if (key.path.find("show.forces") != std::string::npos)
    return kMoments + kOmega + "[[motion.force]]\nat = [1, 0, 0]\nbody = [0, 1, 0]\n" +
           (key.path.starts_with("view") ? "[[view]]\n" : "");
  if (key.path.find("show.table") != std::string::npos)
    return kCone + kRolling + (key.path.starts_with("view") ? "[[view]]\n" : "");
  if (key.path == "timeline[].around")
    return kOmega + "body.principal_moments = [1, 2, 3]\n[[timeline]]\nspeed = 0.5\n";
  if (ofASymmetricTop(key))
    return kOmega + "body.principal_moments = [1, 1, 2]\n" + (key.path.starts_with("view") ? "[[view]]\n" : "");
  if (const auto found = contexts().find(key.path); found != contexts().end()) return found->second;
  const std::string_view name = nameOf(key.path);
  const bool ofShape = name == "shape" || holds(shapeKeyNames(), name);
  if (ofShape && tableOf(key.path) == "body") return kOmega + "[body]\nmass = 1\n" + shapeWith("body", name);
  if (ofShape && tableOf(key.path) == "body.part[]")
    return kOmega + "[[body.part]]\nmass = 1\n" + shapeWith("body.part[]", name);
  if (ofShape && tableOf(key.path) == "mark[]")
    return kMoments + kOmega + "[[mark]]\n" + shapeWith("mark[]", name);
  if (key.path.starts_with("mark[]"))
    return kMoments + kOmega + "[[mark]]\nshape = \"cube\"\nedge = 1\n" + (name == "axis" ? "angle = 1\n" : "") +
           (name == "angle" ? "axis = [0, 1, 0]\n" : "");
  if (ofShape && tableOf(key.path) == "show.body")
    return kMoments + kOmega + "[show.body]\n" + shapeWith("show.body", name);
  if (key.path == "plot[].quantities") return kMoments + kOmega + "[[plot]]\n";
  if (key.path.starts_with("plot[]")) return kMoments + kOmega + "[[plot]]\nquantities = [\"omega_1\"]\n";
  if (key.path == "readout[].quantity") return kMoments + kOmega + "[[readout]]\n";
  if (key.path.starts_with("readout[]")) return kMoments + kOmega + "[[readout]]\nquantity = \"t\"\n";
  if (key.path == "note[].text") return kMoments + kOmega + "[[note]]\n";
  if (key.path.starts_with("note[]")) return kMoments + kOmega + "[[note]]\ntext = \"a\"\n";
  // Other descriptions of a vector exclude components, and only components have a frame.
  if (key.path == "vector[].components" || key.path == "vector[].position_of" ||
      key.path == "vector[].velocity_of")
    return kMoments + kOmega + "[[vector]]\n";
  if (key.path.starts_with("vector[]")) return kMoments + kOmega + "[[vector]]\ncomponents = [0, 0, 1]\n";
  if (key.path == "angle[].between") return kMoments + kOmega + "[[angle]]\n";
  if (key.path.starts_with("angle[]")) return kMoments + kOmega + "[[angle]]\nbetween = [\"L\", \"omega\"]\n";
  if (key.path == "show.views") return kMoments + kOmega + "[[plot]]\nquantities = [\"omega_1\"]\n";
  if (key.path.starts_with("timeline[]"))
    return kMoments + kOmega + "[[timeline]]\n" +
           (name == "at" || name == "at_motion" || name == "around" ? "" : "at = 1\n") +
           (name == "speed_for" ? "speed = 0.5\n" : "") + (name == "caption_for" ? "caption = \"A\"\n" : "");
  if (key.path.starts_with("view[]")) return kMoments + kOmega + "[[view]]\n";
  return kMoments + (key.path == "motion.omega_body" ? "" : kOmega);
}

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
// Scenes of users who do not know the program. A test does once what the messages say, and loads the result.
#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <vector>

#include "pasting.h"
#include "scene_testing.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;
using testing::Not;

struct WrongScene {
  std::string text;
  std::vector<std::string> leads;  ///< lines of the scene after the messages were followed
};

const std::string kFreeBody = "[body]\nprincipal_moments = [1.0, 2.0, 2.5]\n";
const std::string kWholeBox = "[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.1]\nmass = 2\n";
const std::string kSpun = "[motion]\nomega_body = [0.01, 3.0, 0.0]\n";

void expectMended(const std::vector<WrongScene>& scenes) {
  for (const WrongScene& wrong : scenes) {
    const std::string scene = mended(wrong.text, problemsOf(wrong.text));
    EXPECT_EQ(messagesOf(scene), "") << wrong.text << "\n" << messagesOf(wrong.text) << "\n" << scene;
    for (const std::string& lead : wrong.leads) EXPECT_THAT(scene, HasSubstr(lead)) << messagesOf(wrong.text);
  }
}

TEST(MendedScenes, HaveTheirShape) {
  expectMended({
      {"[body]\nshape = \"wheel\"\nradius = 0.3\nmass = 2\n" + kSpun, {"shape = \"disc\""}},
      {"[body]\nshape = \"coin\"\nradius = 0.012\nthickness = 0.002\nmass = 0.008\n" + kSpun,
       {"shape = \"cylinder\"", "height = 0.002"}},
      {"[body]\nshape = \"disc\"\nradius = 0.1\nthickness = \"1 cm\"\nmass = 1\n" + kSpun,
       {"shape = \"cylinder\"", "height = \"1 cm\""}},
      {"[body]\nshape = \"spinning top\"\nradius = 0.03\nheight = 0.06\nmass = 0.1\n" + kSpun,
       {"shape = \"cone\""}},
      {"[body]\nshape = \"mallet\"\nmass = 0.8\n" + kSpun, {"shape = \"t_handle\"", "bar_length"}},
      {"[body]\nshape = \"barbell\"\nmass = 3\n" + kSpun, {"[[body.part]]", "mass = 1.5"}},
      {"[body]\nshape = \"flibbet\"\nmass = 3\n" + kSpun, {"shape = \"box\"", "size = "}},
      {"[body]\nshape = \"box\"\nlength = 0.3\nwidth = 0.2\nheight = 0.1\nmass = 1\n" + kSpun,
       {"size = [0.3, 0.2, 0.1]"}},
      {"[body]\nshape = \"slab\"\nlength = 0.3\nwidth = 0.2\nthickness = 0.1\nmass = 1\n" + kSpun,
       {"shape = \"box\"", "size = [0.3, 0.2, 0.1]"}},
      {"[body]\nshape = \"cylinder\"\ndiameter = 0.2\nlength = 1.5\nmass = 1\n" + kSpun,
       {"radius = 0.1", "height = 1.5"}},
      {"[body]\nshape = \"oblate spheroid\"\na = 2\nc = 1\nmass = 1\n" + kSpun,
       {"shape = \"ellipsoid\"", "size = [4, 4, 2]"}},
      {"[body]\nshape = \"ellipsoid\"\na = 3\nb = 2\nc = 1\nmass = 1\n" + kSpun, {"size = [6, 4, 2]"}},
      {"[body]\nshape = \"racket\"\nmass = 0.3\n" + kSpun, {"size = [0.68, 0.26, 0.02]"}},
      {"[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.1]\ndensity = \"steel\"\n" + kSpun, {"density = 7850"}},
      {"[body]\nshape = \"box\"\nsize = [0.3, 0.2, 0.1]\n" + kSpun, {"mass = 1"}},
      {"[body]\nname = \"4179 Toutatis\"\n" + kSpun, {"catalogue = \"toutatis\""}},
      {"[body]\ncatalog = \"tennis racket\"\n" + kSpun, {"catalogue = \"racket\""}},
      {"[body]\nshape = \"gyroscope\"\nprincipal_moments = [1, 1, 2]\n" + kSpun, {"[1, 1, 2]\n"}},
  });
}

TEST(MendedScenes, HaveTheirMoments) {
  expectMended({
      {"[body]\ninertia = { ixx = 18, ixy = 0.4, ixz = -0.1, iyy = 25, iyz = 0.2, izz = 31 }\n" + kSpun,
       {"inertia = [[18, 0.4, -0.1], [0.4, 25, 0.2], [-0.1, 0.2, 31]]"}},
      {"[body]\ninertia = { xx = 1, yy = 2, zz = 2.5 }\n" + kSpun, {"[[1, 0, 0], [0, 2, 0], [0, 0, 2.5]]"}},
      {"[body]\nI_perp = 2\nI_axis = 1\n" + kSpun, {"principal_moments = [2, 2, 1]"}},
      {"[body]\nI1 = 2\nI3 = 1\n" + kSpun, {"principal_moments = [2, 2, 1]"}},
      {"[body]\nmoment_ratios = [0.6, 0.96, 1]\n" + kSpun, {"principal_moments = [0.6, 0.96, 1]"}},
      {"[body]\nI = \"[5 0.3 0; 0.3 6 0; 0 0 7]\"\n" + kSpun, {"inertia = [[5, 0.3, 0], [0.3, 6, 0], [0, 0, 7]]"}},
      {"[body]\nprincipal_moments = \"1 2 2.5\"\n" + kSpun, {"principal_moments = [1, 2, 2.5]"}},
      {"[body]\nshape = \"dumbbell\"\nmasses = [1, 2]\npositions = [[-0.2, 0, 0], [0.2, 0, 0]]\n" + kSpun,
       {"[[body.part]]", "mass = 2", "offset = [0.2, 0, 0]"}},
      {"[body]\nmasses = [1, 2, 1]\npositions = [[-0.2, 0, 0], [0.2, 0, 0.1], [0, 0.3, 0]]\n" + kSpun,
       {"[[body.point_mass]]", "position = [0.2, 0, 0.1]"}},
  });
}

TEST(MendedScenes, HaveTheirStart) {
  expectMended({
      {kFreeBody + "[motion]\nangular_velocity = { x = 0.1, y = 3, z = 0 }\n", {"omega_body = [0.1, 3, 0]"}},
      {kFreeBody + "[motion]\np = 0.1\nq = 0.2\nr = 3\n", {"omega_body = [0.1, 0.2, 3]"}},
      {kFreeBody + "[motion]\nomega_body = \"0 0.1 3\"\n", {"omega_body = [0, 0.1, 3]"}},
      {kFreeBody + "[motion]\nomega_body = (0.1, 0.05, 9)\n", {"omega_body = [0.1, 0.05, 9]"}},
      {kFreeBody + "[motion]\nomega_body = 0.1, 0.05, 9  # rad/s\n", {"omega_body = [0.1, 0.05, 9]"}},
      {kFreeBody + "[motion]\nomega_body = \"0 0.1 3 rpm\"\n",
       {"omega_body = [\"0 rpm\", \"0.1 rpm\", \"3 rpm\"]"}},
      {kFreeBody + "[motion]\nomega_body = [0, 0.1, 2*pi]\n", {"omega_body = [0, 0.1, 6.283185]"}},
      {kFreeBody + "[motion]\nomega_body = [0, 0, \"3 rotations per second\"]\n",
       {"omega_body = [0, 0, \"3 rev/s\"]"}},
      {kFreeBody + "[motion.initial]\nomega = [0, 0.1, 3]\n", {"omega_body = [0, 0.1, 3]"}},
      {kFreeBody + "[motion]\nangular velocity = [0, 0.1, 3]\n", {"omega_body = [0, 0.1, 3]"}},
      {kFreeBody + "[motion]\nomega_magnitude = 3\nomega_direction = [0, 3, 4]\n", {"omega_body = [0, 1.8, 2.4]"}},
      {kFreeBody + "[motion]\nspin_rate = \"6 Hz\"\naxis = \"z\"\n", {"spin = \"6 Hz\"", "spin_axis = \"3\""}},
      {kFreeBody + "[motion]\nrotation_period_h = 12.5\n", {"spin = \"0.08 rev/h\"", "spin_axis = "}},
      {kFreeBody + "[motion]\nspin = 3\nspin_axis = \"z\"\n", {"spin_axis = \"3\""}},
      {kFreeBody + "[motion]\nspin = 3\nspin_axis = [1, 0, 0]\n", {"spin_axis = \"1\""}},
      {kFreeBody + "[motion]\nspin = 3\n", {"spin_axis = \"largest\""}},
      {"[body]\nshape = \"cone\"\nradius = 1\nheight = 1\nmass = 1\n[motion]\nspin = 3\nlean = 20\n",
       {"spin_axis = \"3\"", "lean = \"20 deg\""}},
      {kFreeBody + "[motion]\nspin = 3\nspin_axis = \"1\"\nwobble_angle = \"5°\"\n", {"tilt = \"5°\""}},
      {kFreeBody + "[motion]\nenergy = 4.5\nM = 4.2\n", {"L = 4.2"}},
      {kFreeBody + "[motion]\nE = 4.5\nM = 4.2\n", {"energy = 4.5", "L = 4.2"}},
      {kFreeBody + "[motion]\nenergy = 4.5\n", {"L = 4.2"}},
      {kFreeBody + "[motion]\nangular_momentum = 3\nnutation_angle = 20\n",
       {"L_space = [0, 0, 3]", "euler.nutation = \"20 deg\""}},
      {kFreeBody + kSpun + "euler_angles = [10, 20, 30]\n",
       {"euler.precession = \"10 deg\"", "euler.nutation = \"20 deg\"", "euler.spin = \"30 deg\""}},
      {kFreeBody + "[motion]\neuler_angles = [0, 0.3, 0]\neuler_rates = [0, 0, 20]\n",
       {"euler.nutation = 0.3", "euler_rates.spin = 20"}},
      {kFreeBody + kSpun + "euler_sequence = \"321\"\neuler_angles_deg = [40, 10, -20]\n",
       {"roll_pitch_yaw = [\"-20 deg\", \"10 deg\", \"40 deg\"]"}},
      {kFreeBody + kSpun + "attitude = { roll = 0, pitch = -30, yaw = 0 }\n",
       {"roll_pitch_yaw = [\"0 deg\", \"-30 deg\", \"0 deg\"]"}},
      {kFreeBody + kSpun + "orientation = { w = 1, x = 0, y = 0, z = 1 }\n", {"orientation = [1, 0, 0, 1]"}},
  });
}

TEST(MendedScenes, HaveTheirForces) {
  expectMended({
      {kWholeBox + kSpun + "gravity = true\n", {"flight.gravity = [0, 0, -9.81]"}},
      {kWholeBox + kSpun + "velocity = [0, 0, 4]\ngravity = 9.8\n",
       {"flight.velocity = [0, 0, 4]", "flight.gravity = [0, 0, -9.8]"}},
      {kWholeBox + "[motion]\nspin = 100\nlean = \"20 deg\"\nspin_axis = \"3\"\ngravity = 9.81\n",
       {"gravity.g = 9.81", "pivot = [0, 0, -0.05]"}},
      {kWholeBox + "[motion]\nspin = 100\nlean = \"20 deg\"\nspin_axis = \"3\"\n[forces]\ng = 9.81\n",
       {"g = 9.81", "pivot = [0, 0, -0.05]"}},
      {kWholeBox + "[motion]\nspin = 100\nlean = \"20 deg\"\nspin_axis = \"3\"\n[motion.gravity]\ng = 9.81\n",
       {"pivot = [0, 0, -0.05]"}},
      {kFreeBody + kSpun + "[torque]\nMx = 0\nMy = 0\nMz = 0.02\nframe = \"body\"\n", {"body = [0, 0, 0.02]"}},
      {kFreeBody + kSpun + "[torque]\nbody = [0, 0, 0.02]\n", {"[motion.torque]", "body = [0, 0, 0.02]"}},
      {kFreeBody + kSpun + "[dissipation]\ninternal = true\nalpha = 0.02\n",
       {"[motion.dissipation]", "alpha = 0.02"}},
      {kFreeBody + kSpun + "angularDrag = 0.2\n", {"drag.rate = 0.2"}},
  });
}

TEST(MendedScenes, HaveTheirFilm) {
  const std::string scene = kFreeBody + kSpun + "[time]\n";
  expectMended({
      {scene + "film_length = \"20 s\"\n", {"duration = \"20 s\""}},
      {scene + "duration = \"30 d\"\nfilm_length = \"20 s\"\n", {"duration = \"20 s\"", "speed = 129600"}},
      {scene + "duration = \"30 d\"\n", {"duration = \"20 s\"", "speed = 129600"}},
      {scene + "span = \"1 h\"\nfilm = \"40 s\"\n", {"duration = \"40 s\"", "speed = 90"}},
      {scene + "start = \"2014-08-06T00:00:00\"\nstop = \"2014-08-08T00:00:00\"\nfilm_duration = 16\n",
       {"start = 0", "duration = 16", "speed = 10800"}},
      {scene + "t_span = [0, 3]\n", {"duration = 3"}},
      {scene + "slow_motion = 10\n", {"speed = 0.1"}},
      {scene + "speed = \"8x\"\n", {"speed = 8"}},
      {scene + "speed = \"1/4\"\n", {"speed = 0.25"}},
      {scene + "real_time_factor = 0.5\n", {"speed = 0.5"}},
      {scene + "duration = \"1:30\"\n", {"duration = 90"}},
      {scene + "duration = 12,5\n", {"duration = 12.5"}},
      {scene + "duration = 12 s\n", {"duration = \"12 s\""}},
      {scene + "loop = True\n", {"loop = true"}},
      {scene + "duration: 12\n", {"duration = 12"}},
      {scene + "duration = \"12,5 s\"\n", {"duration = \"12.5 s\""}},
      {scene + "// a comment\nfps = \"30 fps\"\n", {"fps = 30"}},
      {kFreeBody + kSpun + "[output]\nfile = \"box.gif\"\ninterval = 40\nfigsize = [19.2, 10.8]\n", {"fps = 25"}},
      {kFreeBody + kSpun + "[output]\nsize = \"1921x1081\"\n", {"size = [1922, 1082]"}},
  });
}

TEST(MendedScenes, HaveTheirPicture) {
  const std::string scene = kFreeBody + kSpun;
  expectMended({
      {scene + "[[vector]]\nquantity = \"L\"\ncolor = \"r\"\n[[vector]]\nof = \"omega\"\nlinestyle = \"--\"\n",
       {"L = true", "omega = true", "L = \"#ff0000\""}},
      {scene + "[show]\nvectors = [\"L\", \"omega\"]\nplots = [\"T(t)\"]\n",
       {"L = true", "omega = true", "[[plot]]", "quantities = [\"T\"]"}},
      {scene + "[show]\nangular_momentum = true\ninvariable_plane = true\nherpolhode = \"on plane\"\n",
       {"L.visible = true", "plane.visible = true", "herpolhode = true"}},
      {"[body]\nprincipal_moments = [2, 2, 1]\n[motion]\nomega_body = [1, 0, 5]\n[show]\nspace_cone = true\n"
       "body_cone = true\n",
       {"cones.visible = true"}},
      {scene + "[[subplot]]\nquantity = [\"omega_1\", \"omega_2\"]\nxlim = [-5, 0]\n[[subplot]]\nquantity = "
               "\"kinetic_energy\"\n",
       {"[[plot]]", "quantities = [\"omega_1\", \"omega_2\"]", "quantities = [\"T\"]"}},
      {scene + "[[plot]]\ny = [\"omega_1\", \"w2\"]\nxlim = [0, 5]\n",
       {"quantities = [\"omega_1\", \"omega_2\"]"}},
      {scene + "[camera]\nazim = [0, 360]\nelev = 20\nup = [0, 0, 1]\ntarget = \"body\"\n",
       {"orbit = \"360 deg\"", "elevation = \"20 deg\""}},
      {scene + "flight.velocity = [0, 0, 4]\n[camera]\ntarget = \"body\"\n", {"follow = true"}},
      {scene + "[camera]\nelevation = 25\nbody_fixed = false\n", {"elevation = \"25 deg\"", "frame = \"space\""}},
      {scene + "[style]\nbody_color = \"C1\"\nfacecolor = [1, 1, 1]\nalpha = 0.5\n",
       {"body = \"#ff7f0e\"", "paper = \"#ffffff\""}},
      {scene + "[style]\ntitle = \"A top\"\n", {"title = \"A top\""}},
      {scene + "[show.plane]\nalpha = 0.5\n", {"opacity = 0.5"}},
  });
}

const std::string kTopBody = "[body]\nmass = 0.5\npivot = [0, 0, -0.04]\n";
const std::string kTopStart = "[motion]\nlean = \"30 deg\"\nspin = 150\n";

TEST(MendedScenes, HaveTheBodyOfATop) {
  expectMended({
      // The axis of symmetry has the smallest moment.
      {"[body]\nmoments = [2e-3, 2e-3, 1e-3]\nmass = 0.5\nl = 0.04\n" + kTopStart + "gravity = 9.81\n",
       {"principal_moments = [0.002, 0.002, 0.001]", "spin_axis = \"3\"", "gravity.g = 9.81"}},
      {"[body]\nmoments = [1e-3, 1e-3, 5e-4]\nmass = 0.3\nh = 0.05\n" + kTopStart + "g = 9.81\n",
       {"pivot = [0, 0, -0.05]", "spin_axis = \"3\""}},
      {"[body]\nmoments = [1, 2, 2]\n[motion]\nspin = 3\n", {"spin_axis = \"1\""}},
      {"[body]\nmoments = [1, 2, 2.5]\n[motion]\nspin = 3\n", {"spin_axis = \"largest\""}},
      {kTopBody + "moments = [1, 2, 2.5]\n" + kTopStart + "gravity = 9.81\n", {"spin_axis = \"3\""}},
      {kTopBody + "moments = [5e-4, 5e-4, 2e-4]\n[motion]\ntilt = 1.0\nspin = 250\ngravity = [0, 0, -9.81]\n",
       {"lean = 1", "spin_axis = \"3\""}},
      {kTopBody + "moments = [1, 1, 2]\n[motion]\nnutation = \"20 deg\"\nspin = 250\ngravity = 9.81\n",
       {"lean = \"20 deg\""}},
      {kFreeBody + "[motion]\nnutation = \"20 deg\"\nspin = 2\nspin_axis = \"3\"\n", {"tilt = \"20 deg\""}},
      {"[body]\nshape = \"ring\"\nr_in = 0.025\nr_out = 0.03\nheight = 0.01\nmass = 0.06\n" + kSpun,
       {"shape = \"cylinder\"", "inner_radius = 0.025", "radius = 0.03", "height = 0.01"}},
      {"[body]\nshape = \"rod\"\nlength = 1.0\nmass = 0.5\n" + kSpun, {"size = [1, 0.02, 0.02]"}},
      {"[body]\nshape = \"plate\"\nsize = [0.3, 0.2, 0.005]\ndensity = 2700\n" + kSpun, {"shape = \"box\""}},
      {"[body]\ntarget = \"TOUTATIS\"\n" + kSpun, {"catalogue = \"toutatis\""}},
      {"[body]\nellipticity = \"1/305\"\n" + kSpun, {"principal_moments = [1, 1, 1.0032787]"}},
      {"[body]\nmass = 2.0\nunit_inertia = [0.5, 0.6, 0.9]\n" + kSpun, {"principal_moments = [1, 1.2, 1.8]"}},
      {"[body]\nmass = 0.2\nmoments = [5e-4, 5e-4, 2e-4]\ncom = [0, 0, 0.04]\n" + kTopStart + "gravity = 9.81\n",
       {"centre_of_mass = [0, 0, 0.04]", "pivot = [0, 0, 0]"}},
      {kFreeBody + "[motion]\nM = 3.0\ntheta = \"25 deg\"\n",
       {"L_space = [0, 0, 3]", "euler.nutation = \"25 deg\""}},
      {"[body]\nmoments = {1, 2, 2.5}\n" + kSpun, {"principal_moments = [1, 2, 2.5]"}},
  });
}

// 0.0014 + 0.012 < 0.0164; the nearest possible moments are on the edge, where the first two add up to the third.
TEST(MendedScenes, HavePossibleMoments) {
  const std::string text = "[body]\nI1 = 0.0014\nI2 = 0.012\nI3 = 0.0164\n" + kSpun;
  EXPECT_THAT(messagesOf(text), HasSubstr("I3 must not exceed I1 + I2, got (0.0014, 0.012, 0.0164) kg·m²"));
  expectMended({{text, {"principal_moments = [0.0024, 0.013, 0.0154]"}}});
}

TEST(MendedScenes, HaveTheirUnitsAndOrders) {
  expectMended({
      {kFreeBody + "[motion]\nomega = [2, 700, 2]\nomega_units = \"deg/s\"\n",
       {"omega_body = [\"2 deg/s\", \"700 deg/s\", \"2 deg/s\"]"}},
      {kFreeBody + "[motion]\nomega_units = \"deg/s\"\nomega = [2, 700, 2]\n", {"\"700 deg/s\""}},
      {kFreeBody + kSpun + "[time]\nduration = 2\nduration_unit = \"min\"\n", {"duration = \"2 min\""}},
      {kFreeBody + kSpun + "angle_unit = \"deg\"\n", {}},
      {kFreeBody + "[motion]\nspin = \"2400 min^-1\"\nspin_axis = \"3\"\n", {"spin = \"2400 rpm\""}},
      {kFreeBody + kSpun + "[time]\nframe_start = 1\nframe_end = 240\n[output]\nfps = 24\n",
       {"duration = 10", "fps = 24"}},
      {kFreeBody + kSpun + "speed = 6.0\nlaunch_angle = \"60 deg\"\ngravity = \"earth\"\n",
       {"flight.velocity = [3, 0, 5.19615]", "flight.gravity = [0, 0, -9.81]"}},
      {kFreeBody + kSpun + "gravity = false\n", {}},
      // 2e-6/5e-4 and 2e-6/2e-4
      {"[body]\nprincipal_moments = [5e-4, 5e-4, 2e-4]\n" + kSpun + "friction = 2e-6\n",
       {"drag.rate = [0.004, 0.004, 0.01]"}},
      {kFreeBody + kSpun + "damping = \"2 N m s\"\n", {"drag.rate = [2, 1, 0.8]"}},
      {kFreeBody + kSpun + "[motion.damping]\nangular = 0.1\n", {"rate = 0.1"}},
      {kFreeBody + kSpun + "[[torque]]\naxis = \"x\"\nvalue = 0.02\nframe = \"world\"\n",
       {"[motion.torque]\nspace = [0.02, 0, 0]"}},
      {kFreeBody + kSpun + "[time]\nduration = \"400 d\"\nspeed = 1728000\n", {"duration = 20\n"}},
      {kFreeBody + kSpun + "energy_dissipation = { tau = 200 }\n", {"[motion.dissipation]\nalpha = 0.02"}},
      {kFreeBody + kSpun + "[motion.energy_dissipation]\ntau = 200\n", {"[motion.dissipation]\nalpha = 0.02"}},
  });
}

TEST(MendedScenes, SayBothOrdersOfAQuaternion) {
  const std::string first = kFreeBody + kSpun + "q = [0.9239, 0, 0, 0.3827]\n",
                    last = kFreeBody + kSpun + "q = [0.0, 0.0, 0.3827, 0.9239]\n";
  EXPECT_THAT(messagesOf(first), Not(HasSubstr(" or, ")));
  EXPECT_THAT(messagesOf(last), HasSubstr("    orientation = [0, 0, 0.3827, 0.9239]\n"));
  EXPECT_THAT(messagesOf(last),
              HasSubstr("or, if no rotation is [0, 0, 0, 1] where this comes from:\n    orientation "
                        "= [0.9239, 0, 0, 0.3827]\n"));
  EXPECT_THAT(messagesOf("[body]\nmoments = [1, 2, 2.5]\n" + kSpun + "damping = 1e-6\n"),
              HasSubstr("    drag.rate = 1e-06\n  or, for a coefficient in N m s:\n    drag.rate = [1e-06, 5e-07, "
                        "4e-07]\n"));
}

TEST(MendedScenes, HaveTheThingsOfTheirLists) {
  const std::string scene = kFreeBody + kSpun;
  expectMended({
      {scene + "[[vector]]\nname = \"L\"\nc = \"r\"\n", {"L = true", "L = \"#ff0000\""}},
      {scene + "[[vector]]\nname = \"omega\"\n", {"omega = true"}},
      {scene + "[show]\ntheta = false\n[[vector]]\nname = \"omega\"\n", {"[show]\nomega = true"}},
      {scene + "[show]\npoinsot = [\"ellipsoid\", \"plane\", \"polhode\", \"herpolhode\"]\n",
       {"ellipsoid = true", "plane = true", "polhode = true", "herpolhode = true"}},
      {scene + "[show]\npoinsot = true\n", {"ellipsoid = true", "herpolhode = true"}},
      {scene + "[show]\nextras = [\"theta\", \"trace\"]\n", {"theta = true", "trace = true"}},
      {scene + "[camera]\nreference_frame = \"BODY_FIXED\"\n", {"frame = \"body\""}},
      {scene + "[output]\nsize = [1080, 1920]\norientation = \"portrait\"\n", {"size = [1080, 1920]"}},
      {scene + "flight.velocity = [0, 0, 4]\n[show]\nV = true\n", {"flight.velocity = true"}},
  });
}

// A mass of the shape would be refused in the next run.
TEST(MendedScenes, HaveTheirMomentsAndNoShape) {
  const std::string shape = "size = [0.3, 0.2, 0.1]\nmoments = [1, 2, 2.5]\n" + kSpun;
  EXPECT_THAT(messagesOf("[body]\nshape = \"box\"\n" + shape), HasSubstr("leave out shape and size ("));
  EXPECT_THAT(messagesOf("[body]\nshape = \"T-shape\"\nmoments = [1, 2, 2.5]\n" + kSpun),
              Not(HasSubstr("body.mass is missing")));
}

TEST(MendedScenes, NeverLeadToAnotherSubject) {
  EXPECT_THAT(messagesOf(kFreeBody + kSpun + "[time]\nframe_start = 1\n"), Not(HasSubstr("principal_axes")));
  EXPECT_THAT(messagesOf(kFreeBody + kSpun + "[output]\ntolerance = \"fine\"\n"), Not(HasSubstr("did you mean")));
}

// Two lines "visible = true" would say nothing.
TEST(MendedScenes, NameTheThingInEachLine) {
  const std::string message = messagesOf(kFreeBody + kSpun + "[show]\npoinsot_picture = true\n");
  EXPECT_THAT(message, HasSubstr("    ellipsoid = true  # in [show]: "));
  EXPECT_THAT(message, Not(HasSubstr("    visible = ")));
}

TEST(MendedScenes, SuggestAtMostThreeKeysForAnyOtherName) {
  for (const char* line :
       {"[time]\nlength_of_movie = 5", "[camera]\nmagnification_factor = 2", "[output]\nvideo_quality = 3",
        "[show]\nspin_trace = true", "[style]\nfont_scale = 2", "[label]\nname_of_torque = 0.1"}) {
    const std::string message = messagesOf(kFreeBody + kSpun + line + "\n");
    EXPECT_THAT(message, HasSubstr("did you mean ")) << line;
    EXPECT_LE(std::count(message.begin(), message.end(), '\n'), 5) << message;
  }
}

}  // namespace
}  // namespace poinsot::scene

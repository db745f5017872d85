// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/foreign_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <utility>

#include "scene/keys/keys.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kMoments = "body.principal_moments", kTensor = "body.inertia";
constexpr std::string_view kBox = "shape = \"box\"; size = [0.3, 0.2, 0.05]", kMass = "mass = 1";
constexpr std::string_view kBoxShape = "shape = \"box\"; mass = 1", kBall = "shape = \"sphere\"; mass = 1";
constexpr std::string_view kInBodyAxes =
    "Its components are along the body's axes; motion.omega_space takes those along the world's axes.";
constexpr std::string_view kMomentum =
    "Its components are along the body's axes; motion.L_space takes those along the world's axes.";
constexpr std::string_view kScalarFirst = "The order is w, x, y, z.";
constexpr std::string_view kNoSteps = "The motion is computed exactly at any time and has no time step.";

constexpr std::string_view kEuler =
    "The Euler angles follow the order z, x, z, where the z axis of the body leans by the nutation.";

constexpr auto kRows = std::to_array<ForeignNames>({
    // Angles of a textbook (nutation, precession, spin) and of an aircraft
    {"theta theta0 theta_0 nutation nutation_angle", "motion.euler.nutation", "", kEuler},
    {"phi phi0 phi_0 precession precession_angle", "motion.euler.precession", "", kEuler},
    {"psi psi0 psi_0 spin_angle", "motion.euler.spin", "", kEuler},
    {"euler euler_angles eul", "motion.euler.nutation", "", kEuler, Carry::kNothing},
    {"theta_dot thetadot dtheta dtheta_dt nutation_rate", "motion.euler_rates.nutation", "", kEuler},
    {"phi_dot phidot dphi dphi_dt precession_rate", "motion.euler_rates.precession", "", kEuler},
    {"psi_dot psidot dpsi dpsi_dt", "motion.euler_rates.spin", "", kEuler},
    {"euler_rates", "motion.euler_rates.precession", "", kEuler, Carry::kNothing},
    {"lean lean_angle inclination tilt_angle", "motion.lean", "spin_axis = \"largest\""},
    {"roll pitch yaw", "motion.roll_pitch_yaw", "", "", Carry::kList},
    {"rpy roll_pitch_yaw", "motion.roll_pitch_yaw"},
    {"heading ypr yaw_pitch_roll", "motion.roll_pitch_yaw", "", "", Carry::kNothing},
    {"roll_rate pitch_rate yaw_rate roll_dot pitch_dot yaw_dot", "motion.omega_body", "", kInBodyAxes,
     Carry::kNothing},

    // Moments of inertia
    {"Ixx Ixy Ixz Iyy Iyz Izz", kTensor, "", "", Carry::kTensor},
    {"I_xx I_xy I_xz I_yy I_yz I_zz", kTensor, "", "", Carry::kTensor},
    {"ixx ixy ixz iyy iyz izz", kTensor, "", "", Carry::kTensor},
    {"Jxx Jxy Jxz Jyy Jyz Jzz", kTensor, "", "", Carry::kTensor},
    {"Ixx Iyy Izz", kMoments, "", "", Carry::kList},
    {"I_xx I_yy I_zz", kMoments, "", "", Carry::kList},
    {"ixx iyy izz", kMoments, "", "", Carry::kList},
    {"Jxx Jyy Jzz", kMoments, "", "", Carry::kList},
    {"A B C", kMoments, "", "", Carry::kList},
    {"I11 I12 I13 I22 I23 I33", kTensor, "", "", Carry::kTensor},
    {"I_11 I_12 I_13 I_22 I_23 I_33", kTensor, "", "", Carry::kTensor},
    {"I11 I22 I33", kMoments, "", "", Carry::kList},
    {"I_11 I_22 I_33", kMoments, "", "", Carry::kList},
    {"I1 I2 I3", kMoments, "", "", Carry::kList},
    {"I_1 I_2 I_3", kMoments, "", "", Carry::kList},
    {"Ix Iy Iz", kMoments, "", "", Carry::kList},
    {"I_x I_y I_z", kMoments, "", "", Carry::kList},
    {"J1 J2 J3", kMoments, "", "", Carry::kList},
    {"Jx Jy Jz", kMoments, "", "", Carry::kList},
    {"I J moments moments_of_inertia moment_of_inertia moment inertias inertia_moments diaginertia diag_inertia "
     "inertia_diagonal inertia_diag principal_inertia I0 Ip I_principal moi MOI local_inertia "
     "local_inertia_diagonal",
     kMoments},
    {"I J Ibody I_body I_b IB I_B inertia_tensor inertial_tensor tensor inertia_matrix I_tensor J_body moi MOI "
     "moment_of_inertia moments_of_inertia inertia",
     kTensor},
    {"fullinertia products_of_inertia", kTensor, "", "", Carry::kNothing},
    {"Ibody I_body I_b IB I_B inertia_tensor inertial_tensor tensor inertia_matrix I_tensor J_body inertia",
     kMoments},

    // Mass, shape and points of the body
    {"m M mass total_mass body_mass mass_of_body weight", "body.mass"},
    {"rho density mass_density", "body.density", kBox},
    {"r R radius", "body.radius", kBall},
    {"diameter d", "body.radius", kBall, "The radius is half the diameter.", Carry::kValue, "", 0.5},
    {"lx ly lz", "body.size", kBoxShape, "", Carry::kList},
    {"size", "output.size"},  // only a picture has two whole numbers; other sizes are those of a body
    {"dimensions dims dim extents extent sides edges box_size size", "body.size", kBoxShape},
    {"half_extents halfextents half_size half_sizes semi_axes semiaxes", "body.size", kBoxShape,
     "The size is the full extent, twice the half extent.", Carry::kValue, "", 2},
    {"edge edge_length side side_length", "body.edge", "shape = \"cube\"; mass = 1"},
    {"length", "body.size", kBoxShape, "It takes the three extents together.", Carry::kNothing},
    {"type shape shape_type geometry geom solid kind", "body.shape"},
    {"type object model preset kind body", "body.catalogue"},
    {"pivot fixed_point pivot_point support anchor", "body.pivot", kMass},
    {"l distance_to_pivot pivot_distance com_distance cm_distance lever lever_arm arm_length", "body.pivot", kMass,
     "This pivot is below the origin of the body axes, by the distance of the centre of mass from it.",
     Carry::kBelow},
    {"center_of_mass centre_of_mass centre_of_gravity center_of_gravity com cog cm r_cm r_com",
     "body.centre_of_mass", kMass},

    // Start of the motion
    {"w w0 w_0 omega omega0 omega_0 Omega Omega0 angular_velocity angular_vel ang_vel angvel av w_body wb "
     "omega_b omega_B angular_speed rotation_rate rotational_velocity rotation_speed spin_vector spin_velocity "
     "body_rates gyro motion.spin",
     "motion.omega_body", "", kInBodyAxes},
    {"wx wy wz", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w_x w_y w_z", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w1 w2 w3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega_x omega_y omega_z", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omegax omegay omegaz", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega_1 omega_2 omega_3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega1 omega2 omega3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w_world w_space omega_world omega_W omega_inertial omega_lab", "motion.omega_space"},
    {"spin_rate spin_speed", "motion.spin", "spin_axis = \"largest\""},
    {"rpm", "motion.spin", "spin_axis = \"largest\"", "", Carry::kValue, "rpm"},
    {"L L0 L_0 H H0 H_0 angular_momentum angular_momenta ang_mom angmom", "motion.L_body", "", kMomentum},
    {"Lx Ly Lz", "motion.L_body", "", kMomentum, Carry::kList},
    {"Hx Hy Hz", "motion.L_body", "", kMomentum, Carry::kList},
    {"L_world L_inertial H_space H_world", "motion.L_space"},
    {"qw qx qy qz", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q_w q_x q_y q_z", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q0 q1 q2 q3", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q q0 q_0 quat quat0 quaternion attitude attitude0 pose orientation attitude_quaternion "
     "orientation_quaternion",
     "motion.orientation", "", kScalarFirst},
    {"quat_xyzw q_xyzw quaternion_xyzw", "motion.orientation", "", kScalarFirst, Carry::kXyzw},
    {"rotation_matrix R0 dcm DCM rotation", "motion.orientation", "", kScalarFirst, Carry::kNothing},
    {"integrator solver method tol rtol atol accuracy", "motion.tolerance", "", kNoSteps, Carry::kNothing},

    // Forces
    {"M", "motion.torque.body", "",
     "In Landau and Lifshitz, M is the angular momentum: motion.L_body takes it, and starts the motion."},
    {"torque torques tau tau_body moment external_torque applied_torque torque_body", "motion.torque.body"},
    {"torque_space torque_world tau_space", "motion.torque.space"},
    {"gravity g grav g0 gravitational_acceleration acceleration_of_gravity gravity_acceleration",
     "motion.gravity.g", "", "It acts on a body that has body.mass and body.pivot."},
    {"mgr mgl mgh MgR Mgl mgr_body", "motion.gravity.mgr_body"},
    {"drag damping angular_damping rotational_damping damping_rate drag_rate", "motion.drag.rate", "",
     "The rate d is that of dL/dt = -d L, in 1/s."},
    {"friction friction_coefficient viscosity viscous_friction damping_coefficient drag_coefficient "
     "air_resistance",
     "motion.drag.rate", "", "The rate d is that of dL/dt = -d L, in 1/s.", Carry::kNothing},
    {"dissipation alpha energy_loss internal_friction internal_damping dissipation_rate energy_dissipation_rate "
     "energy_loss_rate",
     "motion.dissipation.alpha", "", "It makes the body lose energy and keep L."},
    {"v v0 v_0 velocity linear_velocity vel", "motion.flight.velocity"},
    {"r0 r_0 x0 x_0 position pos", "motion.flight.position"},

    // Film
    {"duration time t_end tend tmax t_max end_time stop_time t_stop t_final tfinal tf t_f simulation_time "
     "sim_time total_time max_time runtime",
     "time.duration"},
    {"tspan t_span time_span time_interval", "time.duration", "", "", Carry::kNothing},
    {"steps n_steps nsteps num_steps frames n_frames nframes num_frames frame_count n "
     "frame_end",
     "time.duration", "", "A film has duration times fps frames.", Carry::kNothing},
    {"fps framerate frame_rate frames_per_second", "time.fps"},
    {"dt time_step timestep step step_size", "time.fps", "", kNoSteps, Carry::kNothing},
    {"t0 t_0 t_start tstart start_time", "time.start"},
    {"slow_motion slowmo time_scale timescale playback_speed", "time.speed"},
    {"width height", "output.size", "", "", Carry::kList},
    {"height h", "body.height", "shape = \"cylinder\"; radius = 0.1; mass = 1"},
    {"resolution size_px image_size window_size video_size output_size", "output.size"},
    {"figsize dpi", "output.size", "", "", Carry::kNothing},
    {"bitrate", "output.crf", "", "", Carry::kNothing},
    {"encoder vcodec video_codec", "output.codec"},

    // Picture
    {"camera_position camera_pos cam_pos eye eye_position camera_location camera.position camera.location "
     "camera.pos camera.from view.position",
     "camera.azimuth", "", "The camera looks at the body from this direction; its distance is automatic.",
     Carry::kPosition},
    {"azim", "camera.azimuth", "", "", Carry::kValue, "deg"},
    {"elev", "camera.elevation", "", "", Carry::kValue, "deg"},
    {"field_of_view", "camera.fov"},
    {"camera_preset viewpoint", "camera.preset"},
    {"camera_distance camera.distance", "camera.zoom", "",
     "The distance is automatic, so that the motion fits into the picture.", Carry::kNothing},
    {"background background_color background_colour bg bg_color bgcolor facecolor clear_color "
     "world_color",
     "style.colors.paper"},
    {"body_color body_colour", "style.colors.body"},
    {"font_size fontsize", "style.text_size", "", "", Carry::kNothing},
    {"dark_mode dark", "style.theme", "", "", Carry::kNothing},
    {"theme style.preset", "style.theme"},
    {"title name scene_name suptitle heading", "show.title"},
    {"look_at lookat target focus", "camera.azimuth", "",
     "The camera always looks at the body; only its direction is chosen.", Carry::kNothing},
    {"L_vector L_arrow angular_momentum_vector", "show.L.visible"},
    {"omega_vector omega_arrow angular_velocity_vector", "show.omega.visible"},
    {"body_axes frame_axes axes body_frame", "show.principal_axes.visible"},
    {"poinsot_ellipsoid inertia_ellipsoid energy_ellipsoid draw_ellipsoid", "show.ellipsoid.visible"},
    {"invariable_plane draw_plane draw_invariable_plane", "show.plane.visible"},
    {"trail trail_length trajectory path show_trail", "show.trace.visible", "", "", Carry::kNothing},
});

using Rows = std::vector<const ForeignNames*>;

const std::map<std::string_view, Rows>& rowsByName() {
  static const auto all = [] {
    std::map<std::string_view, Rows> map;
    for (const ForeignNames& row : kRows)
      for (const std::string_view name : namesIn(row)) map[name].push_back(&row);
    return map;
  }();
  return all;
}

Rows rowsOf(std::string_view name) {
  const auto found = rowsByName().find(name);
  return found == rowsByName().end() ? Rows() : found->second;
}

/// Returns a name in small letters with underscores: "angular_velocity" for "angularVelocity" and
/// "Angular-Velocity".
std::string snakeCase(std::string_view name) {
  std::string snake;
  bool wasSmall = false;
  for (const char c : name) {
    const bool capital = c >= 'A' && c <= 'Z';
    if (capital && wasSmall) snake += '_';
    snake += c == '-' ? '_' : static_cast<char>(capital ? c - 'A' + 'a' : c);
    wasSmall = c >= 'a' && c <= 'z';
  }
  return snake;
}

/// Returns a name without a word for "at the start": "omega" for "initial_omega" and "omega_init".
std::string_view withoutInitial(std::string_view name) {
  for (const std::string_view prefix : {"initial_", "init_", "start_"})
    if (name.starts_with(prefix)) return name.substr(prefix.size());
  for (const std::string_view suffix : {"_initial", "_init", "_start"})
    if (name.ends_with(suffix)) return name.substr(0, name.size() - suffix.size());
  return name;
}

Rows foreignRows(std::string_view path) {
  const std::string_view name = nameOf(path);
  const std::string snake = snakeCase(name);
  for (const std::string_view tried :
       {path, name, withoutInitial(name), std::string_view(snake), withoutInitial(snake)}) {
    if (tried != name && isTable(tried)) continue;  // [Body] is a misspelt table
    if (Rows rows = rowsOf(tried); !rows.empty()) return rows;
  }
  return {};
}

std::string_view topOf(std::string_view path) { return path.substr(0, path.find('.')); }

/// Returns whether a table may contain names of physics: the top, [body], [motion], or a table of another program.
bool isPhysics(std::string_view table) {
  const std::string_view top = topOf(table.substr(0, table.find('[')));
  return table.empty() || top == "body" || top == "motion" || !(isTable(top) || isTableArray(top));
}

}  // namespace

std::span<const ForeignNames> foreignNames() { return kRows; }

std::vector<std::string_view> namesIn(const ForeignNames& row) {
  std::vector<std::string_view> names;
  for (std::string_view rest = row.names; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    names.push_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return names;
}

bool isPlausible(const ForeignNames& row, std::string_view path) {
  const std::string_view table = tableOf(path);
  if (isPhysics(table) || findKey(pathBelow(table, nameOf(row.key)))) return true;
  return !isPhysics(tableOf(row.key)) && table.find('[') == std::string_view::npos;
}

std::string keyFor(const ForeignNames& row, std::string_view path) {
  const std::string_view table = tableOf(path);
  std::string own = pathBelow(table, nameOf(row.key));
  const bool isBelow = tableOf(row.key).starts_with(std::string(table) + ".");  // motion.nutation is another key
  return findKey(own) && !isBelow ? own : std::string(row.key);
}

std::vector<const ForeignNames*> plausibleRows(std::string_view path) {
  Rows rows = foreignRows(path);
  std::erase_if(rows,
                [&](const ForeignNames* row) { return !isPlausible(*row, path) || keyFor(*row, path) == path; });
  return rows;
}

std::string_view wordElsewhere(std::string_view word) {
  constexpr auto kWords = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"cuboid", "box"},
      {"brick", "box"},
      {"block", "box"},
      {"rectangle", "plate"},
      {"ball", "sphere"},
      {"spheroid", "ellipsoid"},
      {"shell", "sphere_shell"},
      {"disk", "disc"},
      {"ring", "hoop"},
      {"donut", "torus"},
      {"doughnut", "torus"},
      {"bar", "rod"},
      {"stick", "rod"},
      {"tube", "cylinder"},
      {"pipe", "cylinder"},
      {"wheel", "disc"},
      {"pyramid", "tetrahedron"},
  });
  const auto found = std::ranges::find(kWords, word, &std::pair<std::string_view, std::string_view>::first);
  return found == kWords.end() ? std::string_view() : found->second;
}

std::string_view namedColor(std::string_view name) {
  constexpr auto kColors = std::to_array<std::pair<std::string_view, std::string_view>>({
      {"white", "#ffffff"},
      {"black", "#000000"},
      {"gray", "#808080"},
      {"grey", "#808080"},
      {"red", "#ff0000"},
      {"green", "#008000"},
      {"blue", "#0000ff"},
      {"yellow", "#ffff00"},
      {"orange", "#ffa500"},
      {"purple", "#800080"},
  });
  const auto found = std::ranges::find(kColors, name, &std::pair<std::string_view, std::string_view>::first);
  return found == kColors.end() ? std::string_view() : found->second;
}

}  // namespace poinsot::scene

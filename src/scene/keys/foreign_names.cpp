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

constexpr std::string_view kCatalogue =
    "The catalogue has t_handle, racket, book, phone, football, frisbee, wing_nut, explorer_1, earth and "
    "toutatis.";
constexpr std::string_view kEllipsoid = "shape = \"ellipsoid\"; mass = 1";
constexpr std::string_view kTube = "shape = \"cylinder\"; radius = 0.1; height = 0.2; mass = 1";
constexpr std::string_view kDragRate =
    "The rate d is that of dL/dt = -d L, in 1/s: a coefficient in N m s divided by the moment of inertia.";
constexpr std::string_view kTimeConstant = "For a time constant tau, alpha is about 1/(tau L^2 |1/I1 - 1/I3|).";
constexpr std::string_view kLaunchAngle = "The throw is in the plane of x and z.";
constexpr std::string_view kSemiAxes = "As semi-axes, they are half the extents that size takes.";
constexpr std::string_view kTwoEqual = "The first two are those across the axis of symmetry.";
constexpr std::string_view kEulerOrder =
    "The order is precession, nutation, spin (z, x, z): the z axis of the body leans by the nutation.";
constexpr std::string_view kEuler =
    "The Euler angles follow the order z, x, z, where the z axis of the body leans by the nutation.";

constexpr auto kRows = std::to_array<ForeignNames>({
    // Angles of a textbook (nutation, precession, spin) and of an aircraft
    {"theta theta0 theta_0 nutation nutation_angle", "motion.euler.nutation", "", kEuler},
    {"phi phi0 phi_0 precession precession_angle", "motion.euler.precession", "", kEuler},
    {"psi psi0 psi_0 spin_angle", "motion.euler.spin", "", kEuler},
    {"euler euler_angles eul euler_angle eulerangles euler0 euler_313 euler_zxz angles initial_angles",
     "motion.euler.precession", "", kEulerOrder, Carry::kEuler},
    {"theta_dot thetadot dtheta dtheta_dt nutation_rate", "motion.euler_rates.nutation", "", kEuler},
    {"phi_dot phidot dphi dphi_dt precession_rate", "motion.euler_rates.precession", "", kEuler},
    {"psi_dot psidot dpsi dpsi_dt", "motion.euler_rates.spin", "", kEuler},
    {"euler_rates euler_angle_rates euler_dot euler_velocities angle_rates", "motion.euler_rates.precession", "",
     kEulerOrder, Carry::kEuler},
    {"euler_sequence euler_order euler_convention rotation_order rotation_sequence sequence convention "
     "angle_convention",
     "", "", "The angles of motion.euler follow the order z, x, z; motion.roll_pitch_yaw follows x, y, z.",
     Carry::kRemove},
    {"lean lean_angle inclination inclination_angle angle_from_vertical polar_angle initial_angle angle",
     "motion.lean", "spin_axis = \"largest\""},
    {"tilt_angle tilt wobble wobble_angle wobbling cone_angle angle_to_L half_angle opening_angle obliquity",
     "motion.tilt", "spin = 10; spin_axis = \"largest\"",
     "It is the angle between the axis of the spin and L, without gravity; motion.lean is that to the vertical."},
    {"steady_precession regular_precession steady regular slow_precession", "motion.precession",
     "spin = \"50 rev/s\"; spin_axis = \"3\"; lean = \"30 deg\"",
     "\"slow\" and \"fast\" are the two steady precessions of a top under gravity.", Carry::kNothing},
    {"roll pitch yaw", "motion.roll_pitch_yaw", "", "", Carry::kList},
    {"rpy roll_pitch_yaw attitude rotation orientation_rpy euler_xyz euler_rpy tait_bryan rotation_angles "
     "attitude_angles initial_rotation rot",
     "motion.roll_pitch_yaw"},
    {"ypr yaw_pitch_roll euler_321 euler_zyx", "motion.roll_pitch_yaw", "", "The order is roll, pitch, yaw.",
     Carry::kReversed},
    {"heading azimuth_angle bank", "motion.roll_pitch_yaw", "", "", Carry::kNothing},
    {"roll_rate pitch_rate yaw_rate", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"roll_dot pitch_dot yaw_dot", "motion.omega_body", "", kInBodyAxes, Carry::kNothing},
    {"p q r", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"P Q R", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"p0 q0 r0", "motion.omega_body", "", kInBodyAxes, Carry::kList},

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
    {"i1 i2 i3", kMoments, "", "", Carry::kList},
    {"moment_1 moment_2 moment_3", kMoments, "", "", Carry::kList},
    {"I_1 I_2 I_3", kMoments, "", "", Carry::kList},
    {"Ix Iy Iz", kMoments, "", "", Carry::kList},
    {"I_x I_y I_z", kMoments, "", "", Carry::kList},
    {"J1 J2 J3", kMoments, "", "", Carry::kList},
    {"Jx Jy Jz", kMoments, "", "", Carry::kList},
    {"I1 I3", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_1 I_3", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"A C", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I I3", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perp I_axis", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perp I_par", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perp I_parallel", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perp I_z", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perp I_spin", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_perpendicular I_parallel", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_transverse I_axial", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_t I_a", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"It Ia", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"It Is", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_trans I_axis", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I_transverse I_spin", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"transverse_inertia axial_inertia", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"transverse_moment axial_moment", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"Ixx Izz", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"Ix Iz", kMoments, "", kTwoEqual, Carry::kSymmetric},
    {"I J moments moments_of_inertia moment_of_inertia moment inertias inertia_moments diaginertia diag_inertia "
     "inertia_diagonal inertia_diag principal_inertia I0 Ip I_principal moi MOI local_inertia "
     "local_inertia_diagonal moment_ratios moments_ratio inertia_ratios ratio_of_moments principal_axes_moments "
     "inertia_ratio principal",
     kMoments},
    {"I J Ibody I_body I_b IB I_B inertia_tensor inertial_tensor tensor inertia_matrix I_tensor J_body moi MOI "
     "moment_of_inertia moments_of_inertia inertia",
     kTensor},
    {"unit_inertia unit_moments unit_inertia_moments", kMoments, "", "Each is a unit inertia times the mass."},
    {"ellipticity dynamical_ellipticity dynamic_ellipticity oblateness", kMoments, "",
     "An ellipticity (C - A)/A gives this ratio of the moments, which suffices without torques.",
     Carry::kEllipticity},
    {"fullinertia products_of_inertia", kTensor, "", "", Carry::kNothing},
    {"Ibody I_body I_b IB I_B inertia_tensor inertial_tensor tensor inertia_matrix I_tensor J_body inertia",
     kMoments},

    // Mass, shape and points of the body
    {"motion.M motion.L_magnitude motion.L_norm motion.Lmag", "motion.L", "energy = \"4.5 J\"",
     "With motion.energy it gives the start; motion.L_body takes the vector."},
    {"m M mass total_mass body_mass mass_of_body weight masse", "body.mass"},
    {"material", "body.density", kBox, "Densities of materials differ; this is a usual value."},
    {"rho density mass_density", "body.density", kBox},
    {"r R radius", "body.radius", kBall},
    {"r_in r_inner inner_r rin R_in R_inner inner_radius", "body.inner_radius", kTube},
    {"inner_diameter d_in", "body.inner_radius", kTube, "The radius is half the diameter.", Carry::kValue, "",
     0.5},
    {"r_out r_outer outer_r rout R_out R_outer outer_radius", "body.radius", kBall},
    {"outer_diameter d_out", "body.radius", kBall, "The radius is half the diameter.", Carry::kValue, "", 0.5},
    {"diameter d", "body.radius", kBall, "The radius is half the diameter.", Carry::kValue, "", 0.5},
    {"lx ly lz", "body.size", kBoxShape, "", Carry::kList},
    {"Lx Ly Lz", "body.size", kBoxShape, "", Carry::kList},
    {"size_x size_y size_z", "body.size", kBoxShape, "", Carry::kList},
    {"dx dy dz", "body.size", kBoxShape, "", Carry::kList},
    {"x y z", "body.size", kBoxShape, "", Carry::kList},
    {"length width thickness", "body.size", kBoxShape, "", Carry::kList},
    {"length width depth", "body.size", kBoxShape, "", Carry::kList},
    {"width height depth", "body.size", kBoxShape, "", Carry::kList},
    {"semi_axis_a semi_axis_b semi_axis_c", "body.size", kEllipsoid, kSemiAxes, Carry::kList, "", 2},
    {"rx ry rz", "body.size", kEllipsoid, kSemiAxes, Carry::kList, "", 2},
    {"a b c", "body.size", kEllipsoid, kSemiAxes, Carry::kList, "", 2},
    {"a c", "body.size", kEllipsoid, kSemiAxes, Carry::kSymmetric, "", 2},
    {"equatorial_radius polar_radius", "body.size", kEllipsoid, kSemiAxes, Carry::kSymmetric, "", 2},
    {"size", "output.size"},  // only a picture has two whole numbers; other sizes are those of a body
    {"dimensions dims dim extents extent sides edges box_size size", "body.size", kBoxShape},
    {"half_extents halfextents half_extent half_size half_sizes half_dims half_lengths semi_axes semiaxes "
     "semi_axis radii",
     "body.size", kBoxShape, "The size is the full extent, twice the half extent.", Carry::kValue, "", 2},
    {"edge edge_length side side_length", "body.edge", "shape = \"cube\"; mass = 1"},
    {"length", "body.size", kBoxShape, "It takes the three extents together.", Carry::kNothing},
    {"type shape shape_type geometry geom solid kind object name primitive form", "body.shape"},
    {"type object model preset kind body name template example catalog asteroid planet target designation comet "
     "celestial_body object_name body_name",
     "body.catalogue", "", kCatalogue},
    {"type shape shape_type geometry geom solid kind primitive form", "body.shape"},
    {"thickness", "body.wall", "shape = \"hollow_box\"; size = [0.3, 0.2, 0.05]; mass = 1"},
    {"pivot fixed_point pivot_point support stand anchor suspension_point point_of_support tip hinge "
     "contact_point",
     "body.pivot", kMass},
    {"l distance_to_pivot pivot_distance com_distance cm_distance lever lever_arm arm_length l_cm d_cm h_cm l_com "
     "com_height cm_height distance_to_com pivot_to_com length_to_com height_of_com center_of_mass_distance "
     "centre_of_mass_distance distance pivot_offset",
     "body.pivot", kMass,
     "This pivot is below the origin of the body axes, by the distance of the centre of mass from it.",
     Carry::kBelow},
    {"center_of_mass centre_of_mass mass_center mass_centre centre_of_gravity center_of_gravity com cog cm r_cm "
     "r_com",
     "body.centre_of_mass", kMass},

    // Start of the motion
    {"w w0 w_0 omega_magnitude omega_mag omega omega0 omega_0 Omega Omega0 angular_velocity angular_vel ang_vel "
     "angvel av w_body wb "
     "omega_b omega_B angular_speed rotation_rate rotational_velocity rotation_speed spin_vector spin_velocity "
     "body_rates gyro motion.spin rates angular_rates angular_rate body_rate ang_rate omega_vec omega_vector "
     "tumble tumble_rate rotation_vector initial_spin angular_velocities rotational_speed qvel",
     "motion.omega_body", "", kInBodyAxes},
    {"wx wy wz", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w_x w_y w_z", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w1 w2 w3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega_x omega_y omega_z", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omegax omegay omegaz", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega_1 omega_2 omega_3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"omega1 omega2 omega3", "motion.omega_body", "", kInBodyAxes, Carry::kList},
    {"w_WB w_W w_IB omega_WB omega_IB w_world w_space omega_world omega_W omega_inertial omega_lab",
     "motion.omega_space"},
    {"spin_rate spin_speed spin_frequency spinrate frequency rotation_frequency", "motion.spin",
     "spin_axis = \"largest\""},
    {"rotation_period spin_period period rotational_period period_of_rotation day_length T_rot P_rot",
     "motion.spin", "spin_axis = \"largest\"", "The rate of a spin is one turn per period.", Carry::kPeriod},
    {"rotation_axis spin_about omega_direction omega_dir omega_axis spin_direction direction axis_of_rotation "
     "about axis axis_of_spin main_axis",
     "motion.spin_axis", "spin = 10"},
    {"E T energy kinetic_energy rotational_energy KE Ekin E_kin E_rot T_rot rotational_kinetic_energy E0",
     "motion.energy", "L = 4.2", "With motion.L it gives the start."},
    {"P_precession precession_period wobble_period", "motion.P_phi", "P_psi = \"264 h\"; mode = \"SAM\""},
    {"rpm", "motion.spin", "spin_axis = \"largest\"", "", Carry::kValue, "rpm"},
    {"L L0 L_0 H H0 H_0 angular_momentum angular_momenta ang_mom angmom", "motion.L_body", "", kMomentum},
    {"Lx Ly Lz", "motion.L_body", "", kMomentum, Carry::kList},
    {"Hx Hy Hz", "motion.L_body", "", kMomentum, Carry::kList},
    {"L_world L_inertial H_space H_world H_inertial angular_momentum_space angular_momentum_world",
     "motion.L_space"},
    {"baseOrientation base_orientation quaternion_scalar_last", "motion.orientation", "",
     "The order is w, x, y, z; that of PyBullet is x, y, z, w.", Carry::kXyzw},
    {"qw qx qy qz", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q_w q_x q_y q_z", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q0 q1 q2 q3", "motion.orientation", "", kScalarFirst, Carry::kList},
    {"q q0 q_0 quat quat0 quaternion attitude attitude0 pose orientation attitude_quaternion "
     "orientation_quaternion",
     "motion.orientation", "", kScalarFirst},
    {"quat_xyzw q_xyzw quaternion_xyzw", "motion.orientation", "", kScalarFirst, Carry::kXyzw},
    {"rotation_matrix R0 dcm DCM rotation attitude_matrix axis_angle axisangle", "motion.orientation", "",
     kScalarFirst, Carry::kNothing},
    {"integrator solver method tol rtol atol accuracy", "motion.tolerance", "", kNoSteps, Carry::kNothing},

    // Forces
    {"M", "motion.torque.body", "",
     "In Landau and Lifshitz, M is the angular momentum: motion.L_body takes it, and starts the motion."},
    {"torque torques tau tau_body moment external_torque applied_torque torque_body", "motion.torque.body"},
    {"torque_space torque_world tau_space space_torque world_torque torque_inertial", "motion.torque.space"},
    {"Mx My Mz", "motion.torque.body", "", "", Carry::kList},
    {"Tx Ty Tz", "motion.torque.body", "", "", Carry::kList},
    {"Nx Ny Nz", "motion.torque.body", "", "", Carry::kList},
    {"tx ty tz", "motion.torque.body", "", "", Carry::kList},
    {"M1 M2 M3", "motion.torque.body", "", "", Carry::kList},
    {"N1 N2 N3", "motion.torque.body", "", "", Carry::kList},
    {"tau_x tau_y tau_z", "motion.torque.body", "", "", Carry::kList},
    {"torque_x torque_y torque_z", "motion.torque.body", "", "", Carry::kList},
    {"motion.torque.x motion.torque.y motion.torque.z", "motion.torque.body", "", "", Carry::kList},
    {"motion.torque.value motion.torque.vector motion.torque.constant motion.torque.torque "
     "motion.torque.components",
     "motion.torque.body"},
    {"motion.torque.frame motion.torque.axes motion.torque.type motion.torque.kind motion.torque.axis", "", "",
     "motion.torque.body is along the body's axes, motion.torque.space along the world's.", Carry::kRemove},
    {"gravity g grav g0 gravitational_acceleration acceleration_of_gravity gravity_acceleration",
     "motion.gravity.g", "", "It acts on a body that has body.mass and body.pivot."},
    {"mgr mgl mgh MgR Mgl mgr_body", "motion.gravity.mgr_body"},
    {"drag damping angular_damping rotational_damping damping_rate drag_rate angular_drag air_drag decay_rate "
     "rotational_drag spin_decay motion.drag.angular motion.drag.value motion.drag.strength",
     "motion.drag.rate", "", kDragRate},
    {"friction friction_coefficient viscosity viscous_friction damping_coefficient drag_coefficient "
     "motion.drag.coefficient motion.drag.c air_resistance drag_torque friction_torque rolling_friction "
     "sliding_friction mu",
     "motion.drag.rate", "", kDragRate, Carry::kNothing},
    {"motion.dissipation.tau motion.dissipation.time motion.dissipation.time_constant "
     "motion.dissipation.time_scale motion.dissipation.timescale motion.dissipation.decay_time",
     "motion.dissipation.alpha", "", kTimeConstant, Carry::kNothing},
    {"energy_dissipation energy_damping dissipation alpha energy_loss internal_friction internal_damping "
     "dissipation_rate energy_dissipation_rate "
     "energy_loss_rate internal_dissipation internal_losses losses motion.dissipation.rate "
     "motion.dissipation.coefficient",
     "motion.dissipation.alpha", "", "It makes the body lose energy and keep L."},
    {"dE_dt dEdt power_loss power dissipated_power Edot motion.dissipation.power", "motion.dissipation.alpha", "",
     "It is a coefficient in s/(kg m^2), not a power: the power grows with the wobble.", Carry::kNothing},
    {"motion.dissipation.internal motion.dissipation.enabled motion.dissipation.type motion.gravity.enabled "
     "motion.drag.enabled motion.gravity.direction motion.gravity.up motion.drag.type motion.drag.model "
     "motion.torque.enabled motion.dissipation.model",
     "", "", "The table itself switches it on.", Carry::kRemove},
    {"speed launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"speed throw_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"speed elevation", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"launch_speed launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"launch_speed launch_elevation", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"throw_speed throw_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"throw_speed launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"initial_speed launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"velocity launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"v0 launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"v launch_angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"motion.flight.speed motion.flight.angle", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"motion.flight.speed motion.flight.elevation", "motion.flight.velocity", "", kLaunchAngle, Carry::kLaunch},
    {"launch_angle throw_angle launch_elevation motion.flight.angle motion.flight.elevation",
     "motion.flight.velocity", "", "A speed v at an angle a is [v cos(a), 0, v sin(a)].", Carry::kNothing},
    {"v v0 v_0 velocity linear_velocity vel initial_velocity throw_velocity launch_velocity v_cm vcm com_velocity "
     "translational_velocity toss_velocity",
     "motion.flight.velocity"},
    {"r0 r_0 x0 x_0 position pos initial_position launch_position start_position", "motion.flight.position"},
    {"throw_speed toss_speed launch_speed vertical_velocity vz v_z upward_velocity initial_speed",
     "motion.flight.velocity"},

    // Film
    {"duration time t_end tend tmax t_max end_time stop_time t_stop t_final tfinal tf t_f simulation_time "
     "sim_time total_time max_time runtime t1 T1 time.T film_length film_duration film_time film video_length "
     "video_duration "
     "movie_length movie_duration clip_length clip_duration animation_length animation_duration playback_time "
     "screen_time length_of_film time.length time.seconds time.film_seconds",
     "time.duration"},
    {"tspan t_span time_span time_interval time_range interval_of_time t_range tlim", "time.duration", "", "",
     Carry::kSpan},
    {"time.span time.motion time.motion_time time.motion_duration time.motion_span time.real_time "
     "time.real_duration time.simulated time.simulated_time time.covers time.physical_time time.physical_duration "
     "time.simulation time.model_time",
     "time.speed", "", "", Carry::kFilm},
    {"time.stop time.end time.until time.to", "time.duration", "", "", Carry::kFilm},
    {"steps n_steps nsteps num_steps frames n_frames nframes num_frames frame_count n "
     "frame_end end_frame last_frame",
     "time.duration", "", "A film has duration times fps frames.", Carry::kFrames},
    {"frame_start start_frame first_frame", "", "",
     "A film begins at time.start, without a number of its first frame.", Carry::kRemove},
    {"output.orientation output.aspect output.aspect_ratio output.layout", "", "",
     "The format follows from output.size, such as [1080, 1920].", Carry::kRemove},
    {"fps framerate frame_rate frames_per_second", "time.fps"},
    {"frame_interval frame_time frame_duration ms_per_frame output.interval time.interval", "time.fps", "", "",
     Carry::kInterval, "ms"},
    {"dt time_step timestep step step_size", "time.fps", "", kNoSteps, Carry::kNothing},
    {"t0 t_0 t_start tstart start_time", "time.start"},
    {"slow_motion slowmo slow_mo slow_motion_factor slowdown slow_down slow_down_factor slowdown_factor "
     "time_stretch stretch slower slowness",
     "time.speed", "", "It is the motion's seconds per second of film: 0.1 is ten times slower.",
     Carry::kSlowness},
    {"time_scale timescale playback_speed speed_factor speedup speed_up real_time_factor realtime_factor "
     "time_factor playback_rate time_lapse timelapse time_warp time.rate time.factor time_acceleration "
     "playback_factor film_speed seconds_per_second fast_forward",
     "time.speed"},
    {"width height", "output.size", "", "", Carry::kList},
    {"height h", "body.height", "shape = \"cylinder\"; radius = 0.1; mass = 1"},
    {"h", "body.pivot", kMass,
     "This pivot is below the origin of the body axes, by the distance of the centre of mass from it.",
     Carry::kBelow},
    {"resolution size_px image_size window_size video_size output_size", "output.size"},
    {"figsize dpi", "output.size", "", "A size is in pixels.", Carry::kInches},
    {"dpi", "output.size", "", "", Carry::kNothing},
    {"output output.file output.filename output.path output.name output.output output.out output.video "
     "output.outfile "
     "output.save output.folder output.directory output.format output.container output.type output.extension "
     "output.writer output.gif output.mp4 output_file outfile filename file_name savefig save_as",
     "", "", "The command line names the file, and its ending the format: poinsot render scene.toml -o film.mp4.",
     Carry::kRemove},
    {"bitrate", "output.crf", "", "", Carry::kNothing},
    {"encoder vcodec video_codec", "output.codec"},
    {"output.preset output.resolution_preset output.profile", "output.quality"},
    {"antialiasing anti_aliasing samples msaa dpi_scale transparent threads workers backend renderer verbose "
     "loop_count repeat_delay title_page show_window interactive blit",
     "", "", "There is no such setting.", Carry::kRemove},

    // Picture
    {"camera_position camera_pos cam_pos eye eye_position camera_location camera.position camera.location "
     "camera.pos camera.from view.position",
     "camera.azimuth", "", "The camera looks at the body from this direction; its distance is automatic.",
     Carry::kPosition},
    {"azim camera.yaw camera.theta camera.longitude camera.heading camera.phi view_azimuth", "camera.azimuth", "",
     "", Carry::kValue, "deg"},
    {"azim camera.azimuth azimuth_range camera.azimuth_range camera.azimuths", "camera.orbit", "",
     "The camera turns steadily by camera.orbit during the film.", Carry::kOrbit},
    {"elev camera.pitch camera.height_angle camera.latitude view_elevation", "camera.elevation", "", "",
     Carry::kValue, "deg"},
    {"field_of_view fov_deg view_angle camera.angle camera.fovy camera.view_angle", "camera.fov", "", "",
     Carry::kValue, "deg"},
    {"camera.rotate camera.rotation camera.orbit_angle camera.turn camera.spin camera.sweep", "camera.orbit"},
    {"camera.orbiting camera.rotating camera.revolve", "camera.orbit", "", "", Carry::kNothing},
    {"camera.up camera.up_vector camera.roll camera.up_axis up_axis up", "", "", "The world's z axis is up.",
     Carry::kRemove},
    {"camera.near camera.far camera.clip camera.clipping camera.aspect camera.type_id", "", "",
     "The camera frames the motion by itself.", Carry::kRemove},
    {"camera.body_fixed camera.in_body camera.attached camera.corotating camera.body_frame camera.co_rotating",
     "camera.frame", "", "\"body\" stands still with the body, \"space\" with the world.", Carry::kFrame},
    {"camera.reference_frame camera.ref_frame camera.relative_to", "camera.frame"},
    {"camera.tracking camera.track camera.follow_body camera.follows", "camera.follow"},
    {"camera.type camera.mode camera.perspective_mode", "camera.projection"},
    {"camera.view camera.name camera.viewpoint camera.direction", "camera.preset"},
    {"camera_preset viewpoint", "camera.preset"},
    {"camera_distance camera.distance", "camera.zoom", "",
     "The distance is automatic, so that the motion fits into the picture.", Carry::kNothing},
    {"background background_color background_colour bg bg_color bgcolor facecolor clear_color "
     "world_color",
     "style.colors.paper"},
    {"body_color body_colour object_color mesh_color", "style.colors.body"},
    {"omega_color", "style.colors.omega"},
    {"L_color l_color", "style.colors.L"},
    {"text_color font_color foreground foreground_color", "style.colors.ink"},
    {"alpha transparency opaqueness", "show.ellipsoid.opacity", "", "", Carry::kValue, "", 1, true},
    {"alpha opacity transparency body_alpha body_opacity show.body.alpha show.body.opacity "
     "show.body.transparency",
     "", "", "The body is opaque, and has no key for this; show.ellipsoid.opacity is that of the ellipsoid.",
     Carry::kRemove},
    {"linestyle line_style ls marker markersize linewidth_px dashes cmap colormap grid legend tight_layout", "",
     "", "There is no such setting; style.line_width widens all lines.", Carry::kRemove},
    {"linewidth line_thickness lw stroke_width", "style.line_width", "", "It is a factor on all lines.",
     Carry::kNothing},
    {"font_size fontsize", "style.text_size", "", "", Carry::kNothing},
    {"dark_mode dark", "style.theme", "", "", Carry::kNothing},
    {"theme style.preset", "style.theme"},
    {"title name scene_name suptitle heading", "show.title"},
    {"look_at lookat target focus look center centre focal_point", "", "",
     "The camera always looks at the body; camera.azimuth and camera.elevation choose its direction.",
     Carry::kRemove},
    {"L_vector L_arrow angular_momentum_vector angular_momentum show.H show.momentum L_visible show_L draw_L",
     "show.L.visible"},
    {"omega_vector omega_arrow angular_velocity_vector angular_velocity w_vector show.w show.spin "
     "show.angular_velocity rotation_vector spin_axis omega_visible show_omega draw_omega",
     "show.omega.visible"},
    {"show.V show.velocity", "show.flight.velocity"},
    {"show.R show.position", "show.flight.position"},
    {"show.weight show.gravity", "show.flight.weight"},
    {"body_axes frame_axes axes body_frame show_axes draw_axes frame body_triad axis_triad",
     "show.principal_axes.visible"},
    {"world_axes inertial_axes lab_axes space_frame world_frame inertial_frame fixed_axes lab_frame",
     "show.space_axes.visible"},
    {"poinsot_ellipsoid inertia_ellipsoid energy_ellipsoid draw_ellipsoid momental_ellipsoid show_ellipsoid",
     "show.ellipsoid.visible"},
    {"invariable_plane draw_plane draw_invariable_plane show_plane tangent_plane rolling_plane",
     "show.plane.visible"},
    {"space_cone body_cone", "show.cones.visible", "", "", Carry::kEither},
    {"cone precession_cone show_cones rolling_cones poinsot_cones", "show.cones.visible"},
    {"trail trajectory path show_trail trace_axis axis_trace tip_trace locus tip_path show_trace",
     "show.trace.visible", "", "", Carry::kNothing},
    {"trail_length trace_length", "show.trace.visible", "", "", Carry::kNothing},
    {"ghost onion onion_skin stroboscope strobe motion_blur", "show.ghosts.visible", "", "", Carry::kNothing},
    {"show.vectors show.arrows show.draw show.things show.elements show.visible show.objects show.items "
     "show.overlays show.poinsot show.poinsot_construction show.construction draw overlays vectors arrows",
     "show.L.visible", "", "Each thing has a table of its own in [show].", Carry::kShown},
    {"show.plots show.plot show.graphs show.graph show.curves show.time_series plots graphs", "plot[].quantities",
     "", "", Carry::kPlot},
    {"plot[].y plot[].quantity plot[].variables plot[].variable plot[].data plot[].series plot[].curves "
     "plot[].ydata plot[].what plot[].keys plot[].signals plot[].channels plot[].of plot[].show plot[].values",
     "plot[].quantities"},
    {"plot[].ylim plot[].y_range plot[].yrange plot[].limits plot[].y_limits", "plot[].range"},
    {"plot[].xlim plot[].window plot[].x_range plot[].xrange plot[].t_window plot[].time_window plot[].xlabel "
     "plot[].ylabel plot[].legend plot[].color plot[].colors plot[].style plot[].linestyle plot[].position "
     "plot[].grid plot[].type plot[].kind plot[].size plot[].height plot[].width plot[].name plot[].label "
     "plot[].labels",
     "", "",
     "A plot covers the time of the film, and has its labels from its quantities; title, unit, range and at "
     "change it.",
     Carry::kRemove},
    {"readout[].value readout[].variable readout[].of readout[].what readout[].show", "readout[].quantity"},
    {"body.part[].position body.part[].pos body.part[].center body.part[].centre body.part[].location "
     "body.part[].translation body.part[].at body.part[].origin",
     "body.part[].offset"},
    {"body.part[].quat body.part[].quaternion body.part[].orientation", "body.part[].rotation"},
    {"body.point_mass[].pos body.point_mass[].r body.point_mass[].location body.point_mass[].offset "
     "body.point_mass[].at body.point_mass[].xyz",
     "body.point_mass[].position"},
    {"note[].content note[].string note[].label note[].message", "note[].text"},
    {"timeline[].t timeline[].time timeline[].when timeline[].start timeline[].from", "timeline[].at"},
    {"timeline[].text timeline[].title timeline[].label timeline[].message timeline[].subtitle",
     "timeline[].caption"},
    {"vector[].vector vector[].value vector[].direction vector[].xyz vector[].v", "vector[].components"},
    {"vector[].label vector[].title", "vector[].name"},
    {"vector[].c vector[].colour", "vector[].color", "",
     "It names a colour of [style.colors], where the colours themselves are.", Carry::kNothing},
    {"vector[].quantity vector[].of vector[].type vector[].what vector[].which vector[].kind vector[].variable "
     "vector[].show vector[].source",
     "vector[].components", "", "", Carry::kArrow},
    {"body.masses body.positions", "body.point_mass[].mass", "", "", Carry::kPoints},
    {"body.masses body.points", "body.point_mass[].mass", "", "", Carry::kPoints},
    {"body.m body.r body.point_masses", "body.point_mass[].mass", "", "", Carry::kPoints},
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
  const std::string pattern = patternOf(path), inTable = pathBelow(tableOf(pattern), snake);
  Rows rows = rowsOf(pattern);
  if (rows.empty() && inTable.find('.') != std::string::npos) rows = rowsOf(inTable);
  for (const std::string_view tried :
       {name, withoutInitial(name), std::string_view(snake), withoutInitial(snake)}) {
    if (tried != name && isTable(tried)) continue;  // [Body] is a misspelt table
    if (tried == pattern && !rows.empty()) break;
    Rows more = rowsOf(tried);
    if (tried.size() < snake.size() && tried != name)  // "initial" says something on physics or a camera alone
      std::erase_if(more, [](const ForeignNames* row) { return row->key.starts_with("show."); });
    if (!more.empty()) {
      rows.insert(rows.end(), more.begin(), more.end());
      break;
    }
  }
  return rows;
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
  const std::string top(topOf(table.substr(0, table.find('['))));
  if (row.own && !findKey(pathBelow(table, nameOf(row.key)))) return false;
  if (row.key.empty())
    return row.names.find('.') != std::string_view::npos || (top != "body" && top != "motion") ||
           row.names.starts_with("euler");
  if (isPhysics(table) || findKey(pathBelow(table, nameOf(row.key)))) return true;
  return !isPhysics(tableOf(row.key)) && table.find('[') == std::string_view::npos;
}

std::string keyFor(const ForeignNames& row, std::string_view path) {
  if (row.key.empty()) return "";
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

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/foreign_words.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/text.h"

namespace poinsot::scene {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

bool hasWord(std::string_view words, std::string_view word) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return !word.empty();
  }
  return false;
}

/// Returns the second word of the pair whose first words, separated by blanks, contain `word`.
template <std::size_t n>
std::string_view second(const std::array<Pair, n>& pairs, std::string_view word) {
  for (const auto& [words, meaning] : pairs)
    if (hasWord(words, word)) return meaning;
  return {};
}

// Shapes that this program has under another name, or a shape with nearly the same moments.
constexpr auto kWords = std::to_array<Pair>({
    {"cuboid brick block rectangular_box rectangular_prism prism parallelepiped rectangular_parallelepiped slab "
     "beam tile domino satellite spacecraft cubesat crate case bar",
     "box"},
    {"rectangle rectangular_plate sheet panel lamina", "plate"},
    {"ball solid_sphere globe planet", "sphere"},
    {"spheroid prolate oblate prolate_spheroid oblate_spheroid egg asteroid comet potato triaxial_ellipsoid "
     "rugby_ball",
     "ellipsoid"},
    {"shell spherical_shell hollow_sphere", "sphere_shell"},
    {"half_sphere dome", "hemisphere"},
    {"disk circle wheel flywheel rotor coin puck gyroscope gyro round_plate circular_plate", "disc"},
    {"ring annulus", "hoop"},
    {"donut doughnut toroid", "torus"},
    {"stick baton needle thin_rod line", "rod"},
    {"tube pipe pole can bottle rocket pencil barrel stage drum solid_cylinder circular_cylinder", "cylinder"},
    {"top spinning_top toy_top heavy_top", "cone"},
    {"pill capsule_shape", "capsule"},
    {"pyramid", "tetrahedron"},
    {"hammer mallet axe wrench spanner tee t_shape t_bar t_handle_bar thandle", "t_handle"},
    {"l_shape boomerang angle_bracket", "l_plate"},
    {"tennis_racket tennis_racquet racquet paddle", "racket"},
    {"wingnut butterfly_nut", "wing_nut"},
    {"stl obj ply cad", "mesh"},
    {"max maximum major maximal", "largest"},
    {"min minimum minor minimal", "smallest"},
    {"mid intermediate medium", "middle"},
    {"isometric_view iso", "isometric"},
    {"ortho parallel", "orthographic"},
    {"black night", "dark"},
    {"white day default", "light"},
    {"inertial world lab fixed global", "space"},
    {"rotating local corotating", "body"},
    {"h264 x264 avc", "h264"},
    {"h265 x265", "hevc"},
    {"long_axis", "LAM"},
    {"short_axis", "SAM"},
    {"long long_axis longest", "smallest"},
    {"short short_axis shortest", "largest"},
    {"symmetry symmetry_axis figure figure_axis axle", "3"},
    {"z +z vertical upward upwards", "up"},
    {"-z downward downwards", "down"},
    {"regular steady", "slow"},
    {"comma ,", "comma"},
    {"uhd 2160p ultra", "4k"},
    {"fullhd full_hd fhd hd high", "1080p"},
    {"low draft fast", "preview"},
    {"67p 67p_churyumov_gerasimenko churyumov_gerasimenko apophis oumuamua itokawa", "toutatis"},
    {"smartphone iphone mobile_phone", "phone"},
    {"american_football", "football"},
    {"flying_disc", "frisbee"},
});

constexpr auto kQuantities = std::to_array<Pair>({
    {"kinetic_energy ke ekin e_kin t_rot rotational_energy energy_kinetic kinetic", "T"},
    {"potential_energy pe epot e_pot u potential", "V"},
    {"energy total_energy etot e_tot e_total e", "E"},
    {"angular_velocity w omega_norm omega_mag omega_magnitude angular_speed speed spin_rate |omega|", "omega"},
    {"angular_momentum l l_norm l_mag l_magnitude h |l|", "L"},
    {"nutation nutation_angle tilt tilt_angle angle wobble lean", "theta"},
    {"precession precession_angle", "phi"},
    {"spin spin_angle", "psi"},
    {"precession_rate phi_dot phidot", "phi_rate"},
    {"psi_dot psidot", "psi_rate"},
    {"w1 wx w_1 w_x omega1 p", "omega_1"},
    {"w2 wy w_2 w_y omega2 q", "omega_2"},
    {"w3 wz w_3 w_z omega3 r", "omega_3"},
    {"l1 lx", "L_1"},
    {"l2 ly", "L_2"},
    {"l3 lz", "L_3"},
    {"time", "t"},
    {"qw q0", "q_w"},
    {"qx", "q_x"},
    {"qy", "q_y"},
    {"qz", "q_z"},
    {"x", "R_x"},
    {"y", "R_y"},
    {"z height altitude", "R_z"},
});

constexpr auto kColors = std::to_array<Pair>({
    {"white w", "#ffffff"},
    {"black k", "#000000"},
    {"gray grey", "#808080"},
    {"lightgray lightgrey light_gray light_grey silver", "#c0c0c0"},
    {"darkgray darkgrey dark_gray dark_grey", "#404040"},
    {"red r", "#ff0000"},
    {"green g", "#008000"},
    {"blue b", "#0000ff"},
    {"yellow y", "#ffff00"},
    {"orange", "#ffa500"},
    {"purple", "#800080"},
    {"cyan c aqua", "#00ffff"},
    {"magenta m fuchsia", "#ff00ff"},
    {"brown", "#a52a2a"},
    {"pink", "#ffc0cb"},
    {"gold", "#ffd700"},
    {"navy", "#000080"},
    {"teal", "#008080"},
    {"lime", "#00ff00"},
    {"beige", "#f5f5dc"},
    {"ivory", "#fffff0"},
    {"skyblue sky_blue lightblue light_blue", "#87ceeb"},
    {"steelblue steel_blue", "#4682b4"},
    {"crimson", "#dc143c"},
    {"violet", "#ee82ee"},
    {"c0 tab:blue", "#1f77b4"},
    {"c1 tab:orange", "#ff7f0e"},
    {"c2 tab:green", "#2ca02c"},
    {"c3 tab:red", "#d62728"},
    {"c4 tab:purple", "#9467bd"},
    {"c5 tab:brown", "#8c564b"},
    {"c6 tab:pink", "#e377c2"},
    {"c7 tab:gray", "#7f7f7f"},
    {"c8 tab:olive", "#bcbd22"},
    {"c9 tab:cyan", "#17becf"},
});

constexpr auto kWorlds = std::to_array<Pair>({
    {"earth terra standard normal default true on yes down -z z", "9.81"},
    {"moon luna lunar", "1.62"},
    {"mars", "3.71"},
    {"venus", "8.87"},
    {"mercury", "3.7"},
    {"jupiter", "24.8"},
    {"saturn", "10.4"},
    {"titan", "1.35"},
});

// Usual densities, rounded as in tables of materials.
constexpr auto kMaterials = std::to_array<Pair>({
    {"wood oak beech maple", "700"},
    {"pine spruce plywood", "500"},
    {"balsa", "150"},
    {"cork", "240"},
    {"water ice", "1000"},
    {"plastic abs pla acrylic nylon polymer", "1200"},
    {"rubber", "1100"},
    {"brick clay", "2000"},
    {"concrete", "2400"},
    {"glass", "2500"},
    {"rock stone granite", "2700"},
    {"aluminium aluminum alu", "2700"},
    {"titanium", "4500"},
    {"iron cast_iron", "7870"},
    {"steel stainless_steel", "7850"},
    {"brass bronze", "8500"},
    {"copper", "8960"},
    {"silver", "10500"},
    {"lead", "11340"},
    {"tungsten gold", "19300"},
    {"carbon carbon_fibre carbon_fiber cfrp", "1600"},
    {"paper cardboard", "800"},
});

}  // namespace

std::string plainWord(std::string_view text) {
  std::string word = core::lowered(core::trimmed(text));
  std::ranges::replace(word, '-', '_');
  std::ranges::replace(word, ' ', '_');
  return word;
}

std::string_view wordElsewhere(std::string_view word) { return second(kWords, word); }

std::vector<std::string_view> wordsElsewhere(std::string_view word) {
  std::vector<std::string_view> meanings;
  for (const auto& [words, meaning] : kWords)
    if (hasWord(words, word)) meanings.push_back(meaning);
  return meanings;
}

std::string_view quantityElsewhere(std::string_view word) { return second(kQuantities, word); }
std::string_view namedColor(std::string_view name) { return second(kColors, name); }
std::string_view gravityOn(std::string_view world) { return second(kWorlds, world); }
std::string_view densityOf(std::string_view material) { return second(kMaterials, material); }

}  // namespace poinsot::scene

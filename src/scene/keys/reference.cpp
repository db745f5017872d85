// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/reference.h"

#include <fmt/format.h>

#include "physics/catalogue.h"
#include "scene/keys/key_text.h"
#include "scene/keys/keys.h"
#include "scene/keys/start_ways.h"
#include "scene/limits.h"
#include "scene/shapes.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kOpening = R"(# Scene files

<!-- Made from the table in src/scene/keys/key_table*.cpp; a test compares the two. Do not edit by hand. -->

A scene is a [TOML](https://toml.io/en/v1.0.0) file that describes a body, its motion and a film of it. Only the body and
the start of its motion are required. Every other key is optional. This is a complete scene:

```toml
schema = 1
[body]
principal_moments = [1.0, 2.0, 2.5]
[motion]
omega_body = [0.01, 3.0, 0.0]
```

`poinsot check scene.toml` reports every error in the file `scene.toml`, with the line and the column of each error. The
command also prints a note for each likely mistake:

- an angle that is a whole number without a unit, because such an angle is in radians
- an angular velocity such as 90 or 360 without a unit, because such a number is in rad/s
- lengths in metres, or a mass in kilograms, that give a density that no material has
- a `hold` (a standstill) that would last beyond the film's end
- a caption that a later caption hides
- a film that shows less than a tenth of a turn of a heavy top's precession
- a force that begins after the film's end, or ends before the start

To override a key of a scene, add the option `-D key.path=value` to any command that takes a scene. For example,
`-D time.duration=5 -D style.theme=dark` overrides two keys. poinsot checks such a value like a value in the file.

In an array of tables, `-D` counts the tables from 0. For example, `-D 'body.part[0].mass=2'` overrides the mass of the
first `[[body.part]]`.

`poinsot explain camera.fov` prints what the tables below contain for the key `camera.fov`. You can give the name of any
other key instead.

`poinsot schema` prints a JSON Schema of scene files. A text editor can use this schema to check a scene while you write
it.

)";

constexpr std::string_view kUnitsOpening = R"(## Numbers and units

In a scene, a bare number (without a unit) is in SI units: metres, kilograms, seconds, radians, and products of these. To
use another unit, write the number and its unit as text in quotes. Examples are `"3 rpm"`, `"15 deg"`, `"306 d"`, `"20 cm"`,
`"2.5e4 g cm^2"` and `"0.2 slug-ft2"`.

This section has two tables of units. The first table lists usual units for each physical quantity. The second table lists
the names of units. A unit can be any product of powers of these names, such as `"3 deg/min"`, `"1 kg*cm^2"` or
`"2 1/min"`.

If a key takes a plain number, which has no unit, you can write the number as a percentage, such as `"13 %"`.

The units `Hz` and `rps` both mean turns per second: 1 `Hz` is one turn per second, and so is 1 `rps`.

`poinsot explain units` prints both tables of units. `poinsot explain slug` prints the value of one unit, the slug.

| quantity | SI | units, for example |
| --- | --- | --- |
)";

constexpr std::string_view kNamesOpening = R"(
The table below lists all names of units that a product can contain.

{}

| unit | is | with a prefix | also written |
| --- | --- | --- | --- |
)";

constexpr std::string_view kNamesClosing = R"(
The inch, the foot, the pound and the ounce have the exact values of the international agreement of 1959. The unit `lbf` is
the force lb times 9.80665 m/s². The unit `slug` is lbf s²/ft, so 1 slug ft² is 1.3558179483314004 kg m². The unit `u` has
the value of CODATA 2022. The unit `yr`, a year, has 365.25 days.

)";

// Escapes the character |, which would end the cell of a Markdown table.
std::string cell(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
  return escaped;
}

std::string code(std::string_view text) { return text.empty() ? "" : fmt::format("`{}`", text); }

std::string units() {
  std::string text(kUnitsOpening);
  for (const Dimension dimension : dimensions())
    text += fmt::format("| {} | {} | {} |\n", quantityName(dimension), siUnit(dimension), usualUnits(dimension));
  text += fmt::format(fmt::runtime(kNamesOpening), unitRules());
  for (const UnitText& unit : unitTexts())
    text += fmt::format("| `{}` | {} | {} | {} |\n", unit.symbol, unit.value, unit.prefixed, unit.also);
  return text + std::string(kNamesClosing);
}

std::string defaultOf(const Key& key) {
  if (!key.fallback.empty()) return code(key.fallback);
  return "none";
}

/// Returns the type of a key without its words, because the column "range" lists the words.
std::string typeOf(const Key& key) {
  if (key.type == ValueType::kWord) return "a word";
  if (key.type == ValueType::kWords && key.wordList.empty()) return "an array of words";
  return typeText(key);
}

std::string row(const Key& key) {
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", nameOf(key.path), cell(typeOf(key)),
                     cell(rangeText(key)), defaultOf(key), code(key.example), cell(key.help));
}

constexpr std::string_view kViews =
    R"(Each table `[[view]]` in a scene adds one panel to the picture. All panels show the same instant of the motion. A scene
without `[[view]]` has one panel, or one panel for each entry of `camera.frames`.

A view takes every key of `[camera]` except `frames`. It also takes every key of `[show]` except `title`, `subtitle`,
`views`, `exaggerate_angles` and the keys of the body's shape. Write such a key below the line `[[view]]`: for example,
`camera.frame = "body"` or `show.plane = false`. If a view does not set a key, the key has the value that it has in the
scene's own `[camera]` or `[show]`.

)";

// {} is the table of the pairs.
constexpr const char* kStarts =
    R"(### Ways to start

A scene gives the rotation at motion time 0 in exactly one way, a row of the table below. It may give the attitude in one
way: lean, euler, roll_pitch_yaw or orientation. It may say more about a spin in one way: tilt, nutation, or `precession` as
a word. The table shows which ways combine.

{}
### Keys of `[motion]`

)";

std::string visibility(std::string_view table) {
  if (!isExtra(table)) return fmt::format("`{0} = false` is short for `{0}.visible = false`.\n\n", table);
  std::string text = fmt::format("`{0} = true` is short for `{0}.visible = true`.", table);
  if (namesBelow(table).size() > 1)
    text += fmt::format(" If a scene sets another key of `[{0}]` but not `visible`, `{0}.visible` is also true.",
                        table);
  return text + "\n\n";
}

std::string heading(std::string_view table) {
  std::string text = table.empty() ? "## At the top\n\n" : fmt::format("## `{}`\n\n", tableText(table));
  if (table == "view[]") text += kViews;
  if (table == "motion") text += fmt::format(fmt::runtime(kStarts), startWaysMarkdown());
  if (hasVisible(table)) text += visibility(table);
  return text + "| key | type | range | default | example | meaning |\n| --- | --- | --- | --- | --- | --- |\n";
}

std::string tableSections() {
  std::string text;
  std::string_view current = "(none)";
  for (const Key& key : keys()) {
    if (repeatsInView(key)) continue;
    if (tableOf(key.path) != current) {
      current = tableOf(key.path);
      text += (text.empty() ? "" : "\n") + heading(current);
    }
    text += row(key);
  }
  return text + "\n";
}

std::string shapes() {
  std::string text =
      "## Shapes\n\nThe table below gives the keys of each shape and how the shape lies in its own axes x, y "
      "and z. The keys\nare the same in `[body]`, `[[body.part]]` and `[show.body]`. The origin of the axes is "
      "the centre of mass of the\nshape unless the table gives another point.\n\n| shape | keys | is |\n| --- | "
      "--- | --- |\n";
  for (const NamedShape& shape : namedShapes())
    text += fmt::format("| `{}` | {} | {} |\n", shape.word, described(shape), cell(shape.help));
  return text + "\n";
}

std::string catalogueTable() {
  std::string text =
      "## Catalogue\n\nThe table below lists the real bodies that the key `body.catalogue` can name, with the "
      "source of their numbers.\nEach number of such a body is published, assumed, or computed from the body's "
      "other numbers.\n\n| `catalogue` | is | where its numbers are from |\n| --- | --- | --- |\n";
  for (const physics::CatalogueBody& body : physics::catalogue())
    text += fmt::format("| `{}` | {} | {} |\n", body.name, cell(body.title), cell(body.source));
  return text + "\n";
}

std::string quantitiesTable() {
  std::string text =
      "## quantities\n\n`[[plot]]` and `[[readout]]` can show these quantities.\n\n"
      "| name | is | unit |\n| --- | --- | --- |\n";
  for (const StateQuantity& q : stateQuantities())
    text += fmt::format("| `{}` | {} | {} |\n", q.name, cell(q.help), unitText(q.unit));
  return text + "\n";
}

std::string presets() {
  std::string text =
      "## Quality\n\nEach value of `output.quality` sets a size and a rate factor.\n\n| `quality` | `size` | "
      "`crf` |\n| --- | --- | --- |\n";
  for (const QualityPreset& preset : qualityPresets())
    text += fmt::format("| `{}` | {} x {} | {} |\n", preset.name, preset.width, preset.height, preset.crf);
  return text + "\n";
}

constexpr std::string_view kLimitsOpening = R"(## Limits

A scene may come from an untrusted source. poinsot therefore limits how much memory, disk space and time a scene can use.
If a scene exceeds a limit, poinsot refuses the scene before any work begins. The message contains the limit and the
requested amount.

To raise or lower a limit, give the option `--limit NAME=VALUE`, such as `--limit side=16384` or
`--limit output="200 GiB"`. A scene file itself cannot change a limit.

| limit | default | maximum | applies to |
| --- | --- | --- | --- |
)";

constexpr std::string_view kLimitsClosing = R"(
For the limit `memory`, poinsot estimates the memory that a run needs from the size of the picture, the film's encoder and
the meshes. The estimate is for one worker of the run. The option `-j` sets the number of workers.

If a run reaches the limit `output` or `seconds`, the run ends with exit code 2, like a run that is refused at the start.
The finished part of a film is kept, and a run with the option `--resume` can continue it.

The limits in this list are fixed, because values beyond them could not be seen in a picture or could not be computed:

- A side has at least {} pixels.
- A note has at most {} lines.
- One piece of mathematics has at most 2000 characters and 40 levels.
- A torque table has at most 100 000 lines.
- A picture has at most 8 by 8 panels.

Every number in a scene must be finite and lie in the range of its key. For these physical quantities, the ranges in SI
units are:

- moments from {:g} to {:g}, the largest at most {:g} times the smallest
- spins from {:g} to {:g}
- times up to {:g}
- torques up to {:g}

Within the ranges that a scene allows, L² and the energy of every body neither underflow nor overflow a `double` (a 64-bit
floating-point number). Therefore, poinsot can draw every scene that it accepts.

If a scene contains an unknown key or the same key twice, poinsot reports an error.

A scene contains only values of keys. It cannot contain code or expressions.

A scene can name other files, which contain meshes, torques or styles. These must be regular files in the scene's folder or
below it. poinsot expands nothing in a file name. Absolute paths, `..`, symbolic links, `~`, `$` and URLs are errors.

To allow files in another folder, give the option `--asset-root FOLDER`. poinsot searches this folder after the scene's own
folder. You can give the option more than once.
)";

std::string limits() {
  std::string text(kLimitsOpening);
  for (std::size_t i = 0; i < kLimitCount; ++i) {
    const auto limit = static_cast<Limit>(i);
    const LimitRow& row = rowOf(limit);
    text +=
        fmt::format("| `{}` | {} | {} | {} |\n", row.name, row.usual == 0 ? "none" : limitText(limit, row.usual),
                    limitText(limit, row.highest), row.help);
  }
  return text + fmt::format(fmt::runtime(kLimitsClosing), kLeastSide, kMostLines, kLeastMoment, kMostMoment,
                            kMostRatioOfMoments, kLeastSpin, kMostSpin, kMostInstant_s, kMostTorque);
}

}  // namespace

std::string referenceMarkdown() {
  return std::string(kOpening) + units() + tableSections() + shapes() + catalogueTable() + quantitiesTable() +
         presets() + limits();
}

}  // namespace poinsot::scene

// SPDX-License-Identifier: Apache-2.0
#include "scene/keys/reference.h"

#include <fmt/format.h>

#include "physics/catalogue.h"
#include "scene/keys/key_text.h"
#include "scene/keys/keys.h"
#include "scene/limits.h"
#include "scene/shapes.h"
#include "scene/state_quantity.h"

namespace poinsot::scene {
namespace {

constexpr std::string_view kOpening = R"(# Scene files

<!-- Made from the table in src/scene/keys/key_table*.cpp; a test compares the two. Do not edit by hand. -->

A scene is a [TOML](https://toml.io/en/v1.0.0) file. A body and a start are required; every other key is optional. This is
a complete scene:

```toml
schema = 1
[body]
principal_moments = [1.0, 2.0, 2.5]
[motion]
omega_body = [0.01, 3.0, 0.0]
```

`poinsot check scene.toml` reports every problem of a file with its line and column. `check` also notes likely mistakes:

- a whole number as an angle, because bare angles are in radians
- a `hold` beyond the film's end
- a film that shows less than a tenth of a turn of a heavy top's precession

To override a key, add `-D key.path=value` to any command that takes a scene: `-D time.duration=5 -D style.theme=dark`.
The value passes the same checks as in the file. In an array of tables, count the tables from 0:
`-D 'body.part[0].mass=2'`.

`poinsot explain camera.fov` prints the contents of the tables below for one key. `poinsot schema` prints a JSON Schema of
the format for editors.

)";

constexpr std::string_view kUnitsOpening = R"(## Numbers and units

A bare number is in SI units: metres, kilograms, seconds, radians, and products of these. To use another unit, write the
number and its unit as text: `"3 rpm"`, `"15 deg"`, `"306 d"`, `"20 cm"`, `"2.5e4 g cm^2"`, `"0.2 slug-ft2"`.

A unit can be any product of powers of the names in the second table: `"3 deg/min"`, `"1 kg*cm^2"`, `"2 1/min"`. A plain
number may be a percentage (`"13 %"`). One `Hz` is one turn per second, and so is one `rps`. `poinsot explain units` prints
both tables, and `poinsot explain slug` prints one unit.

| quantity | SI | units, for example |
| --- | --- | --- |
)";

constexpr std::string_view kNamesOpening = R"(
The table below lists all names that a product can contain. {}

| unit | is | with a prefix | also written |
| --- | --- | --- | --- |
)";

constexpr std::string_view kNamesClosing = R"(
Inch, foot, pound and ounce have their exact values of 1959. `lbf` is lb times 9.80665 m/s². `slug` is lbf s²/ft, so
1 slug ft² is 1.3558179483314004 kg m². `u` has the value of CODATA 2022. A year has 365.25 days.

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
    R"(Each `[[view]]` is a panel of the picture. All panels show the same instant. A scene without `[[view]]` has one panel, or
one for each of `camera.frames`.

A view takes every key of `[camera]` except `frames`. It also takes every key of `[show]` except `title`, `subtitle`,
`views`, `exaggerate_angles` and the shape of the body. Write these keys below `[[view]]`, such as `camera.frame = "body"`
or `show.plane = false`. A key that a view does not set has the scene's value.

)";

std::string visibility(std::string_view table) {
  if (!isExtra(table)) return fmt::format("`{0} = false` is short for `{0}.visible = false`.\n\n", table);
  const bool alone = namesBelow(table).size() == 1;
  return fmt::format("`{0} = true` is short for `{0}.visible = true`{1}.\n\n", table,
                     alone ? "" : ". Setting any other key of the table also shows it");
}

std::string heading(std::string_view table) {
  std::string text = table.empty() ? "## At the top\n\n" : fmt::format("## `{}`\n\n", tableText(table));
  if (table == "view[]") text += kViews;
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
      "## Shapes\n\nThe table gives the keys of each shape and its position in its axes. The keys are the same in "
      "`[body]`,\n`[[body.part]]` and `[show.body]`. The origin of a shape is its centre of mass unless the table "
      "gives another point.\n\n| shape | keys | is |\n| --- | --- | --- |\n";
  for (const NamedShape& shape : namedShapes())
    text += fmt::format("| `{}` | {} | {} |\n", shape.word, described(shape), cell(shape.help));
  return text + "\n";
}

std::string catalogueTable() {
  std::string text =
      "## Catalogue\n\nEach number of a body is published, assumed, or computed from the others.\n\n| `catalogue` "
      "| is | where its numbers are from |\n| --- | --- | --- |\n";
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

A scene may come from an untrusted source, so its use of resources is limited. If a scene exceeds a limit, poinsot refuses
it before any work begins. The message contains the limit and the requested amount. You can raise or lower a limit with
`--limit NAME=VALUE`, such as `--limit side=16384` or `--limit output="200 GiB"`. A scene cannot change a limit.

| limit | default | maximum | applies to |
| --- | --- | --- | --- |
)";

constexpr std::string_view kLimitsClosing = R"(
poinsot estimates `memory` from the size of the picture, the film's encoder and the meshes. The estimate is for one
worker; `-j` sets the number of workers.

A run that reaches `output` or `seconds` ends with exit code 2, like a run that is refused at the start. The finished part
of a film stays for `--resume`.

Other limits are fixed, because values beyond them could not be seen or computed:

- A side has at least {} pixels.
- A note has at most {} lines.
- One piece of mathematics has at most 2000 characters and 40 levels.
- A torque table has at most 100 000 lines.
- A picture has at most 8 by 8 panels.

Numbers must be finite and lie in the range of their key. In SI units, the ranges are:

- moments from {:g} to {:g}, the largest at most {:g} times the smallest
- spins from {:g} to {:g}
- times up to {:g}
- torques up to {:g}

Within these ranges, L² and the energy of every body neither underflow nor overflow a double. Therefore, every accepted
scene can be drawn.

Unknown and repeated keys are errors. A scene contains no code and no expressions.

The files that a scene names (meshes, torques, styles) must be regular files in the scene's folder or below it. poinsot
expands nothing in a file name. Absolute paths, `..`, symbolic links, `~`, `$` and URLs are errors. `--asset-root FOLDER`
allows another folder, which is searched after the scene's own folder. You can give this option more than once.
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

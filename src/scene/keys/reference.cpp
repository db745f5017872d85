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

A scene is a [TOML](https://toml.io/en/v1.0.0) file. A body and a start are required; every other key has a default.
This is a whole scene:

```toml
schema = 1
[body]
principal_moments = [1.0, 2.0, 2.5]
[motion]
omega_body = [0.01, 3.0, 0.0]
```

`poinsot check scene.toml` reports every problem of a file, with its line and column. `check` also notes likely slips:
a whole number as an angle (angles are in radians), a `hold` beyond the film's end, and a film that shows less than a
tenth of a turn of a heavy top's precession.

`-D key.path=value` after any command that takes a scene overrides a key, with the same checks:
`-D time.duration=5 -D style.theme=dark`; a table of an array is named by its number from 0: `-D 'body.part[0].mass=2'`.
`poinsot explain camera.fov` says the same of a key as the tables below, on a terminal. `poinsot schema` prints a JSON
Schema of the format for editors.

)";

constexpr std::string_view kUnitsOpening = R"(## Numbers and units

A bare number is in SI units: metres, kilograms, seconds, radians, and their products. Text gives a number another unit:
`"3 rpm"`, `"15 deg"`, `"306 d"`, `"20 cm"`, `"2.5e4 g cm^2"`, `"0.2 slug-ft2"`. Any product of powers of the names in
the second table is understood (`"3 deg/min"`, `"1 kg*cm^2"`, `"2 1/min"`). A plain number may be a percentage
(`"13 %"`). One `Hz`, or one `rps`, is one turn a second. `poinsot explain units` prints these tables, and `poinsot
explain slug` one unit.

| quantity | SI | units, for example |
| --- | --- | --- |
)";

constexpr std::string_view kNamesOpening = R"(
These are all names that a product may contain. {}

| unit | is | with a prefix | also written |
| --- | --- | --- | --- |
)";

constexpr std::string_view kNamesClosing = R"(
Inch, foot, pound and ounce are exact (1959); lbf is lb times 9.80665 m/s², and slug is lbf s²/ft, so that 1 slug ft² is
1.3558179483314004 kg m². `u` is that of CODATA 2022. A year has 365.25 days.

)";

// Escapes bars, which would end a cell of a table.
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

std::string row(const Key& key) {
  const std::string type = key.type == ValueType::kWord ? "a word" : typeText(key);
  return fmt::format("| `{}` | {} | {} | {} | {} | {} |\n", nameOf(key.path), cell(type), cell(rangeText(key)),
                     defaultOf(key), code(key.example), cell(key.help));
}

constexpr std::string_view kViews =
    R"(Each `[[view]]` is a panel of the picture, all at the same instant; without any there is one, or one for each of
`camera.frames`. A view takes every key of `[camera]` but `frames`, and every key of `[show]` but `title`, `subtitle`,
`exaggerate_angles` and the shape of the body, as `camera.frame = "body"` or `show.plane = false` below `[[view]]`;
without them, those of the scene count.

)";

std::string visibility(std::string_view table) {
  if (!isExtra(table)) return fmt::format("`{0} = false` is short for `{0}.visible = false`.\n\n", table);
  const bool alone = namesBelow(table).size() == 1;
  return fmt::format("`{0} = true` is short for `{0}.visible = true`{1}.\n\n", table,
                     alone ? "" : "; any other of its keys says so too");
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
      "## Shapes\n\nThe keys that each shape takes, in `[body]`, `[[body.part]]` and `[show.body]` alike, and how "
      "it lies\nin its axes; its origin is its centre of mass where nothing else is said.\n\n"
      "| shape | keys | is |\n| --- | --- | --- |\n";
  for (const NamedShape& shape : namedShapes())
    text += fmt::format("| `{}` | {} | {} |\n", shape.word, described(shape), cell(shape.help));
  return text + "\n";
}

std::string catalogueTable() {
  std::string text = "## Catalogue\n\n| `catalogue` | is | where its numbers are from |\n| --- | --- | --- |\n";
  for (const physics::CatalogueBody& body : physics::catalogue())
    text += fmt::format("| `{}` | {} | {} |\n", body.name, cell(body.title), cell(body.source));
  return text + "\n";
}

std::string quantitiesTable() {
  std::string text =
      "## quantities\n\nWhat `[[plot]]` and `[[readout]]` show.\n\n| name | is | unit |\n| --- | --- | --- |\n";
  for (const StateQuantity& q : stateQuantities())
    text += fmt::format("| `{}` | {} | {} |\n", q.name, cell(q.help), unitText(q.unit));
  return text + "\n";
}

std::string presets() {
  std::string text = "## Quality\n\n| `quality` | `size` | `crf` |\n| --- | --- | --- |\n";
  for (const QualityPreset& preset : qualityPresets())
    text += fmt::format("| `{}` | {} x {} | {} |\n", preset.name, preset.width, preset.height, preset.crf);
  return text + "\n";
}

constexpr std::string_view kLimitsOpening = R"(## Limits

A scene comes from anywhere, so what it may ask for is bounded; a limit is told with what was asked for, before any of it
is made. You raise a limit, or lower one, a scene never does: by `--limit NAME=VALUE` (`--limit side=16384
--limit output="200 GiB"`).

| limit | usually | at most | of |
| --- | --- | --- | --- |
)";

constexpr std::string_view kLimitsClosing = R"(
Memory is estimated from the size of the picture, the film's encoder and the meshes, for one worker; there are as many as
`-j` says. A run that reaches `output` or `seconds` ends with exit code 2, like one that is refused at once, and what is
complete of a film stays for `--resume`. These are fixed, since more would not be seen or could not be computed: sides of
{} pixels and more, {} lines of a note, 2000 characters and 40 levels in one piece of mathematics, 100 000 lines of a
torque table, 8 by 8 panels. Numbers are finite, and each has the range that its key says: moments from {:g} to {:g}, the
largest at most {:g} times the smallest, spins from {:g} to {:g}, times to {:g} and torques to {:g} in SI units. Within
these L² and the energy of every body neither under- nor overflow a double, so that what is accepted can be drawn.
Unknown and repeated keys are refused. A scene holds no code and no expressions.

The files that a scene names (meshes, torques, styles) are regular files in its own folder or below it: no absolute path,
no `..`, no symbolic link, no `~`, `$` or address, for nothing is expanded. `--asset-root FOLDER` allows another folder,
searched after the scene's own; it may be given more than once.
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

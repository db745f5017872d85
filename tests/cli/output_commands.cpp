// SPDX-License-Identifier: Apache-2.0
// Scenes, pictures and films have the names that OutputFiles (run_files_test.cpp) gives them.
#include "cli/output_commands.h"

#include <utility>

namespace poinsot {
namespace {

Output fixedName(std::string option, std::string value) {
  return {std::move(option), value, value, true, false, false};
}
Output beside(std::string file) { return {"", "", std::move(file), true, false, false}; }
Output inFolder(std::string option, const std::string& folder, const std::string& name) {
  return {std::move(option), folder, folder + "/" + name, true, false, false};
}
Output addedTo(std::string option, std::string value) {
  return {std::move(option), value, value, true, true, true};
}

const Words kScene{"s.toml", "look.toml"};

const std::vector<OutputCommand> kCommands{
    {"render",
     {"s.toml", "--quiet"},
     {fixedName("--output", "o.mp4"),
      beside("o.srt"),
      beside("o.vtt"),
      {"--manifest", "m.json"},
      {"--trace", "t.json"}},
     kScene},
    {"render",
     {"s.toml", "--quiet"},
     {{"--output", "f_{frame}.png", "f_1.png", true, false, false},
      {"--manifest", "m.json"},
      {"--trace", "t.json"}},
     kScene,
     {},
     0,
     "Sequence"},
    {"still", {"s.toml", "--quiet"}, {fixedName("--output", "o.png"), {"--trace", "t.json"}}, kScene},
    {"still",
     {"s.toml", "--quiet", "--width", "20mm", "--dpi", "100"},
     {fixedName("--output", "o.tex"), beside("o-unlabelled.png"), {"--trace", "t.json"}},
     kScene,
     {},
     0,
     "Figure"},
    {"sweep",
     {"s.toml", "--quiet", "-D", "time.start=0|1"},
     {fixedName("--output", "o.mp4"), {"--manifest", "m.json"}, {"--trace", "t.json"}},
     kScene},
    {"gallery",
     {"s.toml", "--quiet"},
     {inFolder("--output", "pictures", "s.png"), beside("pictures/contact_sheet.png")},
     kScene},
    {"submit", {"s.toml"}, {{"--output", "o.mp4", "o.mp4", false, false, false}}, kScene},
    {"assemble",
     {"film.mp4", "--keep", "--quiet"},
     {fixedName("--output", "o.mp4"), beside("o.srt"), beside("o.vtt")},
     {".film.mp4.poinsot/segment-000000000-000000001.mp4"},
     {"render", "s.toml", "-o", "film.mp4", "--shard", "1/1", "--quiet"}},
    {"trajectory", {"s.toml", "--at", "0"}, {fixedName("--output", "o.csv")}, kScene},
    {"new",
     {"--from", "football"},
     {{"NAME", "n.toml", "n.toml", false, false, false}, beside("poinsot.schema.json")},
     {"scenes/football.toml"}},
    {"diff",
     {"a.png", "b.png", "--mask", "mask.png", "--quiet"},
     {{"--map", "map.png"},
      {"--diff-image", "difference.png"},
      fixedName("--report", "r.html"),
      {"--junit", "j.xml"},
      addedTo("--markdown", "s.md")},
     {"a.png", "b.png", "mask.png"},
     {},
     1},
    {"diff",
     {"folder", "other", "--quiet"},
     {inFolder("--map", "maps", "a.png"),
      inFolder("--diff-image", "differences", "a.png"),
      fixedName("--report", "r.html"),
      {"--junit", "j.xml"},
      addedTo("--markdown", "s.md")},
     {"folder/a.png", "other/a.png"},
     {},
     1,
     "Folders"},
    {"diff",
     {"a.gif", "b.gif", "--quiet"},
     {fixedName("--curve", "c.csv"), fixedName("--report", "r.html")},
     {"a.gif", "b.gif"},
     {},
     1,
     "Films"},
    {"golden",
     {"golden.toml", "--quiet"},
     {inFolder("--output", "new", "s.png"),
      fixedName("--report", "r.html"),
      {"--junit", "j.xml"},
      fixedName("--outcome", "o.js"),
      addedTo("--markdown", "s.md")},
     {"golden.toml", "s.toml", "look.toml", "golden/s.png"},
     {},
     1},
    {"golden",
     {"golden.toml", "--update", "--quiet"},
     {inFolder("--output", "new", "s.png"), beside("golden/s.json")},
     {"golden.toml", "s.toml", "look.toml"},
     {},
     0,
     "Update"},
};

}  // namespace

const std::vector<OutputCommand>& outputCommands() { return kCommands; }

}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/console.h"
#include "cli/exit_code.h"
#include "core/error.h"
#include "scene/keys/explanation.h"
#include "suite/explanation.h"

namespace poinsot::cli {
namespace {

constexpr std::size_t kMargin = 2, kWidestName = 22;

std::string explanationText(const scene::Explanation& explanation) {
  std::string text = explanation.title + '\n';
  const std::string margin(kMargin, ' ');
  if (!explanation.help.empty()) text += margin + wrapped(explanation.help, kColumns, kMargin, kMargin) + '\n';
  std::size_t widest = 0;
  for (const auto& row : explanation.rows) widest = std::max(widest, std::min(row.name.size(), kWidestName));
  const std::size_t indent = kMargin + widest + 2;
  for (const auto& row : explanation.rows) {
    std::string name = fmt::format("{}{:<{}}  ", margin, row.name, widest);
    if (row.name.size() > kWidestName) name += '\n' + std::string(indent, ' ');
    text += name + wrapped(row.text, kColumns, indent, indent) + '\n';
  }
  return text;
}

/// Returns the explanations of a name as a key of scenes, of golden.toml, or of both. @throws core::Error(kUsage)
/// if neither has the name
std::vector<scene::Explanation> explanationsOf(const std::string& word) {
  std::vector<scene::Explanation> golden = suite::explainGolden(word);
  if (golden.empty()) return scene::explain(word, suite::goldenWords());
  std::vector<scene::Explanation> all = scene::explanationsOf(word);
  std::ranges::move(golden, std::back_inserter(all));
  return all;
}

/// Prints the explanations of all known names before it reports the unknown ones.
int explain(const std::vector<std::string>& words) {
  std::string text, unknown;
  for (const std::string& word : words) try {
      for (const scene::Explanation& explanation : explanationsOf(word))
        text += (text.empty() ? "" : "\n") + explanationText(explanation);
    } catch (const core::Error& error) {
      unknown += (unknown.empty() ? "" : "\n") + error.message();
    }
  writeOut(text);
  if (!unknown.empty()) throw core::usageError(unknown);
  return kDone;
}

}  // namespace

void addExplain(const Command& program) {
  auto words = std::make_shared<std::vector<std::string>>();
  const Command command = program.command(
      "explain", "explain a key of a scene or of a golden.toml: meaning, unit, range, default, example");
  command.option("NAME", *words,
                 "a key (camera.fov, or fov), a table (camera), a shape, a body of the catalogue, a quantity or a "
                 "unit; units for the list of all units; golden for a golden.toml, or one of its keys "
                 "(golden.rule.max, or max); without NAME, all tables");
  command.footer(
      "Examples:\n"
      "  poinsot explain camera\n"
      "  poinsot explain time.speed racket\n"
      "  poinsot explain units\n"
      "  poinsot explain golden golden.test.image");
  command.does({[words] { return explain(words->empty() ? std::vector<std::string>{""} : *words); }});
}

}  // namespace poinsot::cli

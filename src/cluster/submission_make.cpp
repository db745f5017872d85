// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"

extern "C" const char poinsot_make_header[], poinsot_make_header_end[];

namespace poinsot::cluster {
namespace {

/// Reports whether GNU make has no escape for a character in a file name.
bool isUnwritable(char c) {
  return static_cast<unsigned char>(c) < 0x20 || std::string_view("%;|\\\x7f").find(c) != std::string::npos;
}

std::string writtenForMake(char c) {
  if (c == '=') return "$(equals)";  // a bare = would make the line a variable assignment
  if (c == '$') return "$$";
  return std::string_view(" #:*?[").find(c) != std::string::npos ? std::string{'\\', c} : std::string(1, c);
}

/// Returns a file's name, escaped as a target or a prerequisite, and absolute so that make may run in any folder.
/// @throws core::Error(kUsage) if make cannot represent the name.
std::string makeName(const Submission& submission, const std::filesystem::path& file) {
  const std::string whole = (submission.folder / file).lexically_normal().string();
  std::string name;
  for (const char c : whole) {
    if (isUnwritable(c))
      throw core::usageError(fmt::format("{}: make cannot hold the '{}' of this name; choose another --engine",
                                         core::printable(whole), core::printable(std::string_view(&c, 1))));
    name += writtenForMake(c);
  }
  return name;
}

using Lines = std::vector<std::string>;

/// Returns the lines of placeLines() and then `lines`, as one bash command of a recipe that stops at the first
/// failure.
/// @param variables  assignments of bash variables from make's, each after "; "
std::string recipe(const Submission& submission, const std::string& variables, const Lines& lines) {
  Lines all = placeLines(submission);
  all.insert(all.end(), lines.begin(), lines.end());
  std::string text = "\tset -e" + variables;
  for (const std::string& line : all) {
    text += "; \\\n\t";
    for (const char c : line) text += c == '$' ? "$$" : std::string(1, c);
  }
  return text + "\n";
}

std::string header(const Submission& submission) {
  return filled({poinsot_make_header, poinsot_make_header_end},
                {{"what", whatText(submission, " of make, and then joined")},
                 {"jobs", std::to_string(std::max(2, 8 / submission.division.cpus))},
                 {"status", statusCommand(submission)}});
}

/// Returns the make variable with the marks: an empty file for each finished shard, named by its number.
std::string marks(const Submission& submission) {
  std::string text = "shards :=";
  for (int k = 1; k <= submission.division.shards; ++k)
    text += " \\\n  " + makeName(submission, tasksFolderOf(submission) / std::to_string(k));
  return text + "\n\n";
}

std::string shardRule(const Submission& submission) {
  std::string inputs;
  for (const std::filesystem::path& file : submission.inputs) inputs += " " + makeName(submission, file);
  const std::string folder = core::shellWord(tasksFolderOf(submission).string());
  // $(@F), the last part of the mark's name, would take a space for the end of the name.
  return "$(shards):" + inputs + "\n" +
         recipe(submission, "; shard=$(lastword $(subst /, ,$@))",
                {"mkdir -p -- " + folder, shardCommand(submission, "$shard"), "touch -- " + folder + "/$shard"});
}

/// Returns the rule that joins the shards. The rule removes the marks before joining: if joining fails, each task
/// checks again whether its segments exist, which takes a second. Marks are .SECONDARY, so that make does not miss
/// them while the film is newer than the scene; the rule therefore touches a film that was already complete.
/// Numbered pictures have no single file, so the mark "all" stands for them.
std::string joinRule(const Submission& submission) {
  const bool film = submission.output.kind == request::OutputKind::kFilm;
  const std::filesystem::path folder = tasksFolderOf(submission);
  const std::filesystem::path target = film ? submission.output.path : folder / "all";
  Lines lines{fmt::format("rm -f -- {}/{{1..{}}}", core::shellWord(folder.string()), submission.division.shards),
              joinCommand(submission), "touch -- " + core::shellWord(target.string())};
  if (film) lines.push_back("rmdir --ignore-fail-on-non-empty -- " + core::shellWord(folder.string()));
  const std::string name = makeName(submission, target);
  return ".PRECIOUS: " + name + "\n.SECONDARY: $(shards)\n\n" + name + ": $(shards)\n" +
         recipe(submission, "", lines) + "\n";
}

}  // namespace

std::string makeScript(const Submission& submission) {
  return header(submission) + marks(submission) + joinRule(submission) + shardRule(submission);
}

}  // namespace poinsot::cluster

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

/// Reports whether a character in a file name cannot be escaped for GNU make.
bool isUnwritable(char c) {
  return static_cast<unsigned char>(c) < 0x20 || std::string_view("%;|\\\x7f").find(c) != std::string::npos;
}

std::string writtenForMake(char c) {
  if (c == '=') return "$(equals)";  // a bare = would start a variable assignment
  if (c == '$') return "$$";
  return std::string_view(" #:*?[").find(c) != std::string::npos ? std::string{'\\', c} : std::string(1, c);
}

/// Returns a file's name, escaped for use as a target or prerequisite. The name is absolute, so that make may run
/// in any folder.
/// @throws core::Error(kUsage) if make cannot represent the name.
std::string makeName(const Submission& submission, const std::filesystem::path& file) {
  const std::string whole = (submission.folder / file).lexically_normal().string();
  std::string name;
  for (const char c : whole) {
    if (isUnwritable(c))
      throw core::usageError(fmt::format("{}: make cannot handle the '{}' in this name; choose another --engine",
                                         core::printable(whole), core::printable(std::string_view(&c, 1))));
    name += writtenForMake(c);
  }
  return name;
}

using Lines = std::vector<std::string>;

/// Returns the recipe of a make rule: one bash command that runs placeLines() and then `lines`, and stops at the
/// first failure.
/// @param variables  assignments that copy make variables to bash variables, each after "; "
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
                {{"what", whatText(submission, " of make, which then " + lastStep(submission))},
                 {"jobs", std::to_string(std::max(2, 8 / submission.division.cpus))},
                 {"status", statusCommand(submission)}});
}

/// Returns the make variable that lists the marks. A mark is an empty file for each finished shard, named by the
/// shard's number.
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
  // Not $(@F): in a path with spaces, make would split the mark's name there.
  return "$(shards):" + inputs + "\n" +
         recipe(submission, "; shard=$(lastword $(subst /, ,$@))",
                {"mkdir -p -- " + folder, shardCommand(submission, "$shard"), "touch -- " + folder + "/$shard"});
}

/// Returns the rule that joins the shards.
/// - The rule removes the marks before it joins. If joining fails, each task then checks again whether its
///   segments exist, which takes a second.
/// - The marks are .SECONDARY, so that make does not need them while the film is newer than the scene. The rule
///   therefore touches a film that is already complete.
/// - Numbered pictures are not a single file, so the mark "all" represents them.
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

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"

/// Text of slurm.sh.
/// - The script requeues a task by the number of the array and the index of the task. It does not use
///   $SLURM_JOB_ID: in one task of each array, this is the number of the array, and Slurm would requeue all tasks.
/// - The script counts failures in a file, because SLURM_RESTART_COUNT also counts requeues by Slurm itself, after
///   preemption or the loss of a node.
extern "C" const char poinsot_slurm_script[], poinsot_slurm_script_end[];

namespace poinsot::cluster {
namespace {

/// Returns a task's time limit in minutes: five plus twice the estimate, because CPUs differ. A task that needs
/// more time is requeued and continues, but a task that requests too much waits longer in the queue.
int limit_min(const Division& division) { return static_cast<int>(std::ceil(5 + 2 * division.task_s / 60)); }

/// Returns the time limit of the joining job in minutes. Joining copies the segments: measured, 0.1 s for 192
/// frames of 320x180, which is less than a hundredth of the time that the frames take.
int joinLimit_min(const Submission& submission) {
  const double render_s = static_cast<double>(submission.frames) * submission.division.frame_s;
  return static_cast<int>(std::ceil(5 + 0.01 * render_s / 60));
}

/// Returns the absolute path of the log folder. With a relative path, Slurm would replace % signs in the path of
/// the working folder.
/// @throws core::Error(kUsage) if the path has a backslash. Slurm would then not replace %A and %a, so that all
///   tasks would write the same log.
std::string saidFolder(const Submission& submission) {
  std::string folder = (submission.folder / tasksFolderOf(submission)).lexically_normal().string();
  if (folder.find('\\') != std::string::npos)
    throw core::usageError(fmt::format("{}: Slurm cannot handle the '\\' in this name; choose another output",
                                       core::printable(folder)));
  return folder;
}

/// Returns a job name such as "poinsot_film.mp4". Blanks and equals signs are replaced, because `sacct -c` splits
/// its records at them.
std::string jobName(const Submission& submission) {
  std::string name = "poinsot_" + submission.output.path.filename().string();
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f || c == '=') c = '_';
  return name;
}

/// Returns the body of the script's function `setup`. It is not empty, because bash rejects an empty function.
std::string setupText(const Submission& submission) {
  std::vector<std::string> lines;
  for (const std::string& command : submission.setup) lines.push_back(setupLine(command) + " || return");
  return "  " + (lines.empty() ? ":" : core::joined(lines, "\n  "));
}

}  // namespace

std::string slurmScript(const Submission& submission) {
  const Division& division = submission.division;
  return filled(
      {poinsot_slurm_script, poinsot_slurm_script_end},
      {{"what", whatText(submission, " of a Slurm job array; a job that waits for them " + lastStep(submission))},
       {"status", statusCommand(submission)},
       {"retries", std::to_string(submission.retries)},
       {"said", core::shellWord(saidFolder(submission))},
       {"folder", core::shellWord(submission.folder.string())},
       {"setup", setupText(submission)},
       {"program", core::shellWords(submission.program)},
       {"shard", shardCommand(submission, "$SLURM_ARRAY_TASK_ID")},
       {"left", leftCommand(submission)},
       {"join", joinCommand(submission)},
       {"joined", submission.assemble.empty() ? "checked" : "joined"},
       {"name", core::shellWord(jobName(submission))},
       {"cpus", std::to_string(division.cpus)},
       {"memory", std::to_string(division.memory)},
       {"minutes", std::to_string(limit_min(division))},
       {"join_minutes", std::to_string(joinLimit_min(submission))}});
}

}  // namespace poinsot::cluster

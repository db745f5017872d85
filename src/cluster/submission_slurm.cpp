// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>

#include "cluster/submission.h"
#include "cluster/submission_text.h"
#include "core/error.h"
#include "core/shell_word.h"
#include "core/text.h"

/// slurm.sh: a task's number within the array goes with the number of the whole: one task has that as
/// $SLURM_JOB_ID, and a requeue by it would be one of all tasks. Failures are counted in a file, since
/// SLURM_RESTART_COUNT also has the requeues of Slurm itself, by preemption or for a lost node.
extern "C" const char poinsot_slurm_script[], poinsot_slurm_script_end[];

namespace poinsot::cluster {
namespace {

/// Minutes a task may take: four times the estimate and ten, as CPUs differ and a limit ends a task.
int limit_min(const Division& division) { return static_cast<int>(std::ceil(10 + 4 * division.task_s / 60)); }

/// Absolute, as a % in the working folder would mean something to Slurm. A backslash anywhere switches the meaning
/// of all % off, and then each task's file would have the same name.
std::string saidFolder(const Submission& submission) {
  std::string folder = (submission.folder / tasksFolderOf(submission)).lexically_normal().string();
  if (folder.find('\\') != std::string::npos)
    throw core::usageError(fmt::format("{}: Slurm cannot hold the '\\' of this name; choose another output",
                                       core::printable(folder)));
  return folder;
}

/// Returns "poinsot_film.mp4", without blanks and equals signs: sacct -c splits its records there, and stops.
std::string jobName(const Submission& submission) {
  std::string name = "poinsot_" + submission.output.path.filename().string();
  for (char& c : name)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7f || c == '=') c = '_';
  return name;
}

}  // namespace

std::string slurmScript(const Submission& submission) {
  const Division& division = submission.division;
  return filled(
      {poinsot_slurm_script, poinsot_slurm_script_end},
      {{"what", whatText(submission, " of a Slurm job array; a job that waits for them joins what they made")},
       {"status", statusCommand(submission)},
       {"retries", std::to_string(submission.retries)},
       {"said", core::shellWord(saidFolder(submission))},
       {"place", placeText(submission)},
       {"shard", shardCommand(submission, "$SLURM_ARRAY_TASK_ID")},
       {"left", leftCommand(submission)},
       {"join", joinCommand(submission)},
       {"name", core::shellWord(jobName(submission))},
       {"cpus", std::to_string(division.cpus)},
       {"memory", std::to_string(division.memory)},
       {"minutes", std::to_string(limit_min(division))}});
}

}  // namespace poinsot::cluster

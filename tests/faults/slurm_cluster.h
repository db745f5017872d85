// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot::faults {

/// A Slurm of two nodes with two CPUs each, both on this machine: the real slurmctld and slurmd, on free ports of
/// the loopback interface, with nothing outside a folder of its own. Ends with this object.
class SlurmCluster {
 public:
  /// @throws std::runtime_error with what the daemons say if they do not come up in half a minute.
  SlurmCluster();
  ~SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;

  static bool isInstalled();

  /// What the commands of Slurm need in order to find it.
  std::vector<std::string> environment(const std::vector<std::string>& more = {}) const;

  /// Runs a command of Slurm, such as "squeue -h".
  ShellResult run(const std::string& command) const;

  /// Waits until a command of bash succeeds. False after so long.
  bool waitUntil(const std::string& command, double most_s) const;

  /// Waits until nothing is in the queue. False after so long.
  bool waitUntilEmpty(double most_s) const;

  /// How often each task of an array was put back into the queue, by its number from 1.
  std::vector<int> restarts(int tasks) const;

 private:
  void writeSettings() const;
  void start(const std::string& command);
  std::string logs() const;

  ScratchFolder folder_;
  std::vector<pid_t> daemons_;
};

}  // namespace poinsot::faults

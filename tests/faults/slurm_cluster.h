// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shell_run.h"

namespace poinsot::faults {

/// Slurm of two nodes with two CPUs each, both on this machine. The real slurmctld and slurmd listen on free ports
/// of the loopback interface and write only into a scratch folder. Ends with this object.
class SlurmCluster {
 public:
  /// @throws std::runtime_error with the daemons' output if they are not ready within half a minute
  SlurmCluster();
  ~SlurmCluster();
  SlurmCluster(const SlurmCluster&) = delete;

  static bool isInstalled();

  /// Returns the variables with which Slurm's commands find this cluster.
  std::vector<std::string> environment(const std::vector<std::string>& more = {}) const;

  ShellResult run(const std::string& command) const;

  /// Waits until a bash command succeeds. Returns false after `most_s` seconds.
  bool waitUntil(const std::string& command, double most_s) const;

  bool waitUntilEmpty(double most_s) const;

  /// Returns how often each task of an array was requeued, by its number from 1.
  std::vector<int> restarts(int tasks) const;

 private:
  void writeSettings() const;
  void start(const std::string& command);
  std::string logs() const;

  ScratchFolder folder_;
  std::vector<pid_t> daemons_;
};

}  // namespace poinsot::faults

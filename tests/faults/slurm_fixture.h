// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <memory>

#include "faults/slurm_cluster.h"
#include "faults/submitted_film.h"

namespace poinsot::faults {

/// Fixture with its own Slurm, and a film to render on it. Oracle of each film: the film that one local process
/// makes with render --reproducible.
class Slurm : public testing::Test {
 protected:
  void SetUp() override {
    if (!SlurmCluster::isInstalled()) GTEST_SKIP() << "slurmctld, slurmd and slurm-client are not installed";
    cluster_ = std::make_unique<SlurmCluster>();
  }

  std::string submit(const std::string& commands) {
    const ShellResult submitted = film_.shell(commands, cluster_->environment(film_.broken()));
    EXPECT_EQ(submitted.exitCode, 0) << submitted.out;
    return submitted.out;
  }

  void waitUntilItHangs() {
    ASSERT_TRUE(film_.waitUntilDied(30)) << said();
    ASSERT_TRUE(cluster_->waitUntil("[[ $(squeue -h -t RUNNING -o %K) == 2 ]]", 30))
        << cluster_->run("squeue").out;
  }

  void waitForTheEnd() {
    ASSERT_TRUE(cluster_->waitUntilEmpty(180)) << cluster_->run("squeue; scontrol show job").out;
  }

  void expectTheBytesOfALocalRun() { film_.expectTheBytesOfALocalRun(said()); }

  /// Returns the tasks' output, for messages of failed tests.
  std::string said() const { return film_.shell("tail -n +1 film.mp4.tasks/*").out; }

  SubmittedFilm film_;
  std::unique_ptr<SlurmCluster> cluster_;
};

}  // namespace poinsot::faults

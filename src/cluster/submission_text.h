// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "cluster/submission.h"

/// What the scripts of all engines have in common.
namespace poinsot::cluster {

/// The command that tells how far it is, to be run anywhere, with no poinsot on the PATH.
std::string statusCommand(const Submission& submission);

/// Comment lines: what is made, of how many parts, from which estimate.
std::string whatText(const Submission& submission, const std::string& how);

/// Lines of bash that go to the folder and say which program runs: $POINSOT if that is set.
std::vector<std::string> placeLines(const Submission& submission);

/// The same as text.
std::string placeText(const Submission& submission, const std::string& indent = "");

/// The command of a shard, without `shard`, which a shell expands.
std::string shardCommand(const Submission& submission, const std::string& shard);

/// The command that prints which shards have work left.
std::string leftCommand(const Submission& submission);

/// The command that joins them, unless the output is complete.
std::string joinCommand(const Submission& submission);

}  // namespace poinsot::cluster

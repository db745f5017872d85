// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cluster/submission.h"

/// What the scripts of all engines have in common.
namespace poinsot::cluster {

/// The script, with each value in the place of its @name@. Any other @ stays. @pre each value has its place.
std::string filled(std::string_view script, const std::map<std::string, std::string>& values);

/// The command that tells how far it is, to be run anywhere, with no poinsot on the PATH.
std::string statusCommand(const Submission& submission);

/// Comment lines: what is made, of how many parts, from which estimate.
std::string whatText(const Submission& submission, const std::string& how);

/// Lines of bash that go to the folder and say which program runs: $POINSOT if that is set.
std::vector<std::string> placeLines(const Submission& submission);

/// The same as text, without a line end after the last.
std::string placeText(const Submission& submission, const std::string& indent = "");

/// The command of a shard, without `shard`, which a shell expands.
std::string shardCommand(const Submission& submission, const std::string& shard);

/// The command that prints which shards have work left.
std::string leftCommand(const Submission& submission);

/// The command that joins them, unless the output is complete.
std::string joinCommand(const Submission& submission);

}  // namespace poinsot::cluster

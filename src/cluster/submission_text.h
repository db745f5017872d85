// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cluster/submission.h"

namespace poinsot::cluster {

/// Returns the script with each placeholder @name@ replaced by its value. Any other @ stays.
/// @pre the script has a placeholder for each value.
std::string filled(std::string_view script, const std::map<std::string, std::string>& values);

/// Returns the command that reports progress. It works in any folder, and without poinsot on the PATH.
std::string statusCommand(const Submission& submission);

/// Returns comment lines with the output's name, the numbers of frames, segments and tasks, and the estimated
/// time.
std::string whatText(const Submission& submission, const std::string& how);

/// Returns bash lines that change to the folder and set $poinsot to the program's path, which $POINSOT can
/// override.
std::vector<std::string> placeLines(const Submission& submission);

/// Returns placeLines() as one text without a final line break. Each line is indented by `indent`.
std::string placeText(const Submission& submission, const std::string& indent = "");

/// Returns the command that renders a shard.
/// @param shard  shell expression for the shard's number, such as "$1"
std::string shardCommand(const Submission& submission, const std::string& shard);

/// Returns the command that prints which shards are not finished. The command succeeds only if the output is
/// complete.
std::string leftCommand(const Submission& submission);

/// Returns the command that joins the shards if the output is not complete yet.
std::string joinCommand(const Submission& submission);

}  // namespace poinsot::cluster

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

/// Returns "45 s" or "10 min", rounded up.
std::string durationText(double seconds);

/// Returns the command that reports progress, without poinsot on the PATH. It works in any folder, except for a
/// series.
std::string statusCommand(const Submission& submission);

/// Returns comment lines with the output's name, the numbers of frames, segments and tasks, and the estimated
/// time.
std::string whatText(const Submission& submission, const std::string& how);

/// Returns what follows the tasks: "joins what they made", or for a series "checks that all films exist".
std::string lastStep(const Submission& submission);

/// Returns bash lines that change to the folder, run the user's own set-up lines, and set the array `poinsot` to
/// the words that start the program. $POINSOT, the path of a program, replaces these words.
std::vector<std::string> placeLines(const Submission& submission);

/// Returns a user's set-up command as one line. It has its own quotes, so that a comment or quote in it cannot
/// hide the words after it.
std::string setupLine(const std::string& command);

/// Returns placeLines() as one text without a final line break. Each line is indented by `indent`.
std::string placeText(const Submission& submission, const std::string& indent = "");

/// Text of a command that starts the program after placeLines().
inline constexpr const char* kPlacedProgram = "\"${poinsot[@]}\"";

/// Returns the command that renders a shard.
/// @param shard  shell expression for the shard's number, such as "$1"
std::string shardCommand(const Submission& submission, const std::string& shard,
                         const std::string& program = kPlacedProgram);

/// Returns the command that prints which shards are not finished. The command succeeds only if the output is
/// complete.
std::string leftCommand(const Submission& submission, const std::string& program = kPlacedProgram);

/// Returns the command that joins the shards if the output is not complete yet. For a series, the command only
/// checks that all films exist.
std::string joinCommand(const Submission& submission, const std::string& program = kPlacedProgram);

}  // namespace poinsot::cluster

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

/// Marks that show that this program wrote a figure, a page or a file of subtitles. Another run may replace a
/// marked file without the loss of anybody's work.
namespace poinsot::figure {

/// Returns the name and version of the program, "poinsot 0.1.0".
std::string creator();

/// Comment syntax around the mark in one kind of text file.
struct CommentMark {
  std::string_view before, after;
};
inline constexpr CommentMark kSvgMark{"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- ", " -->\n"};
inline constexpr CommentMark kHtmlMark{"<!DOCTYPE html>\n<!-- ", " -->\n"};
inline constexpr CommentMark kTexMark{"% ", "\n"};
inline constexpr CommentMark kVttMark{"WEBVTT\n\nNOTE ", "\n\n"};

/// Returns `rest` after a comment "poinsot 0.1.0 HASH". The hash of `rest` detects edits: people edit SVG and
/// LaTeX, and this program must not replace an edited file.
std::string marked(const CommentMark& mark, std::string_view rest);

/// Returns the text after the mark; nullopt if the file has no such mark, has been edited, or cannot be read.
std::optional<std::string> markedRest(const std::filesystem::path& file, const CommentMark& mark);

/// Returns whether the file is a PDF, SVG or TeX file that this program wrote and, for SVG and TeX, nobody edited.
/// Returns false if the file cannot be read; never throws for content.
bool isOwnFigure(const std::filesystem::path& path);

}  // namespace poinsot::figure

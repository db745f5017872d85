// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

/// Marks in the figures, pages and subtitles that this program writes. The program may replace a file with an
/// intact mark, because nobody's work is lost.
namespace poinsot::figure {

/// Returns the name and version of the program, such as "poinsot 0.1.0".
std::string creator();

/// Characters before and after the mark, which make it a comment in one kind of text file.
struct CommentMark {
  std::string_view before, after;
};
inline constexpr CommentMark kSvgMark{"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- ", " -->\n"};
inline constexpr CommentMark kHtmlMark{"<!DOCTYPE html>\n<!-- ", " -->\n"};
inline constexpr CommentMark kTexMark{"% ", "\n"};
inline constexpr CommentMark kVttMark{"WEBVTT\n\nNOTE ", "\n\n"};

/// Returns `rest` after a comment "poinsot 0.1.0 HASH". HASH is the hash of `rest`, and shows later whether the
/// file was edited. This program must not replace an edited SVG or LaTeX file.
std::string marked(const CommentMark& mark, std::string_view rest);

/// Returns the text after the mark. Returns nullopt if the file has no mark, was edited, or cannot be read.
std::optional<std::string> markedRest(const std::filesystem::path& file, const CommentMark& mark);

/// Returns whether this program wrote the file, a PDF, SVG or TeX file. An SVG or TeX file must also be unedited.
/// Returns false if the file cannot be read. Never throws because of the file's content.
bool isOwnFigure(const std::filesystem::path& path);

}  // namespace poinsot::figure

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/abi.h"

/// How a figure, a page or a file of subtitles says that this program wrote it, so that another run may replace it
/// and nothing else is lost.
namespace poinsot::figure {

/// "poinsot 0.1.0".
std::string creator();

/// The comment that the mark of a kind of text stands in.
struct CommentMark {
  std::string_view before, after;
};
inline constexpr CommentMark kSvgMark{"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- ", " -->\n"};
inline constexpr CommentMark kHtmlMark{"<!DOCTYPE html>\n<!-- ", " -->\n"};
inline constexpr CommentMark kTexMark{"% ", "\n"};
inline constexpr CommentMark kVttMark{"WEBVTT\n\nNOTE ", "\n\n"};

/// `rest` behind a comment that says "poinsot 0.1.0 HASH". The hash is of `rest`: people edit SVG and LaTeX, and
/// what they edited is theirs.
std::string marked(const CommentMark& mark, std::string_view rest);

/// Returns the text behind the mark; nothing where there is no such mark, the text was changed, or the file cannot
/// be read.
std::optional<std::string> markedRest(const std::filesystem::path& file, const CommentMark& mark);

/// Whether the file is a PDF, SVG or TeX file that this program wrote and, of those that are text, nobody changed.
/// False for a file that cannot be read; never throws for content.
bool isOwnFigure(const std::filesystem::path& path);

}  // namespace poinsot::figure

// SPDX-License-Identifier: Apache-2.0
#include "figure/mark.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

#include "core/error.h"
#include "core/regular_file.h"
#include "core/version.h"

namespace poinsot::figure {
namespace {

constexpr std::string_view kProgram = "poinsot ";
/// Largest file that is read. An SVG with an uncompressed image of 8192x8192 pixels in base 64 is smaller.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;

// Returns the FNV-1a hash of 64 bits. It detects that a file was edited, but not a deliberate forgery.
// Source: Fowler, Noll, Vo, Eastlake, "The FNV Non-Cryptographic Hash Algorithm", IETF draft, section 5.
std::uint64_t hashOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::string hashText(std::string_view rest) { return fmt::format("{:016x}", hashOf(rest)); }

std::optional<std::string_view> restOf(std::string_view text, const CommentMark& mark) {
  if (!text.starts_with(mark.before)) return std::nullopt;
  text.remove_prefix(mark.before.size());
  const auto end = text.find(mark.after);
  if (end == text.npos || !text.starts_with(kProgram)) return std::nullopt;
  const std::string_view rest = text.substr(end + mark.after.size());
  return text.substr(0, end).ends_with(" " + hashText(rest)) ? std::optional(rest) : std::nullopt;
}

std::string_view objectOf(std::string_view pdf, int number) {
  const auto begin = pdf.rfind(fmt::format("\n{} 0 obj", number));
  if (begin == pdf.npos) return {};
  return pdf.substr(begin, pdf.find("endobj", begin) - begin);
}

/// Returns whether this program wrote the PDF. Only the last /Info entry counts: a document of another program may
/// include one of our figures, with the figure's metadata.
bool isOwnPdf(std::string_view pdf) {
  constexpr std::string_view kInfo = "/Info ";
  const auto at = pdf.rfind(kInfo);
  if (!pdf.starts_with("%PDF-") || at == pdf.npos) return false;
  int number = -1;
  std::from_chars(pdf.data() + at + kInfo.size(), pdf.data() + pdf.size(), number);
  return objectOf(pdf, number).find("/Creator (" + std::string(kProgram)) != std::string_view::npos;
}

}  // namespace

std::string creator() { return std::string(kProgram) + std::string(core::version()); }

std::string marked(const CommentMark& mark, std::string_view rest) {
  return fmt::format("{}{} {}{}{}", mark.before, creator(), hashText(rest), mark.after, rest);
}

std::optional<std::string> markedRest(const std::filesystem::path& file, const CommentMark& mark) try {
  const std::string text = core::readRegularFile(file, kMostBytes, core::ErrorKind::kIo);
  const auto rest = restOf(text, mark);
  return rest ? std::optional(std::string(*rest)) : std::nullopt;
} catch (const core::Error&) {
  return std::nullopt;
}

bool isOwnFigure(const std::filesystem::path& path) try {
  const std::string text = core::readRegularFile(path, kMostBytes, core::ErrorKind::kIo);
  return isOwnPdf(text) || restOf(text, kSvgMark) || restOf(text, kTexMark);
} catch (const core::Error&) {
  return false;
}

}  // namespace poinsot::figure

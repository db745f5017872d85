// SPDX-License-Identifier: Apache-2.0
#include "cli/console.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <string>

#include "core/error.h"
#include "core/text.h"
#include "process/line_channel.h"

namespace poinsot::cli {

namespace {

bool isSet(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

}  // namespace

void openStandardStreams() {
  // Opens /dev/null for all closed descriptors, because open() returns the lowest free number. Opens it for
  // reading only, so that writing to a closed stream is still an error.
  int fd = 0;
  do fd = open("/dev/null", O_RDONLY);
  while (fd >= 0 && fd <= STDERR_FILENO);
  if (fd > STDERR_FILENO) close(fd);
}

void writeOut(std::string_view text) {
  const int status = process::writeText(STDOUT_FILENO, core::printableLines(text));
  if (status == EPIPE) throw core::BrokenPipe();
  if (status != 0) throw core::ioError(fmt::format("standard output: {}", core::systemReason(status)));
}

void writeErr(std::string_view text) { process::writeText(STDERR_FILENO, core::printableLines(text)); }

void writeControl(std::string_view text) { process::writeText(STDERR_FILENO, text); }

void writeError(std::string_view message) {
  const bool red = errIsTerminal() && !isSet("NO_COLOR");
  writeControl(
      fmt::format("poinsot: {} {}\n", red ? "\x1b[1;31merror:\x1b[0m" : "error:", core::printableLines(message)));
}

void writeOutOfMemory() noexcept { process::writeText(STDERR_FILENO, "poinsot: error: out of memory\n"); }

bool errIsTerminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) && kind && std::string_view(kind) != "dumb";
}

int errColumns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

namespace {

std::size_t length(std::string_view word) {
  return static_cast<std::size_t>(
      std::ranges::count_if(word, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

}  // namespace

std::string wrapped(std::string_view paragraph, std::size_t width, std::size_t indent, std::size_t column) {
  std::string text;
  bool begun = false;  // whether the current line has a word
  for (std::size_t from = 0; from < paragraph.size();) {
    const std::size_t to = std::min(paragraph.find_first_of(" \n", from), paragraph.size());
    const std::string_view word = paragraph.substr(from, to - from);
    const bool newLine = from > 0 && paragraph[from - 1] == '\n';
    if (newLine || (begun && column + 1 + length(word) > width)) {
      text += '\n' + std::string(indent, ' ');
      column = indent;
    } else if (begun) {
      text += ' ';
      ++column;
    }
    text += word;
    column += length(word);
    begun = true;
    from = to + 1;
  }
  return text;
}

}  // namespace poinsot::cli

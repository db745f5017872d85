// SPDX-License-Identifier: Apache-2.0
#include "output/film_seal.h"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <functional>
#include <optional>

#include "core/file_error.h"
#include "core/regular_file.h"
#include "core/text.h"
#include "output/animation_text.h"

namespace poinsot::output {
namespace {

constexpr std::string_view kWord = "film sha256 ";
constexpr std::size_t kDigits = 2 * sizeof(core::Digest);

/// Returns the bytes of the file that depend on the digest: the text that contains the digest. In an animation,
/// this is the complete block or chunk of the text, because a chunk has a checksum.
std::string sealBytes(FileFormat format, const std::string& origin, const core::Digest& digest) {
  const std::string text = sealText(origin, digest);
  return isAnimation(format) ? animationText(format, text) : text;
}

/// Callback that receives the bytes that were read. `last` is true at the end of the file.
/// @returns the number of bytes, counted from the first, that need not be passed again.
using Listener = std::function<std::size_t(std::string& window, bool last)>;

/// Reads a regular file from its start, in blocks. Bytes that the listener still needs are passed again, together
/// with the next block.
/// @throws core::Error(kIo) with the path.
void readThrough(int descriptor, const std::filesystem::path& file, const Listener& listen) {
  constexpr std::size_t kBlock = 64 << 10;
  const auto expect = [&](bool good) {
    const int code = errno;
    if (!good)
      throw core::FileError(
          core::ErrorKind::kIo,
          fmt::format("{}: cannot be read: {}", core::printable(file.native()), core::systemReason(code)), file,
          code);
  };
  struct stat status {};
  expect(::fstat(descriptor, &status) == 0);
  errno = EINVAL;
  expect(S_ISREG(status.st_mode));  // a device may never end
  std::string window, block(kBlock, '\0');
  for (off_t offset = 0;;) {
    const ssize_t count = ::pread(descriptor, block.data(), block.size(), offset);
    if (count < 0 && errno == EINTR) continue;
    expect(count >= 0);
    offset += count;
    window.append(block, 0, static_cast<std::size_t>(count));
    window.erase(0, listen(window, count == 0));
    if (count == 0) return;
  }
}

/// Seal that was found in a file. `digest` is the file's digest, computed with zeros in place of the seal's
/// digits.
struct FoundSeal {
  std::int64_t offset = 0;
  std::string bytes;
  core::Digest digest{};
};

std::optional<FoundSeal> findSeal(int descriptor, const std::filesystem::path& film, FileFormat format,
                                  const std::string& origin) {
  core::Digest other;
  other.fill(0xff);
  const std::string blank = sealBytes(format, origin, {}), filled = sealBytes(format, origin, other);
  const std::string start(blank.begin(), std::ranges::mismatch(blank, filled).in1);
  core::Sha256 sum;
  std::optional<FoundSeal> seal;
  std::int64_t offset = 0;
  readThrough(descriptor, film, [&](std::string& window, bool last) {
    const std::size_t at = seal ? window.npos : window.find(start);
    if (at != window.npos && at + blank.size() <= window.size()) {
      seal = FoundSeal{offset + static_cast<std::int64_t>(at), window.substr(at, blank.size())};
      window.replace(at, blank.size(), blank);
    }
    const std::size_t kept = seal || last ? 0 : std::min(window.size(), blank.size() - 1);
    const std::size_t done = window.size() - kept;
    sum.add(std::string_view(window).substr(0, done));
    offset += static_cast<std::int64_t>(done);
    return done;
  });
  if (seal) seal->digest = sum.finish();
  return seal;
}

bool isDigit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); }

std::size_t digitsIn(std::string_view text) {
  for (std::size_t at = text.find(kWord); at != text.npos; at = text.find(kWord, at + 1)) {
    const std::string_view digits = text.substr(at + kWord.size()).substr(0, kDigits);
    if (digits.size() == kDigits && std::ranges::all_of(digits, isDigit)) return at + kWord.size();
  }
  return text.npos;
}

}  // namespace

std::string sealText(const std::string& origin, const core::Digest& digest) {
  return fmt::format("{}{}{}", origin, kWord, core::toHex(digest));
}

std::string originIn(std::string_view text) {
  const std::size_t digits = digitsIn(text);
  return digits == text.npos ? "" : std::string(text.substr(0, digits - kWord.size()));
}

void seal(core::AtomicFile& film, FileFormat format, const std::string& origin) {
  const auto found = findSeal(film.descriptor(), film.target(), format, origin);
  if (!found)  // possible, because anyone may have written the work folder
    throw core::ioError(fmt::format("{}: cannot store the text of the film's origin in the file",
                                    core::printable(film.target().native())));
  film.writeAt(found->offset, sealBytes(format, origin, found->digest));
}

FilmState sealState(const std::filesystem::path& film, FileFormat format, const std::string& origin) {
  const core::FileHandle handle = core::openForReading(film);
  const auto found = findSeal(handle.get(), film, format, origin);
  if (!found) return FilmState::kOther;
  return found->bytes == sealBytes(format, origin, found->digest) ? FilmState::kWhole : FilmState::kDamaged;
}

bool bearsSeal(const std::filesystem::path& file) try {
  bool found = false;
  const core::FileHandle handle = core::openForReading(file);
  readThrough(handle.get(), file, [&](const std::string& window, bool) {
    found = found || digitsIn(window) != window.npos;
    return window.size() - std::min(window.size(), kWord.size() + kDigits - 1);
  });
  return found;
} catch (const core::Error&) {
  return false;
}

}  // namespace poinsot::output

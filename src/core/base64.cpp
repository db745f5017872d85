// SPDX-License-Identifier: Apache-2.0
#include "core/base64.h"

#include <openssl/evp.h>

#include <algorithm>

namespace poinsot::core {

std::string base64(std::string_view bytes) {
  // EVP_EncodeBlock() takes an int as size, so long input is encoded in pieces. A piece of 3n bytes needs no
  // padding; only the last piece may get some.
  constexpr std::size_t kPiece = 3 << 20;
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4 + 1);
  for (; !bytes.empty(); bytes.remove_prefix(std::min(kPiece, bytes.size()))) {
    const std::string_view piece = bytes.substr(0, kPiece);
    std::string out((piece.size() + 2) / 3 * 4 + 1, '\0');  // one byte more for the NUL of EVP_EncodeBlock()
    const int size =
        EVP_EncodeBlock(reinterpret_cast<unsigned char*>(out.data()),
                        reinterpret_cast<const unsigned char*>(piece.data()), static_cast<int>(piece.size()));
    text.append(out, 0, static_cast<std::size_t>(size));
  }
  return text;
}

std::string fromBase64(std::string_view text) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    const std::size_t digit = kDigits.find(c);
    if (digit == std::string_view::npos) break;
    bits = bits << 6 | static_cast<unsigned>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xff);
  }
  return bytes;
}

}  // namespace poinsot::core

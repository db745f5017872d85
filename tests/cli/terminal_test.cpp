// SPDX-License-Identifier: Apache-2.0
// Prints no byte that a terminal obeys, for any content of a scene, a golden.toml, a file name or the command line
// (row X1 of the promises in SECURITY.md).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/program_run.h"

namespace poinsot {
namespace {

using Texts = std::vector<std::string>;

/// Returns the sequences that terminals obey: ECMA-48, xterm's OSC, Unicode's annex 9.
Texts obeyed() {
  Texts texts;
  for (int c = 1; c < 0x20; ++c)
    if (c != '\n') texts.emplace_back(1, static_cast<char>(c));
  for (int c = 0x80; c < 0xa0; ++c) texts.push_back(std::string("\xc2") + static_cast<char>(c));  // C1 in UTF-8
  for (const char* text :
       {"\x7f", "\x1b[2J", "\x1b]0;title\x07", "\x1b]8;;http://example.org\x1b\\link\x1b]8;;\x1b\\",
        "\x1b]52;c;ZXZpbA==\x07", "\x1bP$q\"p\x1b\\", "\x1b_x\x1b\\", "\x1b^x\x1b\\", "\r\nfake: ok",
        "\xe2\x80\xae", "\xe2\x80\xaa", "\xe2\x81\xa6", "\xe2\x81\xa9", "\xe2\x80\x8f", "\xd8\x9c", "\xe2\x80\xa8",
        "\xe2\x80\xa9", "\xef\xbb\xbf", "\xf3\xa0\x80\xa1"})
    texts.emplace_back(text);
  return texts;
}

/// Returns words with twelve such sequences each. The last word is not UTF-8, which is refused first.
Texts evilWords() {
  constexpr std::size_t kTogether = 12;
  Texts words;
  const Texts texts = obeyed();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (i % kTogether == 0) words.emplace_back("x");
    words.back() += texts[i] + "y";
  }
  words.emplace_back(
      "x\x80y\x9b"
      "31m\xff");
  return words;
}

/// Returns the first place that must not be printed, or "" if there is none. Does not use the program's own
/// functions.
std::string wrongIn(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0;
    const auto third = i + 2 < text.size() ? static_cast<unsigned char>(text[i + 2]) : 0;
    const bool control = (byte < 0x20 && byte != '\n' && byte != '\t') || byte == 0x7f;
    const bool c1 = byte == 0xc2 && next < 0xa0;
    const bool bidi = (byte == 0xe2 && next == 0x80 && third >= 0xa8 && third <= 0xae) ||
                      (byte == 0xe2 && next == 0x80 && (third == 0x8e || third == 0x8f)) ||
                      (byte == 0xe2 && next == 0x81 && third >= 0xa6 && third <= 0xaf) ||
                      (byte == 0xd8 && next == 0x9c);
    const bool unseen = (byte == 0xef && next == 0xbb && third == 0xbf) || (byte == 0xf3 && next == 0xa0);
    const bool stray = byte >= 0xf8 || byte == 0xc0 || byte == 0xc1;
    const bool lone = (byte & 0xc0) == 0x80 && (i == 0 || static_cast<unsigned char>(text[i - 1]) < 0x80);
    if (control || c1 || bidi || unseen || stray || lone) return fmt::format("byte {:02x} at {}", byte, i);
  }
  return "";
}

/// Returns a TOML string of the text, with control characters escaped. Bytes that are not UTF-8 are kept.
std::string inToml(const std::string& text) {
  std::string written = "\"";
  for (const char c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      written += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      written += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
  }
  return written + "\"";
}

class Terminal : public testing::TestWithParam<std::size_t> {
 protected:
  void expectSafe(const Texts& words) {
    const RunResult made = run(folder_, words, Stdout::kFile, {"CI="});
    EXPECT_EQ(wrongIn(made.out), "") << words[0] << ": " << made.out;
    EXPECT_EQ(wrongIn(made.err), "") << words[0] << ": " << made.err;
    EXPECT_LT(made.exitCode, 5) << made.err;
    printed_ += made.out + made.err;
  }

  ScratchFolder folder_;
  std::string printed_;
};

TEST_P(Terminal, ReceivesNoControlSequences) {
  const Texts words = evilWords();
  for (std::size_t i = GetParam(); i < words.size(); i += 2) {
    const std::string &evil = words[i], quoted = inToml(evil);
    // Errors in scenes: keys, words of a choice, units, labels, files, a name. Each has its own scene, because the
    // first problem may hide others.
    int number = 0;
    for (const std::string& scene :
         {quoted + " = 1\n", "[" + quoted + "]\n", "[body]\nshape = " + quoted + "\n",
          "[body]\nshape = 'mesh'\nfile = " + quoted + "\n", "[style]\nfile = " + quoted + "\n",
          "[motion]\ntorque.file = " + quoted + "\n", "[show]\ntitle = " + quoted + "\n",
          "[body]\nmass = " + quoted + "\n", "[motion]\nomega_body = " + quoted + "\n",
          "[[label]]\ntext = " + quoted + "\n", evil + " = 1\n", "a = \"" + evil + "\"\n"}) {
      const std::string name = fmt::format("s{}.toml", number++);
      folder_.put(name, scene);
      expectSafe({"check", name});
    }
    folder_.put("golden.toml",
                "[[test]]\nname = " + quoted + "\nscene = " + quoted + "\nreason = " + quoted + "\n");
    expectSafe({"golden"});
    // Errors in file names and arguments.
    folder_.put(evil + ".toml", kGoodScene);
    folder_.put(evil + ".stl", "solid " + evil + "\n facet\n");
    folder_.put("mesh.toml", "[body]\nshape = 'mesh'\nfile = 'a.stl'\n");
    folder_.put("a.stl", "solid " + evil + "\nfacet " + evil + "\n");
    for (const Texts& command : {Texts{evil},
                                 {"render", evil},
                                 {"render", evil + ".toml", "-o", evil + ".mp4", "--dry-run"},
                                 {"check", evil + ".toml", "mesh.toml"},
                                 {"info", evil + ".toml"},
                                 {"info", evil + ".toml", "--json"},
                                 {"check", evil + ".toml", "-D", evil + "=1"},
                                 {"check", evil + ".toml", "-D", "show.title=" + quoted},
                                 {"render", "a", "--frames", evil},
                                 {"render", "a", "--" + evil},
                                 {"status", evil + ".mp4"},
                                 {"diff", evil, evil + ".toml"},
                                 {"gallery", evil, "--dry-run"},
                                 {"golden", evil + ".toml"},
                                 {"grade", evil + ".toml", evil + ".stl"},
                                 {"submit", evil + ".toml", "-o", evil + ".mp4", "--engine", "make"},
                                 {"trajectory", evil + ".toml", "--at", evil}})
      expectSafe(command);
  }
  for (const std::string& evil : words) EXPECT_NE(wrongIn(evil), "");  // control: wrongIn() finds them
  // The messages did contain the escaped bytes.
  EXPECT_NE(printed_.find("\\x"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Halves, Terminal, testing::Range(std::size_t{0}, std::size_t{2}));

}  // namespace
}  // namespace poinsot

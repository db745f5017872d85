// SPDX-License-Identifier: Apache-2.0
// Files that deviate from their formats, as programs write them. They are read, with a note on what is ignored.
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/mesh_file.h"
#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"
#include "geometry/mesh_writers.h"

namespace poinsot::geometry {
namespace {

using Notes = std::vector<std::string>;

const std::string kMark = "\xef\xbb\xbf";  // byte-order mark of UTF-8

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  for (std::size_t at = text.find(old); at != text.npos; at = text.find(old, at + with.size()))
    text.replace(at, old.size(), with);
  return text;
}

std::string upper(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](char c) { return 'a' <= c && c <= 'z' ? char(c - 'a' + 'A') : c; });
  return text;
}

/// Returns the notes on a file, which must hold a closed mesh of 6 m³.
Notes notesOn(const std::string& bytes, MeshFormat format) {
  try {
    const MeshReading reading = parseMesh(bytes, format, "body");
    checkClosed(reading.mesh);
    EXPECT_NEAR(integrals(reading.mesh).volume_m3, 6, 1e-15);
    EXPECT_EQ(reading.mesh.places.size(), reading.mesh.triangles.size());
    return reading.notes;
  } catch (const core::Error& error) {
    return {std::string("refused: ") + error.what()};
  }
}

const Mesh kBox = boxMesh({2, 1, 3});

TEST(MeshNotes, AreAbsentForEverySpellingOfAnAsciiStl) {
  const std::string text = asAsciiStl(kBox);
  const std::string variants[] = {
      text,
      upper(text),
      replaced(replaced(text, "solid", "Solid"), "vertex", "Vertex"),
      replaced(text, "endsolid body", "ENDSOLID"),
      replaced(replaced(replaced(text, "endsolid", "end solid"), "endloop", "end loop"), "endfacet", "End Facet"),
      kMark + text,
      "\n  \n" + replaced(text, "\n", "\n\n"),
      replaced(text, "\n", "\r\n"),
      kMark + "\r\n" + replaced(upper(text), "\n", " \r\n\t\r\n"),
      text.substr(0, text.size() - 1)};
  for (const std::string& variant : variants)
    EXPECT_EQ(notesOn(variant, MeshFormat::kStl), Notes()) << variant.substr(0, 40);
}

TEST(MeshNotes, AreAbsentForSeveralSolidsInAFile) {
  const std::string text = asAsciiStl(kBox);
  const std::size_t half = text.find("  facet", text.size() / 2);
  EXPECT_EQ(notesOn(text.substr(0, half) + "endsolid a\n\nSOLID b\n" + text.substr(half), MeshFormat::kStl),
            Notes());
}

TEST(MeshNotes, AreAbsentForABinaryStlThatBeginsWithSolid) {
  const std::string bytes = asBinaryStl(kBox);
  ASSERT_EQ(bytes.substr(0, 6), "solid ");
  EXPECT_EQ(notesOn(bytes, MeshFormat::kStl), Notes());
  std::string facet = bytes;
  facet.replace(0, 18, "solid a\nfacet norm");
  EXPECT_EQ(notesOn(facet, MeshFormat::kStl), Notes());
}

TEST(MeshNotes, MentionIgnoredBytesAtTheEnd) {
  std::string bytes = asBinaryStl(kBox);
  const Notes expected{"body: byte 684: 16 bytes after the last of 12 triangles are ignored"};
  EXPECT_EQ(notesOn(bytes + std::string(16, '\0'), MeshFormat::kStl), expected);
  bytes[0] = 'x';
  EXPECT_EQ(notesOn(bytes + std::string(16, 'x'), MeshFormat::kStl), expected);
  const std::string ply = asBinaryPly(kBox, std::endian::little);
  EXPECT_EQ(notesOn(ply + "abc", MeshFormat::kPly),
            Notes{"body: byte " + std::to_string(ply.size()) +
                  ": 3 bytes after the last row that the header declares are ignored"});
}

TEST(MeshNotes, MentionIgnoredNumbersInPlyLines) {
  const std::string text = asAsciiPly(kBox);
  const std::size_t faces = text.find("\n3 ") + 1;
  const std::string surplus = text.substr(0, faces) + replaced(text.substr(faces), "\n", " 200 1 1\n");
  EXPECT_EQ(notesOn(surplus, MeshFormat::kPly),
            Notes{"body:19: the line has more numbers than the header declares; the rest is ignored (12 places)"});
  EXPECT_EQ(notesOn(replaced(surplus, "\n", "\n\n"), MeshFormat::kPly).size(), 1U);
  EXPECT_EQ(notesOn(text + "what\nelse\n", MeshFormat::kPly),
            Notes{"body:31: the text after the last row that the header declares is ignored"});
}

TEST(MeshNotes, AreAbsentForPlyRowsSplitAcrossLines) {
  const std::string text = asAsciiPly(kBox);
  const std::size_t body = text.find("end_header\n") + 11;
  EXPECT_EQ(notesOn(text.substr(0, body) + replaced(text.substr(body), "\n", " "), MeshFormat::kPly), Notes());
  EXPECT_EQ(notesOn(text.substr(0, body) + replaced(text.substr(body), " ", "\n"), MeshFormat::kPly), Notes());
}

TEST(MeshNotes, PlyLineWithTooFewNumbersIsRejected) {
  const std::string text = asAsciiPly(kBox);
  const std::size_t faces = text.find("\n3 ") + 1;
  EXPECT_EQ(notesOn(text.substr(0, faces) + "3 0 1\n" + text.substr(text.find('\n', faces) + 1), MeshFormat::kPly),
            Notes{"refused: body:19: the line has fewer numbers than the header declares; add them, or export the "
                  "mesh again"});
}

TEST(MeshNotes, AreAbsentForAByteOrderMark) {
  EXPECT_EQ(notesOn(kMark + asObj(kBox), MeshFormat::kObj), Notes());
  EXPECT_EQ(notesOn(kMark + asObj(kBox).substr(asObj(kBox).find("v ")), MeshFormat::kObj), Notes());
  EXPECT_EQ(notesOn(kMark + asAsciiPly(kBox), MeshFormat::kPly), Notes());
  EXPECT_EQ(notesOn(kMark + asBinaryPly(kBox, std::endian::big), MeshFormat::kPly), Notes());
}

TEST(MeshNotes, MentionIgnoredTextOfAnStlVertex) {
  EXPECT_EQ(
      notesOn(replaced(asAsciiStl(kBox), "0.5 1.5\n", "0.5 1.5 0.25\n"), MeshFormat::kStl).at(0).substr(0, 66),
      "body:4: the text after the three coordinates of a vertex is ignore");
}

TEST(MeshNotes, SayHowFarJoinedCornersWereMoved) {
  const Mesh box = transformed(kBox, Eigen::Matrix3d::Identity(), {1, .5, 1.5});
  std::string text = asAsciiStl(box);
  const std::string corner = "vertex 0 0 0\n";
  ASSERT_NE(text.find(corner), text.npos);
  text.replace(text.find(corner), corner.size(), "vertex 0 0 2.4186773518759718e-18\n");
  EXPECT_EQ(
      notesOn(text, MeshFormat::kStl),
      Notes{"body: 1 corner was joined to others, moved by at most 2.4e-18 in the file's unit (8.1e-19 of the "
            "mesh's size), to close the surface; the file has them at different places by rounding"});
}

TEST(MeshNotes, AreSafeToPrint) {
  const MeshReading reading = parseMesh(asBinaryStl(kBox) + "\x1b[2J", MeshFormat::kStl, "bo\x1b[2Jdy");
  for (const std::string& note : reading.notes)
    EXPECT_TRUE(std::ranges::none_of(note, [](unsigned char c) { return c < 0x20; })) << note;
  EXPECT_EQ(reading.notes.size(), 1U);
}

}  // namespace
}  // namespace poinsot::geometry

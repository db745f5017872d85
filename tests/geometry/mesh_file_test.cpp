// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "geometry/mesh_integrals.h"
#include "geometry/mesh_samples.h"
#include "geometry/mesh_writers.h"
#include "support/scratch_folder.h"

namespace poinsot::geometry {
namespace {

using Eigen::Vector3d;

void expectSame(const Mesh& read, const Mesh& written, const char* name) {
  const Mesh expected = welded(written);
  EXPECT_EQ(read.vertices_M.size(), expected.vertices_M.size()) << name;
  ASSERT_EQ(read.triangles.size(), expected.triangles.size()) << name;
  for (std::size_t t = 0; t < read.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ((read.vertices_M[read.triangles[t][i]] - expected.vertices_M[expected.triangles[t][i]]).norm(), 0)
          << name;
}

TEST(MeshFile, RoundTripsMeshesInEveryFormat) {
  for (const Sample& sample : primitives(12)) {
    expectSame(parseMesh(asObj(sample.mesh), MeshFormat::kObj, "a.obj").mesh, sample.mesh, sample.name);
    expectSame(parseMesh(asAsciiStl(sample.mesh), MeshFormat::kStl, "a.stl").mesh, sample.mesh, sample.name);
    expectSame(parseMesh(asAsciiPly(sample.mesh), MeshFormat::kPly, "a.ply").mesh, sample.mesh, sample.name);
    for (const std::endian order : {std::endian::little, std::endian::big})
      expectSame(parseMesh(asBinaryPly(sample.mesh, order), MeshFormat::kPly, "a.ply").mesh, sample.mesh,
                 sample.name);
    Mesh floats = sample.mesh;
    for (Vector3d& v : floats.vertices_M)
      for (double& x : v) x = static_cast<double>(static_cast<float>(x));
    const Mesh read = parseMesh(asBinaryStl(sample.mesh), MeshFormat::kStl, "a.stl").mesh;
    expectSame(read, floats, sample.name);
    EXPECT_NO_THROW(checkClosed(read)) << sample.name;  // welding closes the mesh again
  }
}

TEST(MeshFile, ReadsObjPolygonsAndNegativeIndices) {
  const Mesh mesh = parseMesh(
                        "mtllib x.mtl\r\n"
                        "v +1 1 -1 1.0\r\n"
                        "v 1 -1 -1 0.5 0.5 0.5 # red\r\n"
                        "v -1 -1 -1\r\nv -1 1 -1\r\nvt 0 0\r\n"
                        "v 1 1e0 1\r\nv 1 -1 1\r\nv -1 -1 1\r\nv -1 1 1\r\n\r\n"
                        "f 1 2 3 4\r\n"
                        "f -4//1 -1/2/3 -2/1 -3\r\n"
                        "f 1/1 5/1 \\\r\n 6/1 2/1\r\n"
                        "f 2 6 7 3#comment\r\n"
                        "\tf 3 7 8 4\r\n"
                        "f 5 1 4 8",
                        MeshFormat::kObj, "cube.obj")
                        .mesh;
  EXPECT_NO_THROW(checkClosed(mesh));
  EXPECT_EQ(mesh.triangles.size(), 12U);
  EXPECT_EQ(integrals(mesh).volume_m3, 8);
}

const std::string kAgain = "; export the mesh again";
const std::string kCorrect = "; correct it, or export the mesh again";
const std::string kNoFaces = "; export the surface of the body, not points or lines alone";
const std::string kObjCount = "; count from 1, or back from the last with -1, and put vertices before faces";
const std::string kPlyCount = "; refer to one of these, and put vertices before faces";

std::string parsed(const std::string& bytes, MeshFormat format) {
  return refusal([&] { parseMesh(bytes, format, "body"); });
}

TEST(MeshFile, RejectsAMalformedObj) {
  const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const auto obj = [](const std::string& text) { return parsed(text, MeshFormat::kObj); };
  EXPECT_EQ(obj(three + "f 1 2 4\n"),
            "body:4: a corner of a face refers to vertex 4, but there are only 3 so far" + kObjCount);
  EXPECT_EQ(obj(three + "f 1 2 -4\n"),
            "body:4: a corner of a face refers to vertex -4, but there are only 3 so far" + kObjCount);
  EXPECT_EQ(obj(three + "f 1 2 0\n"),
            "body:4: a corner of a face refers to vertex 0, but there are only 3 so far" + kObjCount);
  EXPECT_EQ(obj(three + "f 1 2\n"), "body:4: a face has three corners or more, got 2; remove the face");
  EXPECT_EQ(obj(three + "f 1 2 3x\n"), "body:4: expected a whole number, got \"3x\"" + kCorrect);
  EXPECT_EQ(obj(three + "f 1 2 99999999999999999999\n"),
            "body:4: expected a whole number, got \"99999999999999999999\"" + kCorrect);
  EXPECT_EQ(obj("v 1 2\n"), "body:1: expected a number, but the line ends; add it, or export the mesh again");
  EXPECT_EQ(obj("v 1 2 +-3\n"), "body:1: expected a number, got \"+-3\"" + kCorrect);
  EXPECT_EQ(obj("v 1 2 nan\n"), "body:1: expected a number, got \"nan\"" + kCorrect);
  EXPECT_EQ(obj("v 1 2 1e999\n"), "body:1: 1e999 is beyond the range of a double; give lengths in a larger unit");
  EXPECT_EQ(obj(three), "body: the file has no faces" + kNoFaces);
  EXPECT_EQ(obj(""), "body: the file is empty; export the mesh again");
}

TEST(MeshFile, RejectsAMalformedStl) {
  const auto stl = [](const std::string& text) { return parsed(text, MeshFormat::kStl); };
  EXPECT_EQ(stl("solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\n"),
            "body:6: a loop has three vertices, got 2; divide polygons into triangles");
  EXPECT_EQ(stl("solid x\nvertex 0 0 zero\n"), "body:2: expected a number, got \"zero\"" + kCorrect);
  EXPECT_EQ(stl("solid x\n<html>\n"),
            "body:2: expected facet, outer loop, vertex, endloop, endfacet or endsolid, got \"<html>\"; remove "
            "the line, or "
            "export the mesh again");
  EXPECT_EQ(stl("solid x\nfacet normal 0 0 1\nouter loop\n"),
            "body:3: the file ends before endsolid, so that triangles may be missing; export the mesh again");
  EXPECT_EQ(stl("solid x\nendsolid x\n"), "body: the file has no faces" + kNoFaces);
  EXPECT_EQ(stl("PNG"),
            "body: byte 3: the file ends within the 84 bytes of a binary STL header; an ASCII STL begins with "
            "\"solid\", but this file begins with \"PNG\"; export the mesh again");
  std::string binary = asBinaryStl(cubeMesh(1));
  for (const char first : {'x', 's'}) {
    binary[0] = first;
    EXPECT_EQ(stl(binary.substr(0, 600)),
              "body: byte 80: the file is truncated or is not an STL: a binary STL has its count of triangles "
              "here, and 12 triangles take 684 bytes, but the file has 600; an ASCII STL begins with \"solid\", "
              "but this file begins with \"" +
                  std::string(1, first) + "olid\"; export the mesh again");
  }
  binary[0] = 'x';
  binary.replace(96, 4, std::string("\0\0\xc0\x7f", 4));
  EXPECT_EQ(stl(binary),
            "body: byte 96: coordinates of a vertex must be finite, got (nan, 0.5, 0.5); export the mesh again");
}

TEST(MeshFile, RejectsAMalformedPlyHeader) {
  const auto ply = [](const std::string& text) { return parsed(text, MeshFormat::kPly); };
  EXPECT_EQ(ply("plx\n"),
            "body:1: a PLY file begins with a line \"ply\"; if this is another format, rename the file with its "
            "extension");
  EXPECT_EQ(ply("ply\nformat cbor 1.0\n"),
            "body:2: \"cbor\" is not a PLY format; it is one of ascii, binary_little_endian, binary_big_endian");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\n"), "body:2: the file ends within the PLY header" + kAgain);
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nproperty int x\n"),
            "body:3: a property comes before the first element" + kAgain);
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex -1\n"),
            "body:3: an element must have at least 0 rows, got -1" + kAgain);
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty long x\n"),
            "body:4: \"long\" is not a PLY type; it is one of char, int8, uchar, uint8, short, int16, ushort, "
            "uint16, int, "
            "int32, uint, uint32, float, float32, double, float64");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement face 1\nproperty list float int vertex_index\n"),
            "body:4: the count of a list must be of a whole type, such as uchar" + kAgain);
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement dust 9000000000\nend_header\n"),
            "body:3: element dust has no property; remove it, or export the mesh again");
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\nend_header\n1 2\n"),
            "body:3: element vertex must have one number z" + kAgain);
  EXPECT_EQ(ply("ply\nformat ascii 1.0\nelement face 1\nproperty int vertex_index\nend_header\n1\n"),
            "body:3: element face must have one list vertex_indices of a whole type" + kAgain);
}

TEST(MeshFile, RejectsAMalformedPlyBody) {
  const std::string text = asAsciiPly(cubeMesh(1));
  const auto ply = [](const std::string& bytes) { return parsed(bytes, MeshFormat::kPly); };
  const auto with = [&](const std::string& old, const std::string& changed) {
    std::string copy = text;
    return copy.replace(copy.find(old), old.size(), changed);
  };
  EXPECT_EQ(ply(with("element face 12", "element face 13")),
            "body:30: the file ends before the last row that its header declares" + kAgain);
  const std::string face = text.substr(text.rfind('\n', text.size() - 2) + 1);
  EXPECT_EQ(
      ply(with(face, "3 0 1 8\n")),
      "body:30: a corner of a face refers to vertex 8 (counted from 0), but there are only 8 so far" + kPlyCount);
  EXPECT_EQ(
      ply(with(face, "3 0 1 -1\n")),
      "body:30: a corner of a face refers to vertex -1 (counted from 0), but there are only 8 so far" + kPlyCount);
  // A double rounds 2^63 - 1 to 2^63.
  EXPECT_EQ(ply(with(face, "3 0 1 9223372036854775807\n")),
            "body:30: a corner of a face refers to vertex 9223372036854775807 (counted from 0), but there are "
            "only 8 so far" +
                kPlyCount);
  EXPECT_EQ(ply(with(face, "9223372036854775807 0 1 2\n")),
            "body:30: the mesh has more than the allowed 2000000 triangles");
  EXPECT_EQ(ply(with(face, "3 0 1 1.5\n")), "body:30: expected a whole number, got \"1.5\"" + kCorrect);
  EXPECT_EQ(ply(with(face, "-3 0 1 2\n")), "body:30: a list must have at least 0 numbers, got -3" + kAgain);
  EXPECT_EQ(ply(with(face, "2 0 1\n")), "body:30: a face has three corners or more, got 2; remove the face");
  const std::string binary = asBinaryPly(cubeMesh(1), std::endian::big);
  EXPECT_EQ(ply(binary.substr(0, binary.size() - 1)),
            "body: byte 702: the file ends before the last row that its header declares" + kAgain);
}

TEST(MeshFile, ChecksLimitsBeforeReading) {
  EXPECT_EQ(
      parsed("ply\nformat ascii 1.0\nelement vertex 6000001\nproperty int x\nproperty int y\nproperty int z\n"
             "end_header\n",
             MeshFormat::kPly),
      "body:3: the mesh has more than the allowed 6000000 vertices");
  EXPECT_EQ(parsed("ply\nformat ascii 1.0\nelement face 1\nproperty list uint int vertex_index\nend_header\n"
                   "4000000000 1 2",
                   MeshFormat::kPly),
            "body:6: the mesh has more than the allowed 2000000 triangles");
  std::string face = "v 0 0 0\nf";
  for (std::size_t i = 0; i < MeshLimits().triangles + 3; ++i) face += " 1";
  EXPECT_EQ(parsed(face + " what comes after is not looked at", MeshFormat::kObj),
            "body:2: the mesh has more than the allowed 2000000 triangles");
  EXPECT_EQ(parsed(std::string(MeshLimits().bytes + 1, ' '), MeshFormat::kObj),
            "body has more than the allowed 134217728 bytes");
  try {
    parsed(std::string(MeshLimits().bytes + 1, ' '), MeshFormat::kObj);
  } catch (const core::Error& error) {
    EXPECT_EQ(error.kind(), core::ErrorKind::kLimit);
  }
}

TEST(MeshFile, ChoosesTheFormatByTheEnding) {
  const ScratchFolder folder;
  for (const char* name : {"a.obj", "b.OBJ"})
    EXPECT_EQ(readMesh(folder.put(name, asObj(cubeMesh(1)))).mesh.triangles.size(), 12U);
  EXPECT_EQ(readMesh(folder.put("a.stl", asBinaryStl(cubeMesh(1)))).mesh.triangles.size(), 12U);
  EXPECT_EQ(readMesh(folder.put("a.Ply", asAsciiPly(cubeMesh(1)))).mesh.triangles.size(), 12U);
  EXPECT_EQ(refusal([&] { readMesh(folder / "a.gltf"); }),
            "the name of a mesh file must end in .obj, .stl or .ply, got a.gltf");
}

TEST(MeshFile, ReadsOnlyRegularFiles) {
  const ScratchFolder folder;
  const auto reading = [&](const std::string& name) { return refusal([&] { readMesh(folder / name); }); };
  EXPECT_EQ(reading("none.obj"), "cannot read " + (folder / "none.obj").string() + ": No such file or directory");
  std::filesystem::create_directory(folder / "folder.obj");
  EXPECT_EQ(reading("folder.obj"), "cannot read " + (folder / "folder.obj").string() + ": it is a directory");
  ASSERT_EQ(mkfifo((folder / "pipe.obj").c_str(), 0600), 0);  // reading a pipe would wait for a writer
  EXPECT_EQ(reading("pipe.obj"), "cannot read " + (folder / "pipe.obj").string() + ": it is not a regular file");
}

}  // namespace
}  // namespace poinsot::geometry

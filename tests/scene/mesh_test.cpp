// SPDX-License-Identifier: Apache-2.0
// Messages of a scene about its mesh files: places in the files, notes, and how to draw an open mesh.
#include <gmock/gmock.h>

#include "scene_testing.h"
#include "support/scratch_folder.h"

namespace poinsot::scene {
namespace {

using testing::HasSubstr;

const std::string kSpin = "motion.omega_body = [0.1, 0.2, 1]\n";
const std::string kTetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

/// Returns a scene with a mesh of 1 kg from a file beside the scene.
std::string bodyOf(const std::string& file) {
  return kSpin + "[body]\nshape = 'mesh'\nmass = 1\nfile = '" + file + "'\n";
}

std::string problemsWith(const std::string& file, const std::string& bytes) {
  const ScratchFolder folder;
  folder.put(file, bytes);
  return messagesOf(bodyOf(file), {}, folder / "test.toml");
}

std::string notesWith(const std::string& scene, const std::string& file, const std::string& bytes) {
  const ScratchFolder folder;
  folder.put(file, bytes);
  std::string lines;
  for (const Doubt& doubt : parseScene(scene, folder / "test.toml").doubts)
    lines += std::to_string(doubt.where.line) + ": " + doubt.message + "\n";
  return lines;
}

TEST(MeshFiles, ErrorsNameTheFileAndTheLine) {
  EXPECT_EQ(problemsWith("a.obj", kTetrahedron + "f 1 2 9\n"),
            "body.file: a.obj:9: a corner of a face refers to vertex 9, but there are only 4 so far; count from "
            "1, or back from the last with -1, and put vertices before faces\n");
  EXPECT_EQ(
      problemsWith("a.stl", "solid a\nfacet\n<html>\n"),
      "body.file: a.stl:3: expected facet, outer loop, vertex, endloop, endfacet or endsolid, got \"<html>\"; "
      "remove the line, or export the mesh again\n");
}

TEST(MeshFiles, OpenMeshMayBeDrawnButNotDefineTheBody) {
  const std::string open = kTetrahedron.substr(0, kTetrahedron.rfind("f "));
  const std::string said = problemsWith("a.obj", open);
  EXPECT_THAT(said,
              HasSubstr("body.file: the mesh is open at the edge from (1, 0, 0) to (0, 1, 0) (of the triangle "
                        "at line 5); only a closed surface has a volume: close the hole in a mesh program"));
  EXPECT_THAT(said,
              HasSubstr("; to only draw this mesh, give the moments as numbers in body.principal_moments, and the "
                        "mesh in show.body.shape = \"mesh\" and show.body.file\n"));
  EXPECT_EQ(notesWith(kSpin + "body.principal_moments = [1, 2, 3]\n[show.body]\nshape = 'mesh'\nfile = 'a.obj'\n",
                      "a.obj", open),
            "");
}

TEST(MeshFiles, GapsByRoundingAreClosedWithANote) {
  std::string text = "v 1e-17 0 0\n" + kTetrahedron;  // one more vertex, for one of the faces
  for (const auto& [old, now] : {std::pair{"f 1 3 2", "f 2 4 3"}, std::pair{"f 1 2 4", "f 1 3 5"},
                                 std::pair{"f 1 4 3", "f 2 5 4"}, std::pair{"f 2 3 4", "f 3 4 5"}})
    text.replace(text.find(old), 7, now);
  EXPECT_EQ(
      notesWith(bodyOf("a.obj"), "a.obj", text),
      "5: body.file: a.obj: 1 corner was joined to others, moved by at most 1e-17 in the file's unit (1e-17 of "
      "the mesh's size), to close the surface; the file has them at different places by rounding\n");
}

TEST(MeshFiles, AreRejectedIfAPartIsInsideOut) {
  const std::string second = "v 5 0 0\nv 5.5 0 0\nv 5 0.5 0\nv 5 0 0.5\nf 5 6 7\nf 5 8 6\nf 5 7 8\nf 6 8 7\n";
  EXPECT_THAT(
      problemsWith("a.obj", kTetrahedron + second),
      HasSubstr("body.file: the part of the mesh that has a corner at (5, 0, 0) (of the triangle at line 13) is "
                "inside out and is not inside another part; flip its triangles (swap two corners of each)"));
}

TEST(MeshFiles, NotesAppearAtEveryKeyThatNamesTheFile) {
  const std::string ply =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement "
      "face 4\n"
      "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1 9 9\n3 0 1 3\n3 0 "
      "3 2\n"
      "3 1 2 3\n";
  const std::string note =
      "file: a.ply:14: the line has more numbers than the header declares; the rest is ignored\n";
  EXPECT_EQ(notesWith(bodyOf("a.ply") + "[show.body]\nshape = 'mesh'\nfile = 'a.ply'\n", "a.ply", ply),
            "5: body." + note + "8: show.body." + note);
  EXPECT_NEAR(
      [&] {
        const ScratchFolder folder;
        folder.put("a.ply", ply);
        return parseScene(kSpin + "[body]\nshape = 'mesh'\ndensity = 6\nfile = 'a.ply'\n", folder / "test.toml")
            .body.mass->mass_kg();
      }(),
      1, 1e-15);
}

}  // namespace
}  // namespace poinsot::scene

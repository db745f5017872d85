// SPDX-License-Identifier: Apache-2.0
#include "geometry/mesh_file.h"

#include <fmt/format.h>

#include "core/regular_file.h"
#include "core/text.h"
#include "geometry/mesh_readers.h"

namespace poinsot::geometry {

MeshFormat meshFormatOf(const std::filesystem::path& path) {
  const std::string ending = core::lowered(path.extension().string());
  if (ending == ".obj") return MeshFormat::kObj;
  if (ending == ".stl") return MeshFormat::kStl;
  if (ending == ".ply") return MeshFormat::kPly;
  throw core::sceneError(fmt::format("the name of a mesh file must end in .obj, .stl or .ply, got {}",
                                     core::printable(path.filename().string())));
}

MeshReading parseMesh(std::string_view bytes, MeshFormat format, const std::string& name,
                      const MeshLimits& limits) {
  const std::string shown = core::printable(name);
  if (bytes.size() > limits.bytes)
    throw core::limitError(fmt::format("{} has more than the allowed {} bytes", shown, limits.bytes));
  if (bytes.empty())
    throw core::Error(core::ErrorKind::kScene, "the file is empty; export the mesh again",
                      core::SourceLocation{shown});
  MeshBuilder builder(shown, limits);
  switch (format) {
    case MeshFormat::kObj:
      readObj(bytes, builder);
      break;
    case MeshFormat::kStl:
      readStl(bytes, builder);
      break;
    case MeshFormat::kPly:
      readPly(bytes, builder);
      break;
  }
  return builder.finished();
}

MeshReading readMesh(const std::filesystem::path& path, const MeshLimits& limits) {
  const MeshFormat format = meshFormatOf(path);
  return parseMesh(core::readRegularFile(path, limits.bytes, core::ErrorKind::kScene), format, path.string(),
                   limits);
}

}  // namespace poinsot::geometry

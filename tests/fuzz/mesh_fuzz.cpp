// SPDX-License-Identifier: Apache-2.0
#include "core/error.h"
#include "fuzz/input.h"
#include "geometry/mesh_file.h"
#include "geometry/mesh_integrals.h"

// The input is a byte that selects the format, then the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using poinsot::geometry::MeshFormat;
  if (size == 0) return 0;
  const MeshFormat format = data[0] == 'o'   ? MeshFormat::kObj
                            : data[0] == 's' ? MeshFormat::kStl
                                             : MeshFormat::kPly;
  try {
    const auto read = poinsot::geometry::parseMesh(poinsot::fuzz::textOf({data + 1, size - 1}), format, "mesh");
    for (const std::string& note : read.notes) poinsot::fuzz::expectPrintable(note);
    poinsot::geometry::checkClosed(read.mesh);
    poinsot::geometry::integrals(read.mesh);
  } catch (const poinsot::core::Error& error) {
    poinsot::fuzz::expectPrintable(error.what());
  }
  return 0;
}

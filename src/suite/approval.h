// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "compare/outcome.h"
#include "core/file_batch.h"
#include "output/run_files.h"
#include "suite/reference.h"

namespace poinsot::suite {

/// Returns image::pixelDigest() of a PNG file; of a film, the SHA-256 of the file.
/// @throws core::Error(kIo) if it cannot be read; (kLimit) as image::readPngAsStored()
std::string pixelDigestOf(const std::filesystem::path& file, bool isFilm);

/// Files that approving one picture changes.
struct Approval {
  std::filesystem::path place;
  std::vector<std::filesystem::path> removed;  ///< references of other renderers
};

/// Enters a reference and its description as outputs. A picture in that place is a reference, whoever made it; a
/// file in the description's place is replaced only if it is a description.
/// @throws as RunFiles::writesInNewFolder()
void enterApproval(output::RunFiles& files, const std::filesystem::path& place);

/// Pictures that become references together: all, each with its description, or none.
class GoldenApproval {
 public:
  /// @param references  their folder
  /// @param beside  whether references of other renderers stay. Else those are removed, because nobody looked at
  ///                what they should be now; except those of the same scene where the renderer had one before.
  /// @param force  whether any regular file may be replaced
  GoldenApproval(std::filesystem::path references, bool beside, bool force = false)
      : references_(std::move(references)), beside_(beside), force_(force) {}

  /// Adds the new picture of an outcome as the reference of its renderer. A copy is written, read again and held
  /// against the picture that was drawn and compared.
  /// @throws as enterApproval(); core::Error(kIo), also if they differ; (kUsage) if the file of a renderer is that
  /// of another, or of
  ///         another test.
  Approval add(const GoldenName& name, const compare::Outcome& outcome);

  /// Changes all references. If it throws, every reference is what it was before.
  /// @throws core::Error(kIo)
  void commit() { batch_.commit(); }

 private:
  std::filesystem::path references_;
  bool beside_;
  bool force_;
  core::FileBatch batch_;
};

}  // namespace poinsot::suite

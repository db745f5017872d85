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

/// Returns image::pixelDigest() of a PNG file, or the SHA-256 digest of a film's file.
/// @throws core::Error(kIo) if the file cannot be read; (kLimit) as image::readPngAsStored()
std::string pixelDigestOf(const std::filesystem::path& file, bool isFilm);

struct Approval {
  std::filesystem::path place;
  std::vector<std::filesystem::path> removed;  ///< references of other renderers, now obsolete
};

/// Enters a reference and its description among a run's outputs. A reference may replace any picture; a
/// description may replace only a description.
/// @throws core::Error as RunFiles::writesInNewFolder()
void enterApproval(output::RunFiles& files, const std::filesystem::path& place);

/// Transaction that approves pictures as references, each with its description: all of them or none.
class GoldenApproval {
 public:
  /// @param references  folder of the references
  /// @param beside  true keeps references of other renderers. False removes them, because nobody has checked them
  ///   against the change; references of the same scene stay if the renderer already had its own reference.
  /// @param force  whether any regular file may be replaced
  GoldenApproval(std::filesystem::path references, bool beside, bool force = false)
      : references_(std::move(references)), beside_(beside), force_(force) {}

  /// Adds the new picture of an outcome as the reference of its renderer. The picture is copied, and the copy's
  /// digest is checked against the picture that was drawn and compared.
  /// @throws core::Error as enterApproval(); (kIo) also if the digests differ; (kUsage) if another renderer or
  ///   test owns the file
  Approval add(const GoldenName& name, const compare::Outcome& outcome);

  /// Replaces all references, or none if an exception is thrown. @throws core::Error(kIo)
  void commit() { batch_.commit(); }

 private:
  std::filesystem::path references_;
  bool beside_;
  bool force_;
  core::FileBatch batch_;
};

}  // namespace poinsot::suite

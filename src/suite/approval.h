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

/// Registers a reference and its description as outputs of a run. A reference may replace any picture. A
/// description may replace only a description.
/// @throws core::Error as RunFiles::writesInNewFolder()
void enterApproval(output::RunFiles& files, const std::filesystem::path& place);

/// Approves new pictures as references and writes their descriptions. Either all references are replaced, or none.
class GoldenApproval {
 public:
  /// @param references  folder of the references
  /// @param beside  whether to keep references of other renderers. Without it, they are removed, because nobody
  ///   has checked them after the change. They stay if the scene is unchanged and the renderer already had its own
  ///   reference.
  /// @param force  whether any regular file may be replaced
  GoldenApproval(std::filesystem::path references, bool beside, bool force = false)
      : references_(std::move(references)), beside_(beside), force_(force) {}

  /// Adds the new picture of an outcome as a reference for its renderer. The picture is copied. The digest of the
  /// copy must equal the digest of the picture that was compared.
  /// @throws core::Error as enterApproval(); (kIo) also if the digests differ; (kUsage) if another renderer or
  ///   test owns the file
  Approval add(const GoldenName& name, const compare::Outcome& outcome);

  /// Returns the files that add() and commit() change.
  /// @throws core::Error as add()
  std::vector<compare::ApprovalFile> filesOf(const GoldenName& name, const compare::Outcome& outcome) const;

  /// Replaces all references, or none if an exception is thrown. @throws core::Error(kIo)
  void commit() { batch_.commit(); }

 private:
  Approval planned(const GoldenName& name, const compare::PictureOrigin& origin) const;

  std::filesystem::path references_;
  bool beside_;
  bool force_;
  core::FileBatch batch_;
};

}  // namespace poinsot::suite

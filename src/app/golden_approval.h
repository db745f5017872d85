// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "app/golden_reference.h"
#include "app/outcome.h"
#include "output/file_batch.h"

namespace poinsot::app {

/// Files that approving one picture changes.
struct Approval {
  std::filesystem::path place;
  std::vector<std::filesystem::path> removed;  ///< references of other renderers
};

/// Pictures that become references together: all, each with its description, or none.
class GoldenApproval {
 public:
  /// @param references  their folder
  /// @param beside  whether references of other renderers stay. Else those are removed, because nobody looked at
  ///                what they should be now; except those of the same scene where the renderer had one before.
  GoldenApproval(std::filesystem::path references, bool beside)
      : references_(std::move(references)), beside_(beside) {}

  /// Adds the new picture of an outcome as the reference of its renderer. A copy is written, read again and held
  /// against the picture that was drawn and compared.
  /// @throws core::Error(kIo), also if they differ; (kUsage) if the file of a renderer is that of another, or of
  ///         another test.
  Approval add(const GoldenName& name, const Outcome& outcome);

  /// Changes all references. If it throws, every reference is what it was before.
  /// @throws core::Error(kIo)
  void commit() { batch_.commit(); }

 private:
  std::filesystem::path references_;
  bool beside_;
  output::FileBatch batch_;
};

}  // namespace poinsot::app

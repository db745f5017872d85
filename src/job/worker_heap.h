// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::job {

/// Reserves a heap of the worker's expected size, and requests huge pages there: 2 MiB at once instead of 4 KiB.
/// Pages take memory only when first written. Blocks up to 32 MiB lie in this heap and are kept for the next
/// picture. Huge pages are not used above 400 MiB, or if the process has little address space.
void beginHeap(double expected_bytes);

}  // namespace poinsot::job

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::job {

/// Reserves a heap of the expected size of a worker, and requests huge pages of 2 MiB instead of 4 KiB. Pages use
/// memory only after they are first written. Blocks up to 32 MiB are allocated in this heap and reused for the
/// next picture. Does not use huge pages above 400 MiB, or if the process has little address space.
void beginHeap(double expected_bytes);

}  // namespace poinsot::job

// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Where malloc() takes the memory of a worker from.
namespace poinsot::job {

/// Lets the heap of this process begin as large as the worker is expected to grow, and asks the kernel for large
/// pages there: 2 MiB at a time in place of 4 KiB, when they are first written. What is not written takes none.
/// Blocks up to 32 MiB lie in it and are kept for the next picture. Where that is more than 400 MiB, or a process
/// may have few addresses, pages stay small.
void beginHeap(double expected_bytes);

}  // namespace poinsot::job

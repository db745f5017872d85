// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::python {

/// Registers a translator from the libraries' exceptions to those of poinsot/_errors.py.
void translateErrors();

}  // namespace poinsot::python

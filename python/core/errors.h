// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace poinsot::python {

/// From now on the exceptions of the layers are those of poinsot/_errors.py.
void translateErrors();

}  // namespace poinsot::python

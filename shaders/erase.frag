// SPDX-License-Identifier: Apache-2.0
// Depth alone: where it is 1 nobody looks at the colour.
void main() {}

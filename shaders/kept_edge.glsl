// SPDX-License-Identifier: Apache-2.0
// Packs an edge into one number for the composite pass (emit.glsl): its coverage, and whether it belongs to a flat line.
float keptEdge(float coverage, bool line) { return 0.5 * coverage + (line ? 0.0 : 0.5); }
bool isLine(float kept) { return kept <= 0.5; }
float coverageOf(float kept) { return 2.0 * kept - (isLine(kept) ? 0.0 : 1.0); }

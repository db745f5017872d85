// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "package/installed_tree.h"

namespace poinsot {

inline const std::string kExamples = POINSOT_SOURCE_DIR "/examples";
inline const std::string kPhysics = "poinsot-physics";
inline const std::string kPictures = "poinsot-stage poinsot-render poinsot-output";

/// A compiler and flags of a program that links the library: {"g++", "-O0 -mavx2"}.
struct Compilation {
  std::string compiler, flags;

  std::string text() const { return compiler + " " + flags; }
  /// Whether the CPU has the instructions that the flags name; read from /proc/cpuinfo.
  bool runsHere() const;
  /// Makes the program `name` from a source, linked with the layers of these pkg-config modules.
  void make(const InstalledTree& tree, const std::string& source, const std::string& modules,
            const std::string& name) const;
  /// Returns what the compiler says of a source that it is to refuse.
  std::string refusal(const InstalledTree& tree, const std::string& source, const std::string& modules) const;
};

/// Why programs compiled with flags of their own cannot be tried in this build; empty if they can.
std::string whyNoFlags();

/// Writes a program that has a glad of its own for OpenGL `version` ("3.3"), with a counter in place of its
/// glClear, links it with that glad as an archive or as a shared library, draws a picture with poinsot, and
/// expects that the counter is still there, that poinsot never called it, and that the picture is that of `poinsot
/// still`.
void expectKeepsItsGlad(const InstalledTree& tree, const Compilation& compilation, const std::string& version);

/// Expects that every class that a public header defines has the same size and alignment in these compilations as
/// in a plain one. The classes are those at the left margin of the headers.
void expectSameLayout(const InstalledTree& tree, const std::vector<Compilation>& compilations);

}  // namespace poinsot

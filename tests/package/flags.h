// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "package/installed_tree.h"

namespace poinsot {

inline const std::string kExamples = POINSOT_SOURCE_DIR "/examples";
inline const std::string kPhysics = "poinsot-physics";
inline const std::string kPictures = "poinsot-stage poinsot-render poinsot-output";

/// Compiler and flags of a program that links the library: {"g++", "-O0 -mavx2"}.
struct Compilation {
  std::string compiler, flags;

  std::string text() const { return compiler + " " + flags; }
  /// Returns whether the CPU has the instructions that the flags require, from /proc/cpuinfo.
  bool runsHere() const;
  /// Builds the program `name` from a source, linked with the layers of these pkg-config modules.
  void make(const InstalledTree& tree, const std::string& source, const std::string& modules,
            const std::string& name) const;
  std::string refusal(const InstalledTree& tree, const std::string& source, const std::string& modules) const;
};

/// Returns the reason why this build cannot test programs with other flags; empty if it can.
std::string whyNoFlags();

/// Tests a program that has its own glad for OpenGL `version` ("3.3") and replaces its glClear by a counter. The
/// program links glad as an archive or as a shared library, and draws a picture with poinsot. Expects that the
/// counter is still in place, that poinsot never called it, and that the picture equals that of `poinsot still`.
void expectKeepsItsGlad(const InstalledTree& tree, const Compilation& compilation, const std::string& version);

/// Expects every class that a public header defines to have the same size and alignment in these compilations as
/// in a plain one. Only classes at the left margin of the headers are found.
void expectSameLayout(const InstalledTree& tree, const std::vector<Compilation>& compilations);

}  // namespace poinsot

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/abi.h"

namespace poinsot::scene {

/// How the values of foreign names become the value of a key.
enum class Carry {
  kValue,        ///< the value of one name, as it is or in the form that the key needs
  kNothing,      ///< the value has another meaning or another scale; an example replaces it
  kList,         ///< one value for each name, in the order of the names
  kTensor,       ///< Ixx, Ixy, Ixz, Iyy, Iyz, Izz, in this order; missing products are 0
  kXyzw,         ///< quaternion with the scalar last
  kBelow,        ///< a distance l, which becomes the vector [0, 0, -l]
  kPosition,     ///< position of a camera, which becomes the key and camera.elevation
  kSymmetric,    ///< a value across the axis of symmetry and one along it, which become [a, a, c]
  kDirected,     ///< a magnitude and a direction, which become a vector
  kReversed,     ///< three values in the opposite order
  kPeriod,       ///< time of a turn, which becomes a rate
  kSlowness,     ///< a factor by which a film is slower, which becomes a speed
  kInches,       ///< size of a picture in inches, and perhaps the pixels of an inch
  kEllipticity,  ///< ellipticity (C - A)/A, which becomes the ratio of the moments
  kLaunch,       ///< speed and angle of a throw, which become a velocity
  kFrames,       ///< number of frames, which becomes a duration
  kInterval,     ///< time from frame to frame, which becomes frames per second
  kEuler,        ///< three Euler angles or their rates, which become three keys
  kSpan,         ///< start and end of a time, which become a duration
  kFilm,         ///< time of the motion that the film shows, which becomes a speed
  kOrbit,        ///< first and last azimuth of a camera, which become an azimuth and an orbit
  kFrame,        ///< true for a camera in the frame of the body
  kEither,       ///< the value of any of the names
  kShown,        ///< names of things that are drawn, each of which becomes a key of [show]
  kPlot,         ///< quantities, which become a [[plot]]
  kArrow,        ///< the name of an arrow that [show] draws
  kPoints,       ///< masses and positions, which become tables
  kRemove,       ///< nothing stands for the name, which is to be left out; the row has no key
};

/// Names in textbooks or in other programs, and the corresponding key of this program.
struct ForeignNames {
  std::string_view names;   ///< separated by blanks; "camera.eye" is the name "eye" in the table [camera] only
  std::string_view key;     ///< path of the key; empty for kRemove
  std::string_view with{};  ///< other keys of the same table that the key needs, "name = value", separated by ";"
  std::string_view note{};  ///< sentence for the message
  Carry carry = Carry::kValue;
  std::string_view unit{};  ///< unit that the names imply for a bare number, such as "rpm"
  double factor = 1;        ///< factor on the value, such as 0.5 for a diameter
  bool own = false;         ///< only for names in a table that has a key of this name
};

/// Returns the table of all foreign names. A name may be in several rows: the first row whose key accepts the
/// value counts, otherwise the first row.
std::span<const ForeignNames> foreignNames();

/// Returns the rows for an unknown name, in the order of foreignNames(). Also finds the name in small letters with
/// underscores, and without "initial". Leaves out rows that are implausible in this table: a name of physics
/// belongs to the top, to [body] or to [motion].
/// @param path  path of the unknown name, such as "motion.w0"
std::vector<const ForeignNames*> plausibleRows(std::string_view path);

/// Returns whether a name of this path may stand for the key of a row. Names of physics belong to the top, to
/// [body] or to [motion], and to tables that have a key of the same name.
bool isPlausible(const ForeignNames& row, std::string_view path);

/// Returns the key of a row. If the table of the name has a key of this name, returns that key:
/// "body.part[0].mass" for the name "body.part[0].m". A key in a table below it comes first.
std::string keyFor(const ForeignNames& row, std::string_view path);

/// Returns the single names of a row.
std::vector<std::string_view> namesIn(const ForeignNames& row);

}  // namespace poinsot::scene

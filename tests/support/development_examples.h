// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <limits>
#include <ostream>

#include "physics/polhode_regime.h"

namespace poinsot::physics {

/// Free motion and its expected values. The values come from an evaluation to 50 digits by two other methods, made
/// before this code, and are rounded to the 16 digits given.
struct Example {
  const char* name;
  Eigen::Vector3d I, omega0;
  Eigen::Quaterniond q0;
  double t_s;
  Eigen::Vector3d omega_B;
  Eigen::Quaterniond q_WB;
  PolhodeRegime regime;
  double L, planeHeight, polhodePeriod, anglePerRadialPeriod, smallestRadius, largestRadius;
};

inline std::ostream& operator<<(std::ostream& out, const Example& e) { return out << e.name; }

inline const Eigen::Quaterniond kLevel = Eigen::Quaterniond::Identity();

inline const Example kExamples[] = {
    {"AboutLargest",
     {2, 3, 4},
     {.5, .25, 1},
     kLevel,
     10,
     {0.5236187680914472, -0.1739669918974871, 1.006025997252955},
     {0.62981435521294, -0.2841657890067688, -0.02424579465704587, -0.7224927845780313},
     PolhodeRegime::kAboutLargest,
     4.190763653560053,
     1.1185312242598,
     11.18295442677762,
     9.205124422942755,
     0.1404323099902769,
     0.2630596897205497},
    {"AboutSmallest",
     {2, 3, 4},
     {1, .25, .25},
     kLevel,
     10,
     {0.9383078325604973, -0.4711028357030931, -0.05206528903395389},
     {0.6434603732916287, -0.7324001062683547, -0.07523597350378131, 0.2094955384547341},
     PolhodeRegime::kAboutSmallest,
     2.358495283014151,
     1.033497933006201,
     15.72394674738379,
     5.503334464491742,
     0.1898649234023409,
     0.254351179419145},
    {"Separatrix",
     {1, 2, 2.25},
     {.75, .5, 1},
     kLevel,
     5,
     {0.1257184405295321, 1.271509805025921, 0.1676245873727094},
     {0.8710409312400317, 0.4751788818785033, 0.05965812938122826, -0.1092411731899947},
     PolhodeRegime::kSeparatrix,
     2.57390753524675,
     1.286953767623375,
     std::numeric_limits<double>::infinity(),
     std::numeric_limits<double>::infinity(),
     0,
     0.4289845892077917},
    {"Flip",
     {1, 2, 3},
     {0x1p-10, 1, 0},
     kLevel,
     40,
     {0.3041872276674735, -0.9526127671820765, 0.1756216727340402},
     {0.1532492622421823, -0.8002233997206524, 0.01605999925539552, 0.5795681587058286},
     PolhodeRegime::kAboutSmallest,
     2.000000238418565,
     1.000000357627833,
     57.62716233737096,
     27.76639028070468,
     0.0004882811917923495,
     0.5773504756660859},
    {"Football",
     {1.5, 1.5, .9},
     {.5, 0, 2},
     kLevel,
     3,
     {-0.3686968577706227, -0.3377315902755755, 2},
     {0.9333625997272972, -0.129467598587728, 0.3330102937202236, 0.0343007670846943},
     PolhodeRegime::kAboutSmallest,
     1.95,
     2.038461538461538,
     7.853981633974483,
     5.105088062083414,
     0.3076923076923077,
     0.3076923076923077},
    {"OddAxisOrder",
     {3, 1, 2},
     {.25, 1, -.5},
     {.5, .5, .5, .5},
     1e5,
     {0.2529408128816368, 1.00221612662323, 0.4955429704236862},
     {0.584543349906213, -0.02175722928891995, 0.1796768396924888, 0.7909184081384196},
     PolhodeRegime::kAboutSmallest,
     1.600781059358212,
     1.054172892748091,
     10.80934530080282,
     3.694946268975696,
     0.3724506842457427,
     0.5334349496690813},
};

}  // namespace poinsot::physics

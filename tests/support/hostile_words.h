// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace poinsot {

/// Names and values that a shell misreads unless they are quoted.
inline const std::vector<std::string> kHostileWords{"",
                                                    "a b",
                                                    "it's",
                                                    "$HOME",
                                                    "`id`",
                                                    "$(id)",
                                                    "a\"b",
                                                    "\\",
                                                    "a\\'b",
                                                    "*",
                                                    "~",
                                                    "!!",
                                                    "a;b&c|d",
                                                    "<a>",
                                                    "{1..3}",
                                                    "-n",
                                                    "#",
                                                    "a=b",
                                                    "\n",
                                                    "a\nb'",
                                                    "\t\x1b[1m",
                                                    "100%",
                                                    "\u00e9\u65e5",
                                                    "'",
                                                    "\x01"
                                                    "2",
                                                    "\x7f",
                                                    "[ab]?",
                                                    "{frame:05}"};

}  // namespace poinsot

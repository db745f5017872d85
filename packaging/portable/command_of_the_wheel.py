#!python
# SPDX-License-Identifier: Apache-2.0
# Starts the program of the wheel without importing the package, which would take longer. pip writes the path of the
# right Python into the first line.
import importlib.util
import os
import sys

package = importlib.util.find_spec("poinsot")
if package is None or not package.submodule_search_locations:
    sys.exit("poinsot: the Python package poinsot is not installed for this Python; install its wheel again")
program = os.path.join(package.submodule_search_locations[0], "portable", "bin", "poinsot")
try:
    os.execv(program, ["poinsot", *sys.argv[1:]])
except OSError as error:
    sys.exit(f"poinsot: {program}: {error.strerror}")

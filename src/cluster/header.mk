@what@
#
#   make -f SCRIPT -j @jobs@
#   @status@
#
# Where a task or the joining fails, the same command goes on with the segment where it stopped. What is newer than the
# scene and the files that it names is not made again.
SHELL := /bin/bash
equals := =

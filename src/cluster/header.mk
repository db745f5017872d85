@what@
#
#   make -f SCRIPT -j @jobs@
#   @status@
#
# If a task or the joining fails, run the same command again: it continues at the segment where it stopped. Outputs that
# are newer than the scene and the files that it names are kept.
SHELL := /bin/bash
equals := =

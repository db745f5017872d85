# SPDX-License-Identifier: Apache-2.0
# Stands for the project's own program: draws a square of one colour.
ffmpeg -v error -y -f lavfi -i color=0x3040$(printf %x 200):size=32x32 -frames:v 1 -pix_fmt rgb24 "$1"

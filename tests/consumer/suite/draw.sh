# SPDX-License-Identifier: Apache-2.0
# Draws plots into a folder: squares of one colour, with file names like those of pytest.
mkdir -p "$1"
ffmpeg -v error -y -f lavfi -i color=0x3040$(printf %x 200):size=32x32 -frames:v 1 -pix_fmt rgb24 "$1/wave.png"
cp "$1/wave.png" "$1/wave[1].png"
cp "$1/wave.png" "$1/wave 2.png"

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of the pages on planes anew:
# scripts/make_plane_pictures.sh [PROGRAM [EXAMPLE]], EXAMPLE being examples/03_planes as built.
# Needs rsvg-convert (librsvg2-bin) and convert (imagemagick), which only crop, scale and count colours.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
straightedge=${1:-build/program/bin/straightedge}
example=${2:-build/release/examples/03_planes}
to=docs/pictures/planes
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# small FROM TO [OPTIONS OF convert]: few colours, no time of making.
small() {
  convert "$1" "${@:3}" +dither -colors 48 -strip -define png:exclude-chunks=date,time \
    -define png:compression-level=9 "PNG8:$to/$2"
}

# look METHOD FRAME NAME CAMERA: labels and cells of one frame.
look() {
  "$example" "$1" "$2" "$(dirname "$2")/$4" "$work/$3-labels.png" "$work/$3-cells.png" >"$work/$3.txt"
}

rm -rf "$to"
mkdir -p "$to"
"$straightedge" planes fixtures/depth/room --method both --svg "$work/map.svg" --quiet
for method in ransac hough; do
  rsvg-convert --width 1000 "$work/map-$method.svg" -o "$work/map-$method.png"
  small "$work/map-$method.png" "map-$method.png"
done

look ransac fixtures/depth/mrpt_office/depth.png office camera.json
look ransac fixtures/depth/room/depth/05.png room ../camera.json
for picture in office-labels office-cells room-labels room-cells; do
  small "$work/$picture.png" "$picture.png"
done
for method in ransac hough; do
  for frame in 00 11; do
    look "$method" "fixtures/depth/room/depth/$frame.png" "corner-$frame-$method" ../camera.json
    small "$work/corner-$frame-$method-labels.png" "corner-$frame-$method.png"
  done
done
for method in ransac hough; do
  "$straightedge" explain fixtures/depth/room/depth/03.png --camera fixtures/depth/room/camera.json --method "$method" \
    -o "$work/explain-$method" --quiet
done
small "$work/explain-ransac/best-triple.png" ransac-triple.png
small "$work/explain-ransac/hypotheses.png" ransac-hypotheses.png -resize "640x>"
small "$work/explain-hough/accumulator.png" hough-accumulator.png -resize "640x>"
small "$work/explain-hough/patches.png" hough-patches.png
for picture in octree-4 octree-2 octree-0 octree-question; do
  small "$work/explain-ransac/$picture.png" "$picture.png" -resize "480x>"
done
du -ch "$to"/*.png | tail -n 1

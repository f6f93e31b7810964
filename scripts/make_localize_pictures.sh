#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of docs/localization.md anew: scripts/make_localize_pictures.sh [PROGRAM]
# Needs rsvg-convert (librsvg2-bin) and convert (imagemagick) for the two that hold too many points for an SVG.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
straightedge=${1:-build/program/bin/straightedge}
to=docs/pictures/localize
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# small NAME: the drawing as a picture of few colours, without a time of making.
small() {
  rsvg-convert --width 900 "$work/$1.svg" -o "$work/$1.png"
  convert "$work/$1.png" +dither -colors 24 -strip -define png:exclude-chunks=date,time \
    -define png:compression-level=9 "PNG8:$to/$1.png"
}

rm -rf "$to"
mkdir -p "$to"
"$straightedge" lines fixtures/maps/mrpt/map.yaml -o "$work/office.xml" --quiet
"$straightedge" lines fixtures/maps/mrpt_corridor/map.yaml -o "$work/corridor.xml" --quiet

# One scan of the simulated run, from a start that is off by half a metre and three degrees.
"$straightedge" localize "$work/office.xml" fixtures/laser2d/mrpt_simul/scans.txt.gz --start "0.4 -0.3 3" \
  --start-sigma "0.5 5" -o "$work/t.txt" --explain "$work/scan" --quiet
for step in readings scan-lines matches pose; do
  cp "$work/scan/$step.svg" "$to/$step.svg"
done

# The whole run beside its truth and beside its odometry; the corridor, start unknown.
"$straightedge" localize "$work/office.xml" fixtures/laser2d/mrpt_simul/scans.txt.gz --start "0 0 0" -o "$work/t.txt" \
  --svg "$work/office-run.svg" --truth fixtures/laser2d/mrpt_simul/groundtruth.txt --quiet
"$straightedge" localize "$work/corridor.xml" fixtures/laser2d/mrpt_corridor/scans.txt.gz -o "$work/t.txt" \
  --svg "$work/corridor-run.svg" --explain "$work/corridor" --quiet
small office-run
small corridor-run
for n in 1 2; do
  cp "$work/corridor/search-$n.svg" "$to/search-$n.svg"
done
du -ch "$to"/* | tail -n 1

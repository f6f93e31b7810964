#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of README.md and docs/line-map.md anew: scripts/make_line_map_pictures.sh [PROGRAM]
# The same program gives the same bytes, so a change in git is a change of what the program does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
straightedge=${1:-build/program/bin/straightedge}
to=docs/pictures/line-map
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$straightedge" explain fixtures/maps/mrpt/map.yaml -o "$work/office" --quiet
"$straightedge" explain fixtures/maps/mrpt_corridor/map.yaml -o "$work/corridor" --quiet
"$straightedge" lines fixtures/maps/mrpt/map.yaml -o "$work/office.xml" --png "$work/office.png" --quiet
"$straightedge" lines fixtures/maps/mrpt_corridor/map.yaml -o "$work/corridor.xml" \
  --png "$work/corridor.png" --quiet

rm -rf "$to"
mkdir -p "$to"
cp "$work/office.png" "$work/corridor.png" "$to/"
for stage in ground edges segments; do
  cp "$work/office/$stage.png" "$to/office-$stage.png"
done
cp "$work/corridor/ground.png" "$to/corridor-ground.png"
du -ch "$to"/*.png | tail -n 1

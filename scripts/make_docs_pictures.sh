#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Makes the pictures of docs/ anew: scripts/make_docs_pictures.sh [PROGRAM [EXAMPLE]], EXAMPLE being
# examples/03_planes as built.
# The same program gives the same bytes, so a change in git is a change of what the program does.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
straightedge=${1:-build/program/bin/straightedge}
to=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for method in standard progressive randomized; do
  "$straightedge" explain fixtures/images/blox.jpg --method "$method" -o "$work/$method"
done

rm -rf "$to"
mkdir -p "$to"
for stage in gray blurred gradient-x gradient-y magnitude direction direction-wheel suppressed strong-weak edges \
  accumulator peaks; do
  cp "$work/standard/$stage.png" "$to/"
done
for method in standard progressive randomized; do
  cp "$work/$method/segments.png" "$to/$method-segments.png"
done
for method in progressive randomized; do
  for moment in 1 2 3 4; do
    cp "$work/$method/progress-$moment.png" "$to/$method-$moment.png"
  done
done
bash scripts/make_line_map_pictures.sh "$straightedge"
bash scripts/make_plane_pictures.sh "$straightedge" "${2:-build/release/examples/03_planes}"
du -ch "$to"/*.png | tail -n 1

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Sets up a fresh Debian 12 or Ubuntu 24.04 machine, builds the program and makes maps of the
# shipped pictures and depth frames, and finds robots in them: scripts/demo.sh [OUTPUT FOLDER, default out/demo]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
out=${1:-out/demo}

bash scripts/install_packages.sh program
launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake --preset program "${launcher[@]}"
cmake --build --preset program --parallel "$(nproc)"
straightedge=build/program/bin/straightedge
mkdir -p "$out"

# run SENTENCE ARGUMENTS: says what comes, shows the command, runs it.
run() {
  echo
  echo "$1"
  shift
  printf '  $ straightedge'
  printf ' %q' "$@"
  echo
  "$straightedge" "$@"
}

run "A floor plan of an office, with its ROS YAML, becomes a line map in metres:" \
  lines fixtures/maps/mrpt/map.yaml -o "$out/office.xml" \
  --svg "$out/office.svg" --png "$out/office.png" --csv "$out/office.csv"
run "A corridor as a robot's laser mapped it; rays and unknown space are no walls:" \
  lines fixtures/maps/mrpt_corridor/map.yaml -o "$out/corridor.xml" \
  --svg "$out/corridor.svg" --png "$out/corridor.png"
run "Every stage of the way, as pictures with a page that explains them:" \
  explain fixtures/maps/mrpt/basic_map.png -o "$out/explain"
run "Twelve depth frames of a room become a map of its planes:" \
  planes fixtures/depth/room -o "$out/room.xml" --html "$out/room.html" --ply "$out/room.ply" \
  --svg "$out/room.svg" --labels "$out/room-labels"
run "A simulated robot drives through the office. Where its laser says it is, and how far that is from the exact truth:" \
  localize "$out/office.xml" fixtures/laser2d/mrpt_simul/scans.txt.gz --start "0 0 0" \
  --truth fixtures/laser2d/mrpt_simul/groundtruth.txt -o "$out/office-run.txt" \
  --covariance "$out/office-run-covariance.txt" --svg "$out/office-run.svg"
run "A real robot in the corridor. Nobody knows where it was switched on:" \
  localize "$out/corridor.xml" fixtures/laser2d/mrpt_corridor/scans.txt.gz -o "$out/corridor-run.txt" \
  --svg "$out/corridor-run.svg" --explain "$out/corridor-scan"
run "The map file of the office keeps every rule of its format:" \
  validate "$out/office.xml"
run "And so does that of the room:" \
  validate "$out/room.xml"

echo
echo "Made in $out:"
(cd "$out" && find . -type f -printf '  %-32P %9s bytes\n' | sort)
echo
echo "Look at $out/office.png, $out/corridor.png and $out/explain/index.html."
echo "$out/office-run.svg and $out/corridor-run.svg show the ways of the robots, with their scans on the walls;"
echo "$out/corridor-scan/index.html shows how a robot finds itself."
echo "Open $out/room.html in a browser and turn the room; room.ply holds its readings, coloured by plane,"
echo "for MeshLab or CloudCompare; room-labels/ has the plane of every pixel as a number in a 16-bit PNG."

#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Sets up a fresh Debian 12 or Ubuntu 24.04 machine, builds everything and runs the tests.
#   scripts/test.sh         release build with all tests; again under the address and undefined
#                           behaviour sanitizers; clang with warnings as errors and the core's tests; the
#                           core on emulated microcontrollers
#   scripts/test.sh --fast  the release build with all tests alone
#   scripts/test.sh --all   the ordinary run, the same bits on other processors (installs their compilers),
#                           then a debug build with GCC's warnings as errors and all tests of clang's build
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

extent=ordinary
for argument in "$@"; do
  case "$argument" in
    --fast) extent=fast ;;
    --all) extent=all ;;
    -h | --help)
      sed -n '5,12s/^# \{0,1\}//p' "$0"
      exit 0
      ;;
    *)
      echo "test.sh: unknown argument '$argument' (--fast, --all, --help)" >&2
      exit 2
      ;;
  esac
done

packages=tests
without=(--label-exclude '^cross$')
if [[ $extent == all ]]; then
  packages=cross
  without=()
fi
bash scripts/install_packages.sh "$packages" || exit 1

jobs=$(nproc)
launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
summary=()
passed=0
failed=0

# A step without tests that did not work: counts as one failure and ends its stage.
broken() {
  summary+=("$(printf '%-10s %s FAILED' "$1" "$2")")
  failed=$((failed + 1))
}

# stage PRESET TARGETS [ctest arguments]: configures, builds and tests one preset, and notes the counts.
stage() {
  local preset=$1 targets=$2 started=$SECONDS tests ran bad cases log
  shift 2
  echo
  echo "== $preset: configure"
  cmake --preset "$preset" "${launcher[@]}" || { broken "$preset" configure; return; }
  echo "== $preset: build"
  # shellcheck disable=SC2086  # a list of words
  cmake --build --preset "$preset" --parallel "$jobs" --target $targets || { broken "$preset" build; return; }
  echo "== $preset: test"
  log=build/$preset/Testing/ctest.log
  mkdir -p "build/$preset/Testing"
  ctest --preset "$preset" --parallel "$jobs" "$@" 2>&1 | tee "$log"
  tests=$(sed -n 's/.* tests* failed out of \([0-9]*\)$/\1/p' "$log")
  bad=$(sed -n 's/.*, \([0-9]*\) tests* failed out of .*/\1/p' "$log")
  if [[ -z $tests || $tests == 0 ]]; then
    broken "$preset" "no test ran:"
    return
  fi
  ran=$((tests - bad))
  cases=$(sed -n 's/^All tests passed (.* in \([0-9]*\) test cases*)$/\1/p' \
    "build/$preset/Testing/Temporary/LastTest.log" | awk '{n += $1} END {print n + 0}')
  passed=$((passed + ran))
  failed=$((failed + bad))
  summary+=("$(printf '%-10s %3d of %3d tests passed (%d test cases in those), %d s' "$preset" "$ran" \
    "$tests" "$cases" "$((SECONDS - started))")")
}

stage release all "${without[@]}"
if [[ $extent != fast ]]; then
  stage asan all --label-exclude install
fi
if [[ $extent == ordinary ]]; then
  stage clang "straightedge straightedge_program core_tests" --label-regex '^core$'
fi
if [[ $extent != fast ]]; then
  stage firmware all
fi
if [[ $extent == all ]]; then
  stage clang all --label-exclude install
  stage dev all --label-exclude install
fi

echo
echo "Summary"
printf '  %s\n' "${summary[@]}"
echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))

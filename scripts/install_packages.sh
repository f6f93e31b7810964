#!/usr/bin/env bash
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
#
# Installs the Debian or Ubuntu packages that are missing here: install_packages.sh [program|tests|cross]
#   program  what the library and the program are built from
#   tests    that, and what the tests, examples, benchmarks, the second compiler and the emulated boards
#            need (default)
#   cross    compilers and emulators for i686, aarch64 and WebAssembly, and what `tests` names
set -euo pipefail

packages=(g++ cmake ninja-build pkg-config libeigen3-dev libtinyxml2-dev libstb-dev libpng-dev
  zlib1g-dev libyaml-cpp-dev libcli11-dev nlohmann-json3-dev)
tests=(binutils ccache catch2 clang libbenchmark-dev libxml2-utils
  gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib libnewlib-arm-none-eabi qemu-system-arm)
# Clang's library for WebAssembly comes in versions: the newest of Debian 12, and that of Ubuntu 24.04.
llvm=$(grep -q '^ID=ubuntu' /etc/os-release 2>/dev/null && echo 18 || echo 19)
cross=(g++-i686-linux-gnu g++-aarch64-linux-gnu qemu-user wasi-libc "clang-$llvm" "lld-$llvm"
  "libc++-$llvm-dev-wasm32" "libc++abi-$llvm-dev-wasm32" "libclang-rt-$llvm-dev-wasm32")
command -v node >/dev/null || cross+=(nodejs)
case "${1:-tests}" in
  program) ;;
  tests) packages+=("${tests[@]}") ;;
  cross) packages+=("${tests[@]}" "${cross[@]}") ;;
  *)
    echo "install_packages.sh: '$1' is none of 'program', 'tests' and 'cross'" >&2
    exit 2
    ;;
esac

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This machine has no apt-get. Install by hand what these packages of Debian are: ${packages[*]}" >&2
  echo "Then run cmake with a preset (cmake --list-presets)." >&2
  exit 1
fi

missing=()
for package in "${packages[@]}"; do
  state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $state == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "Missing packages: ${missing[*]}. Neither root nor sudo is at hand to install them." >&2
    exit 1
  fi
  as_root=(sudo)
fi

echo "Installing: ${missing[*]}"
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y -o Acquire::Retries=3
  -o DPkg::Lock::Timeout=300)
"${apt[@]}" update </dev/null
"${apt[@]}" install --no-install-recommends "${missing[@]}" </dev/null

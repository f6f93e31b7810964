// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT

// Linked with every object of the core, called or not: so all of it keeps the linker script's promises, and
// nothing is missing.
int main() {
  return 0;
}

# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT

# The folders whose tests need nothing but the core, on a computer and on an emulated board.
set(core_modules base canny fit hough ransac octree workspace)

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Makes fixtures/golden/hough: edge images, and what OpenCV's HoughLines and HoughLinesP find in them.

Needs Debian 12's python3-opencv (4.6.0, no IPP). IMAGES is a folder with the pictures named below.
The layout of hough.golden, all little endian, is described in the SOURCE.md that this writes.
"""
import argparse
import math
import pathlib
import struct

import cv2
import numpy as np

PICTURES = [  # path, every how many pixels
    ("opencv/building.jpg", 3),
    ("opencv/sudoku.png", 2),
    ("opencv/home.jpg", 2),
    ("opencv/board.jpg", 2),
    ("opencv/blox.jpg", 1),
    ("opencv/left01.jpg", 2),
    ("opencv/pic1.png", 2),
    ("opencv/pic3.png", 1),
    ("skimage/camera.png", 2),
    ("skimage/brick.png", 2),
    ("skimage/coins.png", 2),
    ("skimage/page.png", 1),
]
BLUR, SIGMA, LOW, HIGH = 5, 1.4, 50, 150
NOISE_SIZES = [(1, 100), (100, 1), (63, 65), (129, 31), (64, 64), (257, 123)]
NOISE_SEED = 20261122


def edge_images(folder):
    """Yields (name, image with values 0 and 255)."""
    for path, step in PICTURES:
        gray = cv2.cvtColor(cv2.imread(str(folder / path), cv2.IMREAD_COLOR), cv2.COLOR_BGR2GRAY)
        small = gray[::step, ::step].copy()
        blurred = cv2.GaussianBlur(small, (BLUR, BLUR), SIGMA)
        yield pathlib.Path(path).stem, cv2.Canny(blurred, LOW, HIGH)
    random = np.random.default_rng(NOISE_SEED)

    def noise(width, height, share):
        return (random.random((height, width)) < share).astype(np.uint8) * 255

    for width, height in NOISE_SIZES:
        for percent in (5, 40):
            yield f"noise{percent}_{width}x{height}", noise(width, height, percent / 100)
    for height in range(1, 10):
        for width in range(1, 10):
            yield f"noise50_{width}x{height}", noise(width, height, 0.5)
    yield "blank_20x10", np.zeros((10, 20), np.uint8)
    yield "full_17x13", np.full((13, 17), 255, np.uint8)


def thresholds(image):
    """One for which a picture gives tens of lines, one for hundreds."""
    side = max(image.shape)
    return max(1, side // 4), max(1, side // 7)


def standard_cases(image):
    high, low = thresholds(image)
    tau = math.pi
    yield from [(1, tau / 180, high, 0, tau), (1, tau / 180, low, 0, tau), (2, tau / 90, high, 0, tau),
                (0.5, tau / 360, high, 0, tau), (1.7, 0.013, high, 0, tau),
                (1, tau / 180, high, 0.3, 2.0), (1, 0.02, high, tau / 2, tau)]


def progressive_cases(image):
    high, low = thresholds(image)
    tau = math.pi
    yield from [(1, tau / 180, low, low, 3), (1, tau / 180, high, 10, 10), (0.5, tau / 360, low, 7.5, 2.5),
                (2, tau / 90, high, 5, 0), (1.7, 0.013, low, low, 20)]


def standard_lines(image, case):
    rho, theta, threshold, low, high = case
    found = cv2.HoughLinesWithAccumulator(image, rho, theta, threshold, min_theta=low, max_theta=high)
    return [] if found is None else found.reshape(-1, 3)


def progressive_lines(image, case):
    rho, theta, threshold, length, gap = case
    found = cv2.HoughLinesP(image, rho, theta, threshold, minLineLength=length, maxLineGap=gap)
    return [] if found is None else found.reshape(-1, 4)


def write(images, out):
    data = [b"SEHG", struct.pack("<II", 1, len(images))]
    for name, image in images:
        height, width = image.shape
        data.append(struct.pack("<32sHH", name.encode(), width, height))
        data.append(np.packbits(image != 0, axis=1).tobytes())
    cases = []
    for index, (_, image) in enumerate(images):
        for rho, theta, threshold, low, high in standard_cases(image):
            lines = standard_lines(image, (rho, theta, threshold, low, high))
            cases.append(struct.pack("<HHidddddII", index, 0, threshold, rho, theta, low, high, 0, len(lines), 12)
                         + b"".join(struct.pack("<ffi", r, t, int(v)) for r, t, v in lines))
        for rho, theta, threshold, length, gap in progressive_cases(image):
            lines = progressive_lines(image, (rho, theta, threshold, length, gap))
            cases.append(struct.pack("<HHidddddII", index, 1, threshold, rho, theta, length, gap, 0, len(lines), 8)
                         + b"".join(struct.pack("<4H", *line) for line in lines))
    data.append(struct.pack("<I", len(cases)))
    (out / "hough.golden").write_bytes(b"".join(data + cases))
    return len(cases)


SOURCE = """# Golden lines

Made by `scripts/make_goldens_hough.py` with OpenCV {version} (Debian package python3-opencv, built without
IPP; x86-64). `hough.golden` holds {images} edge images and {cases} results of `HoughLines` (with votes) and
`HoughLinesP`.

Edge images: pictures from the Debian packages opencv-doc 4.6.0 (samples/data: building, sudoku, home, board,
blox, left01, pic1, pic3; Apache-2.0 and BSD-3-Clause) and python3-skimage 0.19.3 (skimage/data: camera,
brick: CC0; coins, page: public domain), each gray, every n-th pixel (`PICTURES`), GaussianBlur {blur}x{blur} sigma
{sigma}, Canny {low}/{high}. Noise from NumPy's default_rng({seed}); its name tells percent and size.

Parameters are in the file, one set a case: see `standard_cases` and `progressive_cases` in the script.

## Layout, little endian, no padding

| what | type |
| --- | --- |
| `SEHG`, version 1 | 4 bytes, u32 |
| number of images | u32 |
| each image: name, width, height | 32 bytes (zeros at the end), u16, u16 |
| its pixels: a bit each, highest first, each row from a new byte | height * ceil(width / 8) bytes |
| number of cases | u32 |
| each case: image index, method (0 standard, 1 progressive), threshold | u16, u16, i32 |
| rho, theta, then (standard) min_theta, max_theta or (progressive) min_length, max_gap, then 0 | 5 f64 |
| number of lines, bytes a line | u32, u32 |
| standard: rho, theta, votes | f32, f32, i32 |
| progressive: x0, y0, x1, y1 | 4 u16 |
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("images", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    arguments = parser.parse_args()
    if not cv2.__version__.startswith("4.6."):
        raise SystemExit(f"OpenCV {cv2.__version__} found; the goldens are those of 4.6")
    images = list(edge_images(arguments.images))
    cases = write(images, arguments.out)
    text = SOURCE.format(version=cv2.__version__, images=len(images), cases=cases, blur=BLUR, sigma=SIGMA,
                         low=LOW, high=HIGH, seed=NOISE_SEED)
    (arguments.out / "SOURCE.md").write_text(text)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Makes fixtures/golden/canny: gray pictures and what OpenCV 4.6.0 makes of them.

Needs Debian 12's python3-opencv and nothing else; tests need neither. Run it again only to change the
goldens: what it writes depends on the images, the parameters below and OpenCV alone, so a second run
gives the same bytes.

  scripts/make_goldens_canny.py IMAGES    IMAGES holds opencv/*.jpg|png and skimage/*.png, the pictures
                                          of the Debian packages opencv-doc and python3-skimage
"""

import argparse
import hashlib
import json
from pathlib import Path

import cv2
import numpy as np

OUTPUT = Path(__file__).resolve().parent.parent / "fixtures/golden/canny"

# name, file, pixels kept of every row and column (decimation), crop x, y, width, height after that
PICTURES = [
    ("blox", "opencv/blox.jpg", 1, 29, 41, 200, 200),
    ("board", "opencv/board.jpg", 2, 20, 10, 257, 193),
    ("building", "opencv/building.jpg", 1, 301, 203, 255, 191),
    ("home", "opencv/home.jpg", 2, 0, 0, 256, 192),
    ("left01", "opencv/left01.jpg", 2, 30, 20, 241, 201),
    ("pic1", "opencv/pic1.png", 1, 101, 51, 219, 187),
    ("pic3", "opencv/pic3.png", 1, 90, 60, 223, 189),
    ("pic5", "opencv/pic5.png", 1, 80, 40, 229, 211),
    ("sudoku", "opencv/sudoku.png", 2, 30, 12, 223, 201),
    ("brick", "skimage/brick.png", 2, 3, 5, 193, 191),
    ("camera", "skimage/camera.png", 2, 20, 10, 224, 217),
    ("coins", "skimage/coins.png", 1, 17, 31, 239, 199),
    ("page", "skimage/page.png", 1, 40, 7, 251, 177),
]
ODD_SIZES = [(1, 100), (100, 1), (2, 77), (77, 2), (63, 65), (129, 31), (257, 123)]
BORDERS = {"constant": cv2.BORDER_CONSTANT, "replicate": cv2.BORDER_REPLICATE,
           "reflect": cv2.BORDER_REFLECT, "reflect_101": cv2.BORDER_REFLECT_101}
# kernel size (0 = automatic), sigma, border
BLURS = [(0, 1.4, "reflect_101"), (5, 0, "reflect_101"), (9, 0, "replicate"), (7, 2.25, "constant"),
         (0, 3.3, "reflect"), (31, 0, "reflect_101"), (3, 0.8, "reflect")]
SOBELS = [(3, "reflect_101"), (5, "replicate"), (7, "reflect_101")]
# thresholds for aperture 3; those of 5 and 7 are 10 and 120 times as large
THRESHOLDS = [(50.0, 150.0), (20.5, 60.75)]
EXTREME_THRESHOLDS = [(0.0, 0.0), (33.3, 99.9), (-7.5, 40.0), (1e5, 2e5)]
GAIN = {3: 1, 5: 10, 7: 120}
CROP = (48, 32)  # of blurred pictures and gradients that are larger


class Pack:
    """A file of records: a line `kind key=value ... bytes=N`, then N bytes."""

    def __init__(self):
        self.data = bytearray()
        self.counts = {}

    def add(self, kind, payload, **fields):
        words = [kind] + [f"{key}={value}" for key, value in fields.items()] + [f"bytes={len(payload)}"]
        self.data += " ".join(words).encode() + b"\n" + payload
        self.counts[kind] = self.counts.get(kind, 0) + 1


def window(image):
    """The whole of a small picture, a piece from the middle of the left side and one corner of others."""
    height, width = image.shape
    if width * height <= 2 * CROP[0] * CROP[1]:
        return [(0, 0, width, height)]
    w, h = min(width, CROP[0]), min(height, CROP[1])
    return [(0, (height - h) // 2, w, h), (width - w, height - h, w, h)]


def add_blurs(pack, gray, blurs):
    for size, sigma, border in blurs:
        blurred = cv2.GaussianBlur(gray, (size, size), sigma, borderType=BORDERS[border])
        for x, y, w, h in window(gray):
            pack.add("blur", blurred[y:y + h, x:x + w].tobytes(), size=size, sigma=repr(float(sigma)),
                     border=border, x=x, y=y, width=w, height=h)


def add_sobels(pack, gray, sobels):
    for aperture, border in sobels:
        for axis in "xy":
            gradient = cv2.Sobel(gray, cv2.CV_16S, int(axis == "x"), int(axis == "y"), ksize=aperture,
                                 borderType=BORDERS[border])
            for x, y, w, h in window(gray):
                pack.add("sobel", gradient[y:y + h, x:x + w].astype("<i2").tobytes(), axis=axis,
                         aperture=aperture, border=border, x=x, y=y, width=w, height=h)


def add_edges(pack, gray, sigma, aperture, norm, low, high):
    source = cv2.GaussianBlur(gray, (0, 0), sigma) if sigma > 0 else gray
    edges = cv2.Canny(source, low, high, apertureSize=aperture, L2gradient=norm == "l2")
    pack.add("canny", np.packbits(edges > 0).tobytes(), sigma=repr(float(sigma)), aperture=aperture,
             norm=norm, low=repr(low), high=repr(high))


def add_canny(pack, gray, thresholds, extremes):
    for aperture, gain in GAIN.items():
        for norm in ("l1", "l2"):
            for low, high in thresholds:
                add_edges(pack, gray, 0, aperture, norm, low * gain, high * gain)
            add_edges(pack, gray, 1.4, aperture, norm, thresholds[0][0] * gain, thresholds[0][1] * gain)
            for low, high in extremes:
                add_edges(pack, gray, 0, aperture, norm, low, high)


def picture(folder, file, step, x, y, w, h):
    image = cv2.imread(str(folder / file), cv2.IMREAD_COLOR)
    gray = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)[::step, ::step]
    gray = np.ascontiguousarray(gray[y:y + h, x:x + w])
    assert gray.shape == (h, w), (file, gray.shape)
    return gray


def noise(rng, width, height):
    """Any byte, faint noise on an even ground and, for small sizes, black and white."""
    yield "bytes", rng.integers(0, 256, (height, width), dtype=np.uint8)
    yield "faint", rng.integers(120, 137, (height, width), dtype=np.uint8)
    if width * height < 3000:
        yield "binary", rng.integers(0, 2, (height, width), dtype=np.uint8) * np.uint8(255)


def inline_image(pack, name, gray):
    pack.add("image", gray.tobytes(), name=name, width=gray.shape[1], height=gray.shape[0])


def pictures_pack(folder):
    pack = Pack()
    for name, *where in PICTURES:
        gray = picture(folder, *where)
        height, width = gray.shape
        (OUTPUT / f"{name}.pgm").write_bytes(b"P5\n%d %d\n255\n" % (width, height) + gray.tobytes())
        pack.add("image", b"", name=name, width=width, height=height, file=f"{name}.pgm")
        add_blurs(pack, gray, BLURS[:4])
        add_sobels(pack, gray, SOBELS)
        add_canny(pack, gray, THRESHOLDS, [])
    return pack


def small_pack():
    pack = Pack()
    rng = np.random.Generator(np.random.PCG64(46))
    for height in range(1, 10):
        for width in range(1, 10):
            gray = rng.integers(0, 256, (height, width), dtype=np.uint8)
            inline_image(pack, f"{width}x{height}", gray)
            add_blurs(pack, gray, BLURS)
            add_sobels(pack, gray, SOBELS)
            add_canny(pack, gray, THRESHOLDS[:1], EXTREME_THRESHOLDS)
    for width, height in ODD_SIZES:
        for kind, gray in noise(rng, width, height):
            inline_image(pack, f"{width}x{height}-{kind}", gray)
            add_blurs(pack, gray, BLURS)
            add_sobels(pack, gray, SOBELS)
            add_canny(pack, gray, THRESHOLDS, EXTREME_THRESHOLDS)
    return pack


def gray_pack():
    """Colours and their gray values: every corner of the cube and random ones, in all four orders."""
    pack = Pack()
    rng = np.random.Generator(np.random.PCG64(47))
    corners = np.array([[r, g, b, 77] for r in (0, 255) for g in (0, 255) for b in (0, 255)], np.uint8)
    colors = np.concatenate([corners, rng.integers(0, 256, (1992, 4), dtype=np.uint8)]).reshape(40, 50, 4)
    for order, code in (("rgb", cv2.COLOR_RGB2GRAY), ("bgr", cv2.COLOR_BGR2GRAY),
                        ("rgba", cv2.COLOR_RGBA2GRAY), ("bgra", cv2.COLOR_BGRA2GRAY)):
        color = np.ascontiguousarray(colors[:, :, :len(order)])
        pack.add("color", color.tobytes(), order=order, width=50, height=40)
        pack.add("gray", cv2.cvtColor(color, code).tobytes(), width=50, height=40)
    return pack


def build_flags():
    """The lines of OpenCV's own description that can change results."""
    wanted = ("Baseline", "Dispatched", "Intel IPP", "Parallel framework", "OpenCL")
    lines = [line.strip() for line in cv2.getBuildInformation().splitlines()]
    return [" ".join(line.split()) for line in lines if line.startswith(wanted)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("images", type=Path)
    arguments = parser.parse_args()
    assert cv2.__version__ == "4.6.0", f"goldens are those of OpenCV 4.6.0, not {cv2.__version__}"
    assert "IPP" not in " ".join(build_flags()), "an OpenCV with IPP takes other paths"
    cv2.setNumThreads(1)
    cv2.ocl.setUseOpenCL(False)
    OUTPUT.mkdir(parents=True, exist_ok=True)
    packs = {"pictures.golden": pictures_pack(arguments.images), "small.golden": small_pack(),
             "gray.golden": gray_pack()}
    files = {}
    for name, pack in packs.items():
        (OUTPUT / name).write_bytes(pack.data)
        files[name] = {"records": pack.counts, "sha256": hashlib.sha256(pack.data).hexdigest()}
    index = {"opencv": cv2.__version__, "build": build_flags(), "ipp": False, "threads": 1, "opencl": False,
             "borders": list(BORDERS), "blurs": BLURS, "sobels": SOBELS, "thresholds": THRESHOLDS,
             "extreme_thresholds": EXTREME_THRESHOLDS, "threshold_gain": GAIN,
             "pictures": [dict(zip(("name", "file", "step", "x", "y", "width", "height"), p)) for p in PICTURES],
             "files": files}
    (OUTPUT / "index.json").write_text(json.dumps(index, indent=1) + "\n")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-FileCopyrightText: 2026 Straightedge contributors
# SPDX-License-Identifier: MIT
"""Renders fixtures/depth/room: a furnished room seen by a depth camera whose path is known.

    make_depth_room.py [OUT_DIR] [--seed 5]

OUT_DIR (default fixtures/depth/room) gets depth/*.png, depth.txt, groundtruth.txt, camera.json as in TUM RGB-D
sets, labels/*.png (16 bits; the plane that each pixel looks at, 0 = none, also where there is no reading) and
truth.json (each plane's id, name, normal and distance: normal . x = distance, metres, world frame).

World: origin in the middle of the floor, x east, y north, z up. The camera: 640x480, 525 pixels focal length,
5000 units a metre, readings from 0.6 to 5 m. Its noise after Khoshelham and Oude Elberink (Sensors 12(2), 2012,
10.3390/s120201437): Gaussian in inverse depth, shared by neighbours, then the sensor's steps; no readings in
the shadow of the projector, at half of the pixels beside edges, and at grazing angles; small blobs without
readings everywhere, and in the north-west corner blobs over half of the area. The same seed gives the same bytes.

Needs numpy and python3-opencv (for writing PNG).
"""
import argparse
import json
import math
import os

import cv2
import numpy as np

WIDTH, HEIGHT, FOCAL, CX, CY = 640, 480, 525.0, 319.5, 239.5
UNITS_PER_METRE = 5000.0
NEAREST_M, FARTHEST_M = 0.6, 5.0
PROJECTOR_M = 0.075          # from the camera to its left
STEP = 2.85e-3               # of inverse depth, 1/m
NOISE = 1.163e-3             # with the steps' own step/sqrt(12): 1.425e-3 in all
WEST, EAST, SOUTH, NORTH, CEILING = -2.7, 2.7, -2.2, 2.2, 2.5
CORRIDOR, WALL, DOOR = 3.95, 0.14, (-0.35, 0.55, 2.05)
WINDOW, NICHE = (-0.5, 0.8, 0.85, 2.05), 0.2
FRAMES, FRAME_S, POSES_A_FRAME = 12, 0.5, 5


class Room:
    """Flat patches with holes, one ball, one pillar."""

    def __init__(self):
        self.planes, self.names, self.patches = [], [], []
        self.ball = (np.array([-2.1, 0.35, 0.24]), 0.24)
        self.pillar = (1.95, 1.2, 0.17)
        for build in (self.build_walls, self.build_openings, self.build_furniture, self.build_dark_corner):
            build()

    def plane_id(self, normal, point, name):
        distance = float(normal @ point)
        leading = next(c for c in normal if abs(c) > 1e-9)
        if distance < -1e-9 or (abs(distance) <= 1e-9 and leading < 0):
            normal, distance = -normal, -distance
        for i, (n, d) in enumerate(self.planes):
            if abs(d - distance) < 1e-6 and n @ normal > 1 - 1e-9:
                return i + 1
        self.planes.append((normal, abs(distance)))
        self.names.append(name)
        return len(self.planes)

    def patch(self, name, origin, along, up, holes=()):
        """A rectangle; holes are (a0, a1, b0, b1) in metres along its sides."""
        origin, along, up = (np.asarray(a, float) for a in (origin, along, up))
        normal = np.cross(along, up)
        normal /= math.sqrt(normal @ normal)
        self.patches.append((self.plane_id(normal, origin, name), origin, along, up, normal, holes))

    def box(self, name, base, size, axes):
        """`base`: the middle of its lowest face; `axes`: three unit vectors, the last one up."""
        x, y, z = (np.asarray(a, float) * s for a, s in zip(axes, size))
        corner = np.asarray(base, float) - x / 2 - y / 2
        self.patch(name + ", lower side", corner, y, x)
        self.patch(name + ", upper side", corner + z, x, y)
        for side, origin, along in (("first", corner, x), ("second", corner + x, y),
                                    ("third", corner + x + y, -x), ("fourth", corner + y, -y)):
            self.patch(f"{name}, {side} side", origin, along, z)

    def upright(self, name, x, y, z, size, degrees=0.0):
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        self.box(name, (x, y, z), size, ((c, s, 0), (-s, c, 0), (0, 0, 1)))

    def build_walls(self):
        wide, deep = EAST - WEST, NORTH - SOUTH
        self.patch("floor", (WEST, -4, 0), (CORRIDOR - WEST, 0, 0), (0, 8, 0))
        self.patch("ceiling", (WEST, -4, CEILING), (CORRIDOR - WEST, 0, 0), (0, 8, 0))
        self.patch("west wall", (WEST, SOUTH, 0), (0, deep, 0), (0, 0, CEILING))
        self.patch("south wall", (WEST, SOUTH, 0), (wide, 0, 0), (0, 0, CEILING))
        self.patch("east wall", (EAST, SOUTH, 0), (0, deep, 0), (0, 0, CEILING),
                   [(DOOR[0] - SOUTH, DOOR[1] - SOUTH, 0, DOOR[2])])
        self.patch("north wall", (WEST, NORTH, 0), (wide, 0, 0), (0, 0, CEILING),
                   [(WINDOW[0] - WEST, WINDOW[1] - WEST, WINDOW[2], WINDOW[3])])
        self.patch("corridor wall", (CORRIDOR, -4, 0), (0, 8, 0), (0, 0, CEILING))

    def build_openings(self):
        for y in DOOR[:2]:
            self.patch("door frame", (EAST, y, 0), (WALL, 0, 0), (0, 0, DOOR[2]))
        self.patch("lintel", (EAST, DOOR[0], DOOR[2]), (WALL, 0, 0), (0, DOOR[1] - DOOR[0], 0))
        x0, x1, z0, z1 = WINDOW
        self.patch("shutter", (x0, NORTH + NICHE, z0), (x1 - x0, 0, 0), (0, 0, z1 - z0))
        for x in (x0, x1):
            self.patch("window frame", (x, NORTH, z0), (0, NICHE, 0), (0, 0, z1 - z0))
        for z in (z0, z1):
            self.patch("window sill", (x0, NORTH, z), (x1 - x0, 0, 0), (0, NICHE, 0))

    def build_furniture(self):
        self.upright("cupboard", -1.55, SOUTH + 0.28, 0, (1.2, 0.56, 1.95))
        c, s = math.cos(math.radians(48)), math.sin(math.radians(48))
        hinge = np.array([-0.95, SOUTH + 0.56, 0.06])
        self.box("cupboard door", hinge + 0.29 * np.array([-c, s, 0]), (0.58, 0.02, 1.85),
                 ((-c, s, 0), (-s, -c, 0), (0, 0, 1)))
        self.upright("table top", 0.9, -1.6, 0.71, (1.4, 0.8, 0.03))
        for x in (0.25, 1.55):
            for y in (-1.95, -1.25):
                self.upright("table leg", x, y, 0, (0.05, 0.05, 0.71))
        self.upright("drawers", 1.25, -1.65, 0, (0.42, 0.55, 0.58))
        self.upright("carton on the table", 0.5, -1.62, 0.74, (0.36, 0.26, 0.24), 28)
        c, s = math.cos(math.radians(12)), math.sin(math.radians(12))
        self.box("screen", (1.1, -1.75, 0.80), (0.56, 0.03, 0.36), ((1, 0, 0), (0, c, s), (0, -s, c)))
        self.upright("large carton", 2.15, -1.35, 0, (0.62, 0.5, 0.52), 17)
        self.upright("small carton", 2.1, -1.32, 0.52, (0.4, 0.32, 0.3), 55)
        self.upright("bench", 2.15, 1.9, 0, (1.0, 0.42, 0.44))
        self.upright("radiator", 0.1, NORTH - 0.06, 0.14, (1.2, 0.12, 0.56))
        c, s = math.cos(math.radians(15)), math.sin(math.radians(15))
        self.box("leaning board", (1.3, 1.72, 0.01), (0.6, 0.025, 1.7), ((1, 0, 0), (0, c, -s), (0, s, c)))
        for y in (-1.75, -0.75):
            self.upright("shelf, upright board", WEST + 0.16, y, 0, (0.32, 0.03, 1.8))
        for z in (0.08, 0.5, 0.92, 1.34, 1.77):
            self.upright("shelf, board", WEST + 0.16, -1.25, z, (0.32, 1.0, 0.03))
        for y, z, width, high, deep in ((-1.5, 0.53, 0.4, 0.3, 0.22), (-1.05, 0.95, 0.5, 0.28, 0.2),
                                        (-1.45, 1.37, 0.45, 0.25, 0.24)):
            self.upright("books", WEST + deep / 2 + 0.01, y, z, (deep, width, high))

    def build_dark_corner(self):
        """A slanting wall across the north-west corner, and a chest and a tilted picture before it."""
        h = math.sqrt(0.5)
        self.patch("slanting wall", (WEST, NORTH - 1.1, 0), (1.1, 1.1, 0), (0, 0, CEILING))
        self.box("chest", (WEST + 0.79, NORTH - 0.79, 0), (0.85, 0.4, 0.8), ((h, h, 0), (-h, h, 0), (0, 0, 1)))
        c, s = math.cos(math.radians(10)), math.sin(math.radians(10))
        self.box("picture", (WEST + 0.67, NORTH - 0.67, 1.25), (0.7, 0.03, 0.5),
                 ((h, h, 0), (-h * c, h * c, s), (h * s, -h * s, c)))

    def in_dark_corner(self, points):
        x, y = points[..., 0] - WEST, points[..., 1] - NORTH
        return x - y < 2.05


def camera_pose(turn):
    """On an ellipse around the middle, looking across it: rotation (camera to world) and position."""
    angle = 2 * math.pi * turn
    position = np.array([0.85 * math.cos(angle), 0.55 * math.sin(angle), 1.3 + 0.08 * math.sin(3 * angle)])
    yaw, roll = angle + math.pi + 0.12 * math.sin(2 * angle), math.radians(1.5 * math.sin(5 * angle))
    down = math.radians(4 + 6 * math.cos(2 * angle))
    forward = np.array([math.cos(yaw) * math.cos(down), math.sin(yaw) * math.cos(down), -math.sin(down)])
    right = np.array([math.sin(yaw), -math.cos(yaw), 0.0])
    below = np.cross(forward, right)
    c, s = math.cos(roll), math.sin(roll)
    return np.stack([c * right + s * below, c * below - s * right, forward], axis=1), position


def quaternion(r):
    """x y z w; the largest of the four comes from the root, so that nothing is divided by a small number."""
    squares = [1 + r[0, 0] - r[1, 1] - r[2, 2], 1 - r[0, 0] + r[1, 1] - r[2, 2],
               1 - r[0, 0] - r[1, 1] + r[2, 2], 1 + r[0, 0] + r[1, 1] + r[2, 2]]
    sums = np.array([[squares[0], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0], r[2, 1] - r[1, 2]],
                     [r[0, 1] + r[1, 0], squares[1], r[1, 2] + r[2, 1], r[0, 2] - r[2, 0]],
                     [r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], squares[2], r[1, 0] - r[0, 1]],
                     [r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1], squares[3]]])
    row = sums[int(np.argmax(squares))]
    return row / math.sqrt(float(row @ row))


def dot(rays, v):
    """Spelled out: a matrix product may round differently on another machine."""
    return rays[..., 0] * v[0] + rays[..., 1] * v[1] + rays[..., 2] * v[2]


def render(room, rotation, position):
    """Depth along the optical axis (inf: nothing), label and cosine of incidence of every pixel; its ray."""
    v, u = np.mgrid[0:HEIGHT, 0:WIDTH]
    a, b = (u - CX) / FOCAL, (v - CY) / FOCAL
    rays = np.stack([a * rotation[i, 0] + b * rotation[i, 1] + rotation[i, 2] for i in range(3)], axis=-1)
    length = np.sqrt(dot(rays * rays, (1, 1, 1)))
    depth = np.full((HEIGHT, WIDTH), np.inf)
    label, cosine = np.zeros((HEIGHT, WIDTH), np.uint16), np.ones((HEIGHT, WIDTH))

    def put(t, hit, plane, slope):
        hit = hit & (t > 0.05) & (t < depth)
        depth[hit], label[hit], cosine[hit] = t[hit], plane, slope[hit]

    with np.errstate(divide="ignore", invalid="ignore"):
        for plane, origin, along, up, normal, holes in room.patches:
            across = dot(rays, normal)
            t = float(normal @ (origin - position)) / across
            wide, high = math.sqrt(along @ along), math.sqrt(up @ up)
            x = t * dot(rays, along / wide) + float((position - origin) @ along) / wide
            y = t * dot(rays, up / high) + float((position - origin) @ up) / high
            hit = (x >= 0) & (x <= wide) & (y >= 0) & (y <= high)
            for x0, x1, y0, y1 in holes:
                hit &= ~((x > x0) & (x < x1) & (y > y0) & (y < y1))
            put(t, hit, plane, np.abs(across) / length)
        centre, radius = room.ball
        p = position - centre
        half, square = dot(rays, p), length * length
        root = half * half - square * (float(p @ p) - radius ** 2)
        t = (-half - np.sqrt(root)) / square
        put(t, root > 0, 0, np.sqrt(np.maximum(root, 0)) / (length * radius))
        px, py, radius = room.pillar
        qx, qy = position[0] - px, position[1] - py
        square = rays[..., 0] ** 2 + rays[..., 1] ** 2
        half = rays[..., 0] * qx + rays[..., 1] * qy
        root = half * half - square * (qx * qx + qy * qy - radius ** 2)
        t = (-half - np.sqrt(root)) / square
        z = position[2] + t * rays[..., 2]
        put(t, (root > 0) & (z > 0) & (z < CEILING), 0, np.sqrt(np.maximum(root, 0)) / (length * radius))
    return depth, label, cosine, rays


def smooth(field, weights):
    """A separable filter by plain sums, the same bits everywhere; edges are mirrored."""
    half = len(weights) // 2
    for axis in (0, 1):
        wide = np.pad(field, [(half, half) if i == axis else (0, 0) for i in (0, 1)], mode="reflect")
        parts = [np.take(wide, np.arange(i, i + field.shape[axis]), axis=axis) * w for i, w in enumerate(weights)]
        field = sum(parts[1:], parts[0])
    return field


def blobs(chance, cell):
    """A field whose high and low places are blobs of about `cell` pixels."""
    coarse = chance.standard_normal((HEIGHT // cell + 2, WIDTH // cell + 2))
    fine = np.repeat(np.repeat(coarse, cell, axis=0), cell, axis=1)[:HEIGHT, :WIDTH]
    return smooth(fine, [1 / (cell + 1)] * (cell + 1))


def measured(room, chance, depth, cosine, rays, position):
    """What the sensor makes of the true depth: 16-bit values, 0 = no reading."""
    white, shared = chance.standard_normal((2, HEIGHT, WIDTH))
    shared = smooth(shared, [w / 16 for w in (1, 4, 6, 4, 1)]) * (256 / 70)  # unit variance again
    uniform = chance.random_sample((HEIGHT, WIDTH))
    inverse = 1 / depth + NOISE * math.sqrt(0.5) * (white + shared)
    steps = np.maximum(np.floor(inverse / STEP + 0.5), 1)
    z = 1 / (steps * STEP)

    known = (z >= NEAREST_M) & (z <= FARTHEST_M)
    in_projector = np.arange(WIDTH) + FOCAL * PROJECTOR_M / depth  # what lies in a shadow falls behind there
    known &= in_projector > np.maximum.accumulate(in_projector, axis=1) - 0.5
    beside_edge = np.zeros((HEIGHT, WIDTH), bool)
    across, along = (np.abs(np.diff(1 / depth, axis=axis)) > 0.02 for axis in (1, 0))
    for view, jump in ((beside_edge[:, 1:], across), (beside_edge[:, :-1], across),
                       (beside_edge[1:], along), (beside_edge[:-1], along)):
        view |= jump
    known &= ~(beside_edge & (uniform < 0.5))
    known &= cosine > 0.05 + 0.15 * uniform
    field = blobs(chance, 6)
    known &= field < np.partition(field.ravel(), int(0.985 * field.size))[int(0.985 * field.size)]
    corner = room.in_dark_corner(position + np.where(np.isfinite(depth), depth, 0)[..., None] * rays)
    field = blobs(chance, 14)
    known &= ~(corner & (field > np.median(field[corner] if corner.any() else field)))
    return np.where(known, np.floor(z * UNITS_PER_METRE + 0.5), 0).astype(np.uint16)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("out", nargs="?", 
                        default=os.path.join(os.path.dirname(__file__), "..", "fixtures", "depth", "room"))
    parser.add_argument("--seed", type=int, default=5)
    options = parser.parse_args()
    for folder in ("depth", "labels"):
        os.makedirs(os.path.join(options.out, folder), exist_ok=True)

    room, chance = Room(), np.random.RandomState(options.seed)
    listing, path, seen = "# time file\n", "# time tx ty tz qx qy qz qw\n", set()
    for tick in range((FRAMES - 1) * POSES_A_FRAME + 1):
        rotation, position = camera_pose(tick / (FRAMES * POSES_A_FRAME))
        time = f"{100 + tick * FRAME_S / POSES_A_FRAME:.2f}"
        path += time + "".join(f" {value:.9f}" for value in (*position, *quaternion(rotation))) + "\n"
        if tick % POSES_A_FRAME != 0:
            continue
        depth, label, cosine, rays = render(room, rotation, position)
        raw = measured(room, chance, depth, cosine, rays, position)
        name = f"{tick // POSES_A_FRAME:02d}.png"
        for folder, image in (("depth", raw), ("labels", label)):
            cv2.imwrite(os.path.join(options.out, folder, name), image, [cv2.IMWRITE_PNG_COMPRESSION, 9])
        listing += f"{time} depth/{name}\n"
        seen |= set(np.unique(label).tolist())
    camera = {"fx": FOCAL, "fy": FOCAL, "cx": CX, "cy": CY, "depth_scale": UNITS_PER_METRE, "width": WIDTH,
              "height": HEIGHT}
    planes = [{"id": i, "name": room.names[i - 1], "normal": [round(float(c), 12) + 0.0 for c in normal],
               "distance": round(distance, 12)}
              for i, (normal, distance) in enumerate(room.planes, 1) if i in seen]
    truth = '{"planes": [\n' + ",\n".join(" " + json.dumps(plane) for plane in planes) + "\n]}\n"
    for name, text in (("depth.txt", listing), ("groundtruth.txt", path), ("truth.json", truth),
                       ("camera.json", json.dumps(camera) + "\n")):
        with open(os.path.join(options.out, name), "w", encoding="ascii") as file:
            file.write(text)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""A long reference by Mitsuba 3's path tracer, for scripts/equal_time.py and manylight-compare.

    python3 -m venv venv && venv/bin/pip install mitsuba numpy
    venv/bin/python scripts/make_reference.py --samples 4096 --size 512x384 scene.json reference.exr

Surfaces are Lambertian. Samples come in blocks, by turns of two halves that share no seed: the reference is the mean of both, and
the mean square of half their difference is its own squared error. After each block the reference is written anew, so that what was
rendered is there if it is stopped; its last line says how many samples a pixel it has. Ends with 77 where Mitsuba is missing.
"""

import argparse
import math
import pathlib
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "crosscheck"))
try:
    import mitsuba_scene
    import numpy as np
except ImportError as error:
    print(f"make_reference.py: skipped: {error}; pip install mitsuba numpy", file=sys.stderr)
    sys.exit(77)
import scene_description

SAMPLES_OF_A_BLOCK = 32
FIRST_SEED = 1_000_000  # far from those of scripts/equal_time.py


def size(text):
    width, _, height = text.partition("x")
    return [int(width), int(height)]


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--samples", type=int, required=True, help="of a pixel, at least")
    parser.add_argument("--size", type=size, default=[512, 384], metavar="WIDTHxHEIGHT")
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("picture", type=pathlib.Path)
    return parser.parse_args()


def write(picture, pixels):
    part = picture.with_name("part." + picture.name)
    mitsuba_scene.write_picture(part, pixels)
    part.replace(picture)


def main():
    arguments = parse_arguments()
    mitsuba_scene.choose_variant(None)
    pairs = math.ceil(arguments.samples / (2 * SAMPLES_OF_A_BLOCK))
    with tempfile.TemporaryDirectory() as scratch:
        scene, max_depth, _ = scene_description.read(arguments.scene, pathlib.Path(scratch))
        depth = -1 if max_depth is None else max_depth
        loaded = mitsuba_scene.load(scene, arguments.size, depth, pathlib.Path(scratch), "diffuse")
        halves = [0.0, 0.0]
        start = time.perf_counter()
        for pair in range(pairs):
            for half in range(2):
                halves[half] = halves[half] + mitsuba_scene.render(loaded, SAMPLES_OF_A_BLOCK, FIRST_SEED + 2 * pair + half)
            first, second = (total / (pair + 1) for total in halves)
            write(arguments.picture, (first + second) / 2)
            own = math.sqrt(np.mean(((first - second) / 2) ** 2))
            samples = 2 * SAMPLES_OF_A_BLOCK * (pair + 1)
            seconds = time.perf_counter() - start
            print(f"\r{arguments.picture}: {samples} samples a pixel, own RMSE {own:.2g}, {seconds:.0f} s of "
                  f"{seconds * pairs / (pair + 1):.0f} s", end="", flush=True)
    print()


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Denoises an EXR with Intel's Open Image Denoise, guided by the albedo and the normals that the same file has.

    python3 -m venv venv && venv/bin/pip install pyoidn OpenEXR numpy
    manylight-capture scene.json --frames 8 --aov albedo,normal -o noisy.exr
    venv/bin/python scripts/denoise.py noisy.exr clean.exr

All other channels and the attributes stay as they are. The result is smoother and no longer right in the mean. Ends with 77
where a package is missing, 1 where a file is not as expected, 2 of wrong usage.
"""

import argparse
import pathlib
import sys

try:
    import numpy as np
    import OpenEXR
    import pyoidn
except ImportError as missing:
    if __name__ == "__main__":
        print(f"denoise.py: skipped: {missing}; pip install pyoidn OpenEXR numpy", file=sys.stderr)
        sys.exit(77)
    raise

COLOUR, ALBEDO, NORMAL = "RGB", ["albedo.R", "albedo.G", "albedo.B"], ["normal.X", "normal.Y", "normal.Z"]


class WrongFile(Exception):
    pass


def denoised(colour, albedo, normal):
    """Radiance, albedo and normals of the first surface: (height, width, 3) each."""
    planes = (np.ascontiguousarray(plane, np.float32) for plane in (colour, np.clip(albedo, 0, 1), normal))
    colour, albedo, normal = planes
    return np.asarray(pyoidn.denoise(colour, albedo=albedo, normal=normal, hdr=True))[:, :, :3]


def read(path):
    try:
        return OpenEXR.File(str(path), separate_channels=True)
    except Exception as fault:
        raise WrongFile(f"{path}: not an EXR file that can be read ({fault})") from None


def layer(path, channels, names):
    missing = [name for name in names if name not in channels]
    if missing:
        raise WrongFile(f"{path}: no channel {', '.join(missing)}; expected a picture by manylight-capture "
                        "--aov albedo,normal")
    return np.stack([channels[name].pixels for name in names], axis=2).astype(np.float32)


def denoise_file(source, target):
    file = read(source)
    channels = file.channels()
    colour, albedo, normal = (layer(source, channels, names) for names in (COLOUR, ALBEDO, NORMAL))
    if not np.isfinite(colour).all():
        raise WrongFile(f"{source}: {np.count_nonzero(~np.isfinite(colour))} values are not finite")
    clean = denoised(colour, albedo, normal)
    pixels = {name: channel.pixels for name, channel in channels.items()}
    pixels |= {name: np.ascontiguousarray(clean[:, :, i]) for i, name in enumerate(COLOUR)}
    header = {name: value for name, value in file.header().items() if name != "channels"}
    beside = target.with_name(target.name + ".part")
    OpenEXR.File(header, pixels).write(str(beside))
    beside.replace(target)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=pathlib.Path, help="EXR with albedo and normals")
    parser.add_argument("target", type=pathlib.Path, help="EXR to write")
    arguments = parser.parse_args()
    try:
        denoise_file(arguments.source, arguments.target)
    except (WrongFile, OSError) as fault:
        print(f"denoise.py: {fault}", file=sys.stderr)
        sys.exit(1)


if __name__ == "__main__":
    main()

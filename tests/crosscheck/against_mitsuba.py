#!/usr/bin/env python3
"""Renders scenes with Manylight and with Mitsuba 3, and says whether the means differ by more than the noise.

    python3 -m venv venv && venv/bin/pip install mitsuba numpy
    venv/bin/python tests/crosscheck/against_mitsuba.py --programs build/release/bin scenes/cornell_box.json

K independent seeds of each renderer give K means of the picture and of its 4 x 3 blocks, in three channels. Each is put
to Welch's t-test, all of a scene together at the family-wise level of 0.001. Ends with 0 if nothing differs, 1 if
something does, is too noisy to tell or cannot be rendered, 2 for wrong usage or a scene that is not converted, 77
where Mitsuba is missing.
"""

import argparse
import functools
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time
from importlib import metadata

try:
    import mitsuba_scene
    import numpy as np
except ImportError as error:
    print(f"against_mitsuba.py: skipped: {error}; pip install mitsuba numpy", file=sys.stderr)
    sys.exit(77)

import scene_description
import seed_statistics

FAMILY_LEVEL = 0.001
TECHNIQUES = ("path-tracer", "compensate")


class Failed(Exception):
    """A program ended with an error, or wrote what is no picture."""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder of the manylight programs")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("out/crosscheck"), help="folder for pictures")
    parser.add_argument("--size", default="160x120", help="WxH")
    parser.add_argument("--seeds", type=int, default=16, help="of every renderer")
    parser.add_argument("--spp", type=int, default=16, help="of Manylight's path tracer")
    parser.add_argument("--mitsuba-spp", type=int, default=32)
    parser.add_argument("--frames", type=int, default=32, help="of the compensated technique")
    parser.add_argument("--vpls", type=int, default=32, help="of the compensated technique")
    parser.add_argument("--paths", type=int, default=256, help="light paths of its frames: many of them cost little")
    parser.add_argument("--technique", dest="techniques", action="append", choices=TECHNIQUES,
                        help="of Manylight; may be repeated (default: all)")
    parser.add_argument("--bounces", type=int, help="surfaces of a light path, -1: no limit (default: the sidecar's)")
    parser.add_argument("--materials", choices=("diffuse", "full"), default="diffuse",
                        help="full: metals of OBJ files too; Mitsuba masks its microfacets a little otherwise")
    parser.add_argument("--noise", type=float, default=0.003, help="largest standard error of the ratio of the means")
    parser.add_argument("--factor", type=float, default=1.0, help="multiplies Manylight's pictures: to see this fail")
    parser.add_argument("--variant", help="of Mitsuba (default: llvm_ad_rgb where LLVM is new enough, or scalar_rgb)")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    arguments.techniques = arguments.techniques or TECHNIQUES
    if arguments.seeds < 2:
        parser.error("--seeds: 2 at least, as there is no standard error of one")
    if not re.fullmatch(r"[1-9]\d*x[1-9]\d*", arguments.size):
        parser.error(f"--size: {arguments.size}: expected WxH")
    return arguments


def run_program(command, shows_warnings):
    result = subprocess.run(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                            check=False)
    if result.returncode != 0 or shows_warnings:
        print(result.stderr, end="", file=sys.stderr)
    if result.returncode != 0:
        raise Failed(f"ended with code {result.returncode}: {' '.join(map(str, command))}")


def technique_options(arguments, technique):
    if technique == "path-tracer":
        return ["--technique", "path-tracer", "--spp", arguments.spp]
    return ["--technique", "deferred", "--clamp", "compensate", "--spp", arguments.frames, "--vpls", arguments.vpls,
            "--paths", arguments.paths]


def capture(arguments, file, bounces, technique, picture, seed):
    """One picture of Manylight's. The seed is passed on, everything else stays."""
    command = [arguments.programs / "manylight-capture", file, "-o", picture, "--size", arguments.size, "--seed", seed,
               "--bounces", bounces, "--lighting", "both", "--shadows", "on", "--materials", arguments.materials]
    command += technique_options(arguments, technique)
    run_program(command, shows_warnings=seed == 1)
    return arguments.factor * mitsuba_scene.read_picture(picture)


def many(arguments, label, render):
    """Renders every seed; returns the mean picture and the means of the regions, (seeds, regions, channels)."""
    start, total, means = time.monotonic(), 0.0, []
    for seed in range(1, arguments.seeds + 1):
        picture = render(seed)
        if not np.isfinite(picture).all():
            raise Failed(f"{label}, seed {seed}: pixels that are not finite")
        total = total + picture
        means.append(seed_statistics.region_means(picture))
        print(f"\r  {label}: seed {seed} of {arguments.seeds}, {time.monotonic() - start:.0f} s", end="",
              file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return total / arguments.seeds, np.array(means)


def report_region(name, ours, theirs, level):
    """One line; ours and theirs are (seeds, channels). Returns whether they agree and the comparison of the greys."""
    grey = seed_statistics.welch(ours.mean(axis=1), theirs.mean(axis=1))
    worst = min((seed_statistics.welch(ours[:, c], theirs[:, c]) for c in range(3)), key=lambda result: result.p)
    agrees = worst.p >= level
    print(f"  {name:<10}{ours.mean():12.6g}{theirs.mean():12.6g}{grey.ratio:10.5f} ± {grey.ratio_error:.5f}"
          f"{worst.t:8.2f}{worst.p:10.2g}{'' if agrees else '  DIFFERS'}")
    return agrees, grey


def report(title, ours, theirs, level, noise):
    """Prints the table of one technique; returns whether nothing differs and the noise is low enough."""
    print(f"\n{title}\n  {'':<10}{'Manylight':>12}{'Mitsuba':>12}{'ratio':>10}{'':10}{'worst t':>8}{'its p':>10}")
    results = [report_region(name, ours[:, i], theirs[:, i], level)
               for i, name in enumerate(seed_statistics.region_names())]
    whole = results[0][1]
    differing = sum(not agrees for agrees, _ in results)
    if differing:
        verdict = f"DIFFERS in {differing} of {len(results)} regions (p below {level:.2g})"
    elif not whole.ratio_error <= noise:
        verdict = f"TOO NOISY: the ratio's standard error is above {noise:g}; more --spp, --frames or --seeds"
    else:
        verdict = f"within the noise (no p below {level:.2g})"
    print(f"  mean over Mitsuba's: {whole.ratio:.5f} ± {whole.ratio_error:.5f}: {verdict}", flush=True)
    return not differing and whole.ratio_error <= noise


def write_difference(arguments, folder, technique, ours, theirs):
    """The mean pictures, and their relative difference in false colour."""
    files = folder / f"{technique}.exr", folder / "mitsuba.exr"
    for file, picture in zip(files, (ours, theirs)):
        mitsuba_scene.write_picture(file, picture)
    difference = folder / f"{technique}-difference.png"
    run_program([arguments.programs / "manylight-compare", *files, "--flip", "off", "--difference", difference,
                 "--difference-range", "0.1"], shows_warnings=True)
    print(f"  {difference}: ±10 %")


def read_scene(path, scratch):
    """The converter checks little: what it stumbles over is refused as well."""
    try:
        return scene_description.read(path, scratch)
    except (ValueError, KeyError, IndexError, struct.error) as error:
        raise scene_description.Refused(f"{path}: cannot be converted: {error!r}") from error


def longest_path(arguments, path, max_depth):
    """In Mitsuba's counting, which is the sidecar's: 2 is direct light, -1 no limit."""
    if arguments.bounces is not None:
        return arguments.bounces + 2 if arguments.bounces >= 0 else -1
    if max_depth in (0, 1):
        raise scene_description.Refused(f"{path}: max_depth {max_depth}: there is nothing but emission to compare")
    return max_depth if max_depth is not None else -1


def compare(arguments, path, scratch):
    """All techniques on one scene; returns whether they all agree with Mitsuba."""
    scene, max_depth, file = read_scene(path, scratch)
    depth = longest_path(arguments, path, max_depth)
    folder = arguments.output / (path.stem if arguments.bounces is None else f"{path.stem}-{arguments.bounces}")
    folder.mkdir(parents=True, exist_ok=True)
    triangles = sum(len(part.positions) for part in scene.parts)
    print(f"\n{path}: {triangles} triangles, {arguments.size}, {arguments.seeds} seeds, max_depth {depth}", flush=True)

    size = [int(number) for number in arguments.size.split("x")]
    loaded = mitsuba_scene.load(scene, size, depth, scratch, arguments.materials)
    render = functools.partial(mitsuba_scene.render, loaded, arguments.mitsuba_spp)
    reference, theirs = many(arguments, "Mitsuba", render)
    level = seed_statistics.sidak(FAMILY_LEVEL, len(arguments.techniques) * theirs.shape[1] * theirs.shape[2])
    agree = True
    for technique in arguments.techniques:
        render = functools.partial(capture, arguments, file, depth - 2 if depth > 0 else -1, technique,
                                   scratch / "picture.exr")
        picture, ours = many(arguments, technique, render)
        agree = report(f"{path.stem}, {technique}", ours, theirs, level, arguments.noise) and agree
        write_difference(arguments, folder, technique, picture, reference)
    return agree


def main():
    arguments = parse_arguments()
    mitsuba_scene.choose_variant(arguments.variant)
    print(f"Mitsuba {metadata.version('mitsuba')}, {mitsuba_scene.mi.variant()}")
    agree = True
    for path in arguments.scenes:
        with tempfile.TemporaryDirectory() as scratch:
            agree = compare(arguments, path, pathlib.Path(scratch)) and agree
    return 0 if agree else 1


def run():
    """main, with what goes wrong as one line."""
    try:
        return main()
    except scene_description.Refused as error:
        print(f"against_mitsuba.py: {error}", file=sys.stderr)
        return 2
    except (Failed, OSError) as error:
        print(f"against_mitsuba.py: {error}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(run())

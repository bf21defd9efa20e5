#!/usr/bin/env python3
"""Error at equal time of Manylight, its path tracer, Mitsuba 3's, and the latter with Open Image Denoise.

    python3 -m venv venv && venv/bin/pip install mitsuba numpy pyoidn OpenEXR
    venv/bin/python scripts/equal_time.py --programs build/release/bin cornell_box.json=reference.exr,1472

Surfaces are Lambertian for all. Each renders 1, 2, 4, ... samples of every pixel until the budget is spent, once before to warm
up; errors are against the reference, by manylight-compare, without pixels that see something emit or are next to one that
does. What is denoised pays for that. If the reference is by Mitsuba's path tracer, the number of its samples a pixel may follow
it: its own squared error, that of one sample over their number, is then taken off all squared errors. FLIP cannot be mended so.
Between those times they are interpolated on logarithmic scales. Building the scene and compiling are not counted. Ends with 77 where
Mitsuba is missing; without pyoidn the denoised columns are left out.
"""

import argparse
import itertools
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests" / "crosscheck"))
try:
    import mitsuba_scene
    import numpy as np
except ImportError as error:
    print(f"equal_time.py: skipped: {error}; pip install mitsuba numpy", file=sys.stderr)
    sys.exit(77)
import scene_description

try:
    import denoise
except ImportError:
    denoise = None

OURS = {"draft": ["--quality", "draft"],
        "draft, bounded": ["--quality", "draft", "--clamp", "bound"],
        "interactive": ["--quality", "interactive"],
        "path tracer": ["--technique", "path-tracer"]}
OURS_DENOISED = ["--quality", "draft", "--filter", "off", "--aov", "albedo,normal"]
SAMPLES_OF_EMISSION = 64
WITHOUT_WORST = "rmse without the worst 0.1 %"


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder of the manylight programs")
    parser.add_argument("--seconds", default="0.5,1,2,4,8", help="times to compare at")
    parser.add_argument("--json", type=pathlib.Path, help="all that was measured")
    parser.add_argument("scenes", nargs="+", metavar="SCENE=REFERENCE.exr[,SAMPLES]")
    arguments = parser.parse_args()
    arguments.times = [float(number) for number in arguments.seconds.split(",")]
    return arguments


def write_mask(emission, path):
    """White where no pixel within one of it sees something emit."""
    emits = emission.max(axis=2) > 0
    padded = np.pad(emits, 1)
    height, width = emits.shape
    near = np.zeros_like(emits)
    for y in range(3):
        for x in range(3):
            near |= padded[y:y + height, x:x + width]
    mitsuba_scene.write_picture(path, np.repeat(~near[:, :, None], 3, axis=2).astype(np.float64))


def errors(arguments, picture, reference, mask):
    command = [arguments.programs / "manylight-compare", picture, reference, "--mask", mask, "--json"]
    output = subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout
    numbers = json.loads(output)
    return {"rmse": numbers["rmse"], WITHOUT_WORST: numbers["rmse_without_worst"], "flip": numbers["flip"]["mean"]}


def our_frames(arguments, scene, settings, frames, picture):
    """Seconds of that many frames; the first one's excess over the others is compiling."""
    report = picture.with_suffix(".report")
    command = [arguments.programs / "manylight-capture", scene, "--materials", "diffuse", "--frames", frames, *settings,
               "--size", arguments.size, "-o", picture, "--report", report]
    subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seconds = json.loads(report.read_text())["seconds"]
    if frames == 1:
        return seconds["first_frame"]
    return (seconds["frames"] - seconds["first_frame"]) * frames / (frames - 1)


def seconds_to_denoise(picture):
    """Of the computation, twice: the first starts the library. The picture is replaced."""
    channels = denoise.read(picture).channels()
    planes = [denoise.layer(picture, channels, names) for names in (denoise.COLOUR, denoise.ALBEDO, denoise.NORMAL)]
    denoise.denoised(*planes)
    start = time.perf_counter()
    clean = denoise.denoised(*planes)
    seconds = time.perf_counter() - start
    mitsuba_scene.write_picture(picture, clean)
    return seconds


def measure_ours(arguments, scene, settings, measure, scratch, denoises=False):
    """Rows of seconds and errors. A frame's time is known from two, so that the first row is written last."""
    picture = scratch / "ours.exr"
    our_frames(arguments, scene, settings, 3, picture)
    rows = []
    frames, seconds = 2, 0.0
    one_frame = None
    while seconds < max(arguments.times):
        seconds = our_frames(arguments, scene, settings, frames, picture)
        one_frame = one_frame or seconds / frames
        after = seconds_to_denoise(picture) if denoises else 0.0
        rows.append({"frames": frames, "seconds": seconds + after, **measure(picture)})
        frames *= 2
    our_frames(arguments, scene, settings, 1, picture)
    after = seconds_to_denoise(picture) if denoises else 0.0
    return [{"frames": 1, "seconds": one_frame + after, **measure(picture)}, *rows]


def measure_mitsuba(arguments, loaded, measure, scratch, denoises):
    mi = mitsuba_scene.mi
    picture = scratch / "theirs.exr"
    rows = []
    spp, seconds = 1, 0.0
    np.array(mi.render(loaded, seed=1000, spp=1))
    while seconds < max(arguments.times):
        np.array(mi.render(loaded, seed=2000 + spp, spp=spp))  # a kernel is compiled for every number of samples
        start = time.perf_counter()
        pixels = np.array(mi.render(loaded, seed=spp, spp=spp)).astype(np.float32)
        if denoises:
            colour, albedo, normal = (np.ascontiguousarray(pixels[:, :, i:i + 3]) for i in (0, 3, 6))
            pixels = denoise.denoised(colour, albedo, normal)
        seconds = time.perf_counter() - start
        mitsuba_scene.write_picture(picture, np.asarray(pixels)[:, :, :3])
        rows.append({"frames": spp, "seconds": seconds, **measure(picture)})
        spp *= 2
    return rows


def take_off_reference(modes, samples):
    """Returns the reference's own RMSE. The first rows are of few samples: beside their error its own is nothing."""
    own = {}
    for number in ("rmse", WITHOUT_WORST):
        of_one = statistics.median(row["frames"] * row[number] ** 2 for row in modes["Mitsuba path"][:5])
        own[number] = math.sqrt(of_one / samples)
        for row in itertools.chain(*modes.values()):
            row[number] = math.sqrt(max(row[number] ** 2 - own[number] ** 2, 0))
    return own["rmse"]


def at(rows, seconds, number):
    """Interpolated in logarithms; None outside of what was measured."""
    for before, after in zip(rows, rows[1:]):
        if before["seconds"] <= seconds <= after["seconds"] and min(before[number], after[number]) > 0:
            share = math.log(seconds / before["seconds"]) / math.log(after["seconds"] / before["seconds"])
            return math.exp((1 - share) * math.log(before[number]) + share * math.log(after[number]))
    return None


def print_table(title, arguments, modes):
    print(f"\n{title}")
    for number in ("rmse", WITHOUT_WORST, "flip"):
        print(f"  {number:30}" + "".join(f"{name:>26}" for name in modes))
        for seconds in arguments.times:
            values = {name: at(rows, seconds, number) for name, rows in modes.items()}
            base = values["path tracer"]
            cells = ["-" if value is None else f"{value:.4g}" + (f" ({value / base:.2f} x)" if base else "")
                     for value in values.values()]
            print(f"  {seconds:28} s" + "".join(f"{cell:>26}" for cell in cells), flush=True)


def compare(arguments, argument, scratch):
    path, _, reference = argument.partition("=")
    reference, _, samples = reference.partition(",")
    path = pathlib.Path(path)
    height, width = mitsuba_scene.read_picture(reference).shape[:2]
    size = [width, height]
    arguments.size = f"{width}x{height}"
    scene, max_depth, _ = scene_description.read(path, scratch)
    depth = max_depth if max_depth is not None else -1

    def load(longest, **more):
        return mitsuba_scene.load(scene, size, longest, scratch, "diffuse", **more)

    mask = scratch / "mask.exr"
    write_mask(mitsuba_scene.render(load(1), SAMPLES_OF_EMISSION, 0), mask)

    def measure(picture):
        return errors(arguments, picture, reference, mask)

    modes = {name: measure_ours(arguments, path, settings, measure, scratch) for name, settings in OURS.items()}
    if denoise:
        modes["unfiltered, denoised"] = measure_ours(arguments, path, OURS_DENOISED, measure, scratch, True)
    modes["Mitsuba path"] = measure_mitsuba(arguments, load(depth), measure, scratch, False)
    if denoise:
        guided = load(depth, aovs="albedo:albedo,normal:sh_normal")
        modes["Mitsuba path, denoised"] = measure_mitsuba(arguments, guided, measure, scratch, True)
    title = f"{path.stem}, {arguments.size}"
    if samples:
        title += f"; the reference's own RMSE, {take_off_reference(modes, int(samples)):.2g}, is taken off"
    print_table(title, arguments, modes)
    return {"scene": path.stem, "size": arguments.size, "modes": modes}


def main():
    arguments = parse_arguments()
    mitsuba_scene.choose_variant(None)
    print(f"Mitsuba {mitsuba_scene.mi.__version__}, {mitsuba_scene.mi.variant()}")
    results = []
    for argument in arguments.scenes:
        with tempfile.TemporaryDirectory() as scratch:
            results.append(compare(arguments, argument, pathlib.Path(scratch)))
    if arguments.json:
        part = arguments.json.with_name(arguments.json.name + ".part")
        part.write_text(json.dumps(results, indent=1))
        part.replace(arguments.json)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Renders scenes by virtual point lights and by path tracing, and shows the pictures side by side in docs/gallery.md.

A scene that was rendered before keeps its place and, unless it is given again, its pictures.
"""

import argparse
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

MODES = {
    "vpls": ("virtual point lights", ["--clamp", "compensate", "--vpls", "64"]),
    "path-tracer": ("path tracer", ["--technique", "path-tracer"]),
}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder of the manylight programs")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="folder of the page gallery.md")
    parser.add_argument("--size", default="320x240")
    parser.add_argument("--seconds", default="30", help="of every picture")
    parser.add_argument("scenes", nargs="+", metavar="SCENE[=CAPTION]",
                        help="an OBJ, glTF, GLB or JSON file; the caption says what it is and whose")
    return parser.parse_args()


def read_entries(index):
    try:
        return json.loads(index.read_text())
    except FileNotFoundError:
        return {}


def write_beside(path, text):
    """Replaces the file whole, or not at all."""
    part = path.with_name(path.name + ".part")
    part.write_text(text)
    os.replace(part, path)


def render(arguments, scene, folder, name):
    """Both pictures of a scene; returns what the page says of them."""
    pictures = {}
    for mode, (_, settings) in MODES.items():
        picture = folder / f"{name}-{mode}.png"
        report = folder / f"{name}-{mode}.report"
        command = [arguments.programs / "manylight-capture", scene, "--size", arguments.size, "--time",
                   arguments.seconds, *settings, "-o", picture, "--report", report]
        print("$ " + shlex.join(map(str, command)), flush=True)
        subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)
        pictures[mode] = {"frames": json.loads(report.read_text())["frames"],
                          "settings": " ".join(settings + ["--size", arguments.size])}
        report.unlink()
    return pictures


def page(entries):
    text = ("# Gallery\n\nEach scene by virtual point lights and by path tracing, for the same time; `./run gallery "
            "SCENE=CAPTION...` renders it\nand adds more. Scenes that are not part of Manylight are shown with their "
            "authors' names.\n")
    for name, entry in entries.items():
        text += f"\n## {name}\n\n{entry['caption']}\n\n"
        text += "| " + " | ".join(title for title, _ in MODES.values()) + " |\n" + "|---" * len(MODES) + "|\n"
        text += "| " + " | ".join(f"![{name}, {title}](gallery/{name}-{mode}.png)"
                                  for mode, (title, _) in MODES.items()) + " |\n"
        text += "| " + " | ".join(f"`{entry['pictures'][mode]['settings']}`, frames: {entry['pictures'][mode]['frames']}"
                                  for mode in MODES) + " |\n"
    return text


def main():
    arguments = parse_arguments()
    folder = arguments.output / "gallery"
    folder.mkdir(parents=True, exist_ok=True)
    index = folder / "gallery.json"
    entries = read_entries(index)
    for given in arguments.scenes:
        file, _, caption = given.partition("=")
        scene = pathlib.Path(file)
        if not scene.is_file():
            sys.exit(f"make_gallery.py: {scene}: no such file")
        name = re.sub(r"[^A-Za-z0-9_]+", "-", scene.stem)
        pictures = render(arguments, scene, folder, name)
        entries[name] = {"caption": caption or entries.get(name, {}).get("caption", ""), "pictures": pictures}
        write_beside(index, json.dumps(entries, indent=2) + "\n")
        write_beside(arguments.output / "gallery.md", page(entries))


if __name__ == "__main__":
    main()

"""What the plots of manylight-bench have in common."""

import argparse
import json
import pathlib
import sys

SCRIPT = pathlib.Path(sys.argv[0]).name

try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt  # noqa: F401  for the scripts
except ImportError as error:
    sys.exit(f"{SCRIPT}: matplotlib is missing ({error}): install python3-matplotlib")

# Okabe and Ito's colours, told apart by everyone.
VERMILION, ORANGE, BLUE, BLACK, GREEN, PURPLE, SKY = ("#d55e00", "#e69f00", "#0072b2", "#000000", "#009e73", "#cc79a7",
                                                      "#56b4e9")
GREY = "#555555"


def open_frame(axes, minor="both"):
    """A light grid behind the data, no box around it."""
    axes.grid(True, which="major", color="#dddddd", linewidth=0.7)
    axes.grid(True, which="minor", axis=minor, color="#eeeeee", linewidth=0.4)
    axes.set_axisbelow(True)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)


def main(description, draw):
    """The command line of every plot: a JSON file in, a picture of `draw(data)` out."""
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("json", help="what manylight-bench --json wrote; - for standard input")
    parser.add_argument("picture", help=".png or .svg to write")
    arguments = parser.parse_args()
    try:
        with sys.stdin if arguments.json == "-" else open(arguments.json, encoding="utf-8") as source:
            data = json.load(source)
        draw(data).savefig(arguments.picture, dpi=130)
    except (OSError, ValueError, KeyError) as error:
        sys.exit(f"{SCRIPT}: {arguments.json}: {error!r}")

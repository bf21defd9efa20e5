#!/usr/bin/env python3
"""Measures Manylight on some scenes and writes a page that shows it all: tables, plots, pictures beside their references.

Every number comes from `manylight-bench`; this script only runs it and lays out what it wrote.
"""

import argparse
import html
import json
import pathlib
import shlex
import shutil
import subprocess
import sys

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; color: #222; max-width: 78rem; margin: 2rem auto; padding: 0 1rem; }
h1, h2, h3 { line-height: 1.2; } h2 { margin-top: 3rem; border-top: 1px solid #ddd; padding-top: 1.5rem; }
pre { font-size: 12px; overflow-x: auto; background: #f6f6f6; padding: .8rem; }
table { border-collapse: collapse; } td, th { padding: .25rem .7rem; text-align: right; border-bottom: 1px solid #eee; }
td:first-child, th:first-child { text-align: left; }
figure { display: inline-block; margin: 0 .6rem 1rem 0; vertical-align: top; } figcaption { font-size: 12px; color: #555; }
img.plot { max-width: 100%; } figure img { width: 320px; image-rendering: pixelated; } .worse { color: #a33; } .better { color: #070; }
"""


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--programs", type=pathlib.Path, required=True, help="folder of the manylight programs")
    parser.add_argument("--output", type=pathlib.Path, required=True, help="folder for the page and its pictures")
    parser.add_argument("--size", default="160x120", help="of the error measurements")
    parser.add_argument("--seconds", default="8", help="of every mode and seed")
    parser.add_argument("--seeds", default="6")
    parser.add_argument("--reference-seconds", default="150")
    parser.add_argument("--vpls", default="32", help="of the error measurements")
    parser.add_argument("--fps-size", default="320x240")
    parser.add_argument("--fps-vpls", default="20,50,90,200,500,800")
    parser.add_argument("scenes", nargs="+", type=pathlib.Path)
    return parser.parse_args()


def run(command):
    """Shows the command, as it takes a while, and the program's own progress; stops at the first failure."""
    print("$ " + shlex.join(map(str, command)), flush=True)
    subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL)


def measure(arguments, scene, folder):
    """Frame rates and errors of one scene, with their plots and pictures, into `folder`."""
    bench = arguments.programs / "manylight-bench"
    folder.mkdir(parents=True, exist_ok=True)
    run([bench, "fps", scene, "--size", arguments.fps_size, "--vpls", arguments.fps_vpls, "--text", folder / "fps.txt",
         "--json", folder / "fps.json", "--csv", folder / "fps.csv", "--plot", folder / "fps.png"])
    run([bench, "error", scene, "--size", arguments.size, "--vpls", arguments.vpls, "--seconds", arguments.seconds,
         "--seeds", arguments.seeds, "--leave-out-lamps", "--reference-seconds", arguments.reference_seconds, "--text",
         folder / "error.txt", "--json", folder / "error.json", "--csv", folder / "error.csv", "--plot",
         folder / "error.png", "--pictures", folder])
    for picture in sorted(folder.glob("mode-*.exr")):
        run([arguments.programs / "manylight-compare", picture, folder / "reference.exr", "--difference",
             picture.with_name(picture.stem + "-difference.png"), "--difference-range", "0.2"])
    for picture in folder.glob("*.exr"):  # large, and made again in a minute
        picture.unlink()


def cell(value, against, digits=3):
    if value is None:
        return "<td>-</td>"
    if not against:
        return f"<td>{value:.{digits}g}</td>"
    kind = "better" if value < against else "worse" if value > against else ""
    return f'<td class="{kind}">{value:.{digits}g} ({value / against:.2f} ×)</td>'


def comparison(data, rows, place, unit):
    """One row a time (or an error), one column a mode; ratios are to the last mode."""
    if not rows:
        return "<p>The modes have no stretch in common.</p>"
    names = "".join(f"<th>{html.escape(mode['mode'])}</th>" for mode in data["modes"])
    body = ""
    for row in rows:
        last = row["values"][-1]
        cells = "".join(cell(value, last if i + 1 < len(row["values"]) else None) for i, value in
                        enumerate(row["values"]))
        body += f"<tr><td>{row[place]:.3g}</td>{cells}</tr>"
    return f"<table><tr><th>{unit}</th>{names}</tr>{body}</table>"


def slopes(data):
    def text(value):
        return f"{value['mean']:.3f} ± {value['standard_error']:.3f}" if value else "-"

    rows = "".join(
        f"<tr><td>{html.escape(mode['mode'])}</td><td>{text(mode['slope'])}</td><td>{text(mode['slope_without_worst'])}"
        f"</td><td>{mode['missing_radiance']['mean']:.2e} ± {mode['missing_radiance']['standard_error']:.0e}</td>"
        f"<td>{mode['frame_milliseconds']:.1f}</td></tr>" for mode in data["modes"])
    return ("<table><tr><th>mode</th><th>slope of log RMSE over log time</th><th>without the worst 0.1 %</th>"
            f"<th>mean radiance missing at the end</th><th>ms a frame</th></tr>{rows}</table>")


def figures(data, folder):
    names = [("reference.png", "reference")]
    for i, mode in enumerate(data["modes"], start=1):
        names += [(f"mode-{i}.png", mode["mode"]), (f"mode-{i}-difference.png", "its relative error: blue -20 %, red +20 %")]
    return "".join(f'<figure><img src="{folder.name}/{name}" alt=""><figcaption>{html.escape(title)}</figcaption></figure>'
                   for name, title in names if (folder / name).exists())


def section(folder):
    data = json.loads((folder / "error.json").read_text(encoding="utf-8"))
    reference = data["reference"]
    quality = f"{reference['samples_per_pixel']} samples a pixel, own RMSE {reference['rmse']:.2e}"
    return f"""
<h2>{html.escape(data['scene'])}</h2>
<p>{data['triangles']:,} triangles, {data['width']} × {data['height']} pixels, {data['seeds']} seeds of
{data['seconds_per_run']} s a mode. Pixels that see a lamp are left out: their edges would outweigh all else. Reference: path traced, {quality}.</p>
<h3>Pictures of the first seed at the end of its time</h3>{figures(data, folder)}
<h3>Error against run time</h3><img class="plot" src="{folder.name}/error.png" alt="error over time">
{slopes(data)}
<h3>RMSE at equal time</h3>{comparison(data, data['equal_time'], 'seconds', 'seconds')}
<h3>Seconds to equal RMSE</h3>{comparison(data, data['equal_error'], 'rmse', 'RMSE')}
<p>In brackets the ratio to the last mode; red is where it is the better choice.</p>
<details><summary>all rows</summary><pre>{html.escape((folder / 'error.txt').read_text(encoding='utf-8'))}</pre></details>
<h3>Frame rates</h3><img class="plot" src="{folder.name}/fps.png" alt="frames per second">
<details><summary>all rows</summary><pre>{html.escape((folder / 'fps.txt').read_text(encoding='utf-8'))}</pre></details>
"""


def write_page(arguments, folders):
    data = json.loads((folders[0] / "error.json").read_text(encoding="utf-8"))
    machine = "".join(f"<tr><td>{html.escape(key)}</td><td>{html.escape(str(value))}</td></tr>"
                      for key, value in data["machine"].items())
    page = f"""<!doctype html>
<html lang="en"><meta charset="utf-8"><title>Manylight: results</title><style>{STYLE}</style>
<h1>Manylight: results</h1>
<p>Everything here was measured by <code>manylight-bench</code> in one go, and <code>./run report</code> measures it again.
Errors are against path-traced references whose own errors are stated; where a curve would come below three times that, it
ends. Times are comparable within a scene, not between machines.</p>
<table>{machine}</table>
{"".join(map(section, folders))}
</html>
"""
    temporary = arguments.output / "index.html.part"
    temporary.write_text(page, encoding="utf-8")
    temporary.replace(arguments.output / "index.html")


def main():
    arguments = parse_arguments()
    for scene in arguments.scenes:
        if not scene.is_file():
            sys.exit(f"make_report.py: {scene}: no such file")
    arguments.output.mkdir(parents=True, exist_ok=True)
    folders = []
    for scene in arguments.scenes:
        folder, part = arguments.output / scene.stem, arguments.output / (scene.stem + ".part")
        shutil.rmtree(part, ignore_errors=True)
        try:
            measure(arguments, scene, part)
        except subprocess.CalledProcessError as error:
            sys.exit(f"make_report.py: {scene}: {error}")
        shutil.rmtree(folder, ignore_errors=True)
        part.rename(folder)
        folders.append(folder)
        write_page(arguments, folders)
    print(arguments.output / "index.html")


if __name__ == "__main__":
    main()

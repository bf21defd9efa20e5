#!/usr/bin/env python3
"""Draws the JSON of `manylight-bench fps`: frames per second, milliseconds and ratios over VPL counts."""

import plotting
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, MaxNLocator, NullFormatter, NullLocator
from plotting import GREY, plt

TECHNIQUES = {  # name in the JSON: label, colour, marker
    "forward": ("forward", plotting.VERMILION, "o"),
    "forward-prepass": ("forward, depth pre-pass", plotting.ORANGE, "s"),
    "deferred": ("deferred", plotting.BLUE, "D"),
    "interleaved": ("deferred, interleaved 4 × 4", plotting.GREEN, "^"),
    "filtered": ("the same, filtered", plotting.PURPLE, "v"),
}
SEED_STYLE = {"linestyle": (0, (4, 3)), "linewidth": 1.0, "alpha": 0.75}


def cells_of(data, technique, shadows):
    cells = [c for c in data["cells"] if c["technique"] == technique and c["shadows"] == shadows and c["vpls"] > 0]
    return sorted(cells, key=lambda cell: cell["vpls"])


def counts_of(data, shadows):
    return sorted({cell["vpls"] for cell in data["cells"] if cell["shadows"] == shadows and cell["vpls"] > 0})


def places_of(data, shadows):
    """Where the logarithmic axes have their ticks: at our VPL counts, and at the seed paper's where they are drawn."""
    seed = [] if shadows else [row["vpls"] for row in data["seed_paper"]["rows"]]
    return sorted({*counts_of(data, shadows), *seed})


def plain(value, _=None):
    return f"{value:g}"


def style(axes, vpls, title):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xscale("log")
    axes.xaxis.set_major_locator(FixedLocator(vpls))
    axes.xaxis.set_minor_locator(NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(plain))
    axes.yaxis.set_major_formatter(FuncFormatter(plain))
    axes.set_xlabel("virtual point lights")
    plotting.open_frame(axes, minor="y")


def draw_fps(axes, data, shadows, vpls):
    for technique, (label, colour, marker) in TECHNIQUES.items():
        cells = cells_of(data, technique, shadows)
        if not cells:
            continue
        counts = [cell["vpls"] for cell in cells]
        axes.plot(counts, [cell["fps"] for cell in cells], color=colour, marker=marker, markersize=5, label=label)
        axes.fill_between(counts, [1e3 / cell["milliseconds"]["p95"] for cell in cells],
                          [1e3 / cell["milliseconds"]["p5"] for cell in cells], color=colour, alpha=0.15, linewidth=0)
    if not shadows:
        draw_seed_fps(axes, data["seed_paper"])
    axes.set_yscale("log")
    style(axes, vpls, "Frames per second")
    axes.yaxis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axes.yaxis.set_minor_formatter(NullFormatter())
    axes.legend(fontsize=8, frameon=False, loc="lower left")


def draw_seed_fps(axes, seed):
    counts = [row["vpls"] for row in seed["rows"]]
    for technique in ("forward", "deferred"):
        label, colour, _ = TECHNIQUES[technique]
        axes.plot(counts, [row[f"{technique}_fps"] for row in seed["rows"]], color=colour,
                  label=f"{label}, seed paper (GT 635)", **SEED_STYLE)


def draw_milliseconds(axes, data, shadows, vpls):
    for technique, (_, colour, marker) in TECHNIQUES.items():
        cells = cells_of(data, technique, shadows)
        if not cells:
            continue
        median = [cell["milliseconds"]["median"] for cell in cells]
        below = [m - cell["milliseconds"]["p5"] for m, cell in zip(median, cells)]
        above = [cell["milliseconds"]["p95"] - m for m, cell in zip(median, cells)]
        axes.errorbar([cell["vpls"] for cell in cells], median, yerr=[below, above], color=colour, marker=marker,
                      markersize=5, linestyle="none", capsize=2, elinewidth=0.8)
        draw_fit(axes, data, technique, shadows, vpls, colour)
    style(axes, vpls, "Milliseconds per frame, with fitted lines")
    axes.set_xscale("linear")
    axes.set_xlim(0, 1.06 * vpls[-1])
    axes.set_ylim(bottom=0)
    axes.xaxis.set_major_locator(MaxNLocator(6, integer=True))
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8, frameon=False, loc="upper left")


def draw_fit(axes, data, technique, shadows, vpls, colour):
    for fit in data["fits"]:
        if fit["technique"] == technique and fit["shadows"] == shadows:
            fixed, slope = fit["fixed_milliseconds"], fit["milliseconds_per_vpl"]
            ends = [0, vpls[-1]]
            axes.plot(ends, [fixed + slope * x for x in ends], color=colour, linewidth=1.2,
                      label=f"{fixed:.3g} + {slope:.3g} × VPLs")


def draw_ratios(axes, data, shadows, vpls):
    for technique in (name for name in TECHNIQUES if name != "deferred"):
        cells = [c for c in cells_of(data, technique, shadows) if c["over_deferred"] is not None]
        if cells:
            label, colour, marker = TECHNIQUES[technique]
            axes.plot([c["vpls"] for c in cells], [c["over_deferred"] for c in cells], color=colour, marker=marker,
                      markersize=5, label=label)
    if not shadows:
        rows = data["seed_paper"]["rows"]
        axes.plot([row["vpls"] for row in rows], [row["deferred_fps"] / row["forward_fps"] for row in rows],
                  color=TECHNIQUES["forward"][1], label="forward, seed paper", **SEED_STYLE)
    axes.axhline(1.0, color=GREY, linewidth=0.8)
    style(axes, vpls, "Frame time over that of deferred")
    axes.set_ylim(bottom=0)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=8, frameon=False, loc="best")


def draw(data):
    modes = [shadows for shadows in (False, True) if counts_of(data, shadows)]
    if not modes:
        raise ValueError("no measurement with a VPL")
    figure = plt.figure(figsize=(13, 4.4 * len(modes) + 0.5), layout="constrained")
    machine = data["machine"]
    figure.suptitle(f"{data['scene']}: {data['triangles']:,} triangles, {data['width']} × {data['height']} pixels\n"
                    f"{machine['device']}, {machine['host_threads']} host threads", fontsize=11)
    rows = figure.subfigures(len(modes), 1, squeeze=False)[:, 0]
    for row, shadows in zip(rows, modes):
        if len(modes) > 1:
            row.suptitle(f"VPLs {'with' if shadows else 'without'} shadows", fontsize=10, color=GREY)
        vpls = counts_of(data, shadows)
        left, middle, right = row.subplots(1, 3, width_ratios=[1.25, 1, 1])
        draw_fps(left, data, shadows, places_of(data, shadows))
        draw_milliseconds(middle, data, shadows, vpls)
        draw_ratios(right, data, shadows, places_of(data, shadows))
    return figure


if __name__ == "__main__":
    plotting.main(__doc__, draw)

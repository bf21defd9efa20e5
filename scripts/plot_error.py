#!/usr/bin/env python3
"""Draws the JSON of `manylight-bench error`: RMSE, FLIP and bias over run time on logarithmic axes."""

import plotting
from plotting import plt

COLOURS = [plotting.VERMILION, plotting.ORANGE, plotting.BLUE, plotting.BLACK, plotting.GREEN, plotting.PURPLE,
           plotting.SKY, "#999999"]
MARKERS = ["o", "s", "D", "^", "v", "P", "X", "*"]


def rows_of(mode, key):
    return [row for row in mode["rows"] if row["is_measurable"] and row[key] is not None and row[key]["mean"] > 0]


def label_of(mode, key):
    slope = mode[key]
    fit = f", slope {slope['mean']:.2f} ± {slope['standard_error']:.2f}" if slope else ""
    return mode["mode"] + fit


def draw_curves(axes, data, key, slope, title):
    for i, mode in enumerate(data["modes"]):
        rows = rows_of(mode, key)
        axes.errorbar([row["seconds"] for row in rows], [row[key]["mean"] for row in rows],
                      yerr=[row[key]["standard_error"] for row in rows], color=COLOURS[i % len(COLOURS)],
                      marker=MARKERS[i % len(MARKERS)], markersize=5, capsize=2, linewidth=1.2,
                      label=label_of(mode, slope) if slope else mode["mode"])
    style(axes, title)


def draw_guide(axes, data, key):
    """A line of slope -1/2 below all curves."""
    points = [(row["seconds"], row[key]["mean"]) for mode in data["modes"] for row in rows_of(mode, key)]
    if not points:
        return
    low, high = min(x for x, _ in points), max(x for x, _ in points)
    level = 0.7 * min(y * (x / low) ** 0.5 for x, y in points)
    axes.plot([low, high], [level, level * (high / low) ** -0.5], color="#999999", linestyle=(0, (4, 3)), linewidth=0.9,
              label="slope -1/2")


def draw_reference_error(axes, data):
    rmse = data["reference"]["rmse"]
    if rmse:
        axes.axhline(3 * rmse, color="#999999", linewidth=0.8, linestyle=":", label="3 × error of the reference")


def draw_split(axes, data):
    """Bias and standard deviation; a bias that chance made negative is not drawn."""
    for i, mode in enumerate(data["modes"]):
        colour = COLOURS[i % len(COLOURS)]
        rows = [row for row in mode["rows"] if row["is_measurable"]]
        axes.plot([row["seconds"] for row in rows], [row["variance"] ** 0.5 for row in rows], color=colour,
                  linewidth=1.0, label="standard deviation" if i == 0 else None)
        biased = [row for row in rows if row["bias_squared"] > 0]
        axes.plot([row["seconds"] for row in biased], [row["bias_squared"] ** 0.5 for row in biased], color=colour,
                  linestyle="none", marker=MARKERS[i % len(MARKERS)], markersize=5, markerfacecolor="none",
                  label="bias" if i == 0 else None)
    draw_reference_error(axes, data)
    style(axes, "Standard deviation (lines) and bias (marks)")


def style(axes, title):
    axes.set_title(title, fontsize=10, loc="left")
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("seconds")
    plotting.open_frame(axes)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(fontsize=7.5, frameon=False, loc="best")


def draw(data):
    machine = data["machine"]
    figure, panels = plt.subplots(2, 2, figsize=(12.5, 9), layout="constrained")
    figure.suptitle(f"{data['scene']}: {data['triangles']:,} triangles, {data['width']} × {data['height']} pixels, "
                    f"{data['seeds']} seeds\n{machine['device']}, {machine['host_threads']} host threads", fontsize=11)
    draw_guide(panels[0][0], data, "rmse")
    draw_reference_error(panels[0][0], data)
    draw_curves(panels[0][0], data, "rmse", "slope", "RMSE")
    draw_guide(panels[0][1], data, "rmse_without_worst")
    draw_curves(panels[0][1], data, "rmse_without_worst", "slope_without_worst",
                "RMSE without the worst 0.1 % of the pixels")
    draw_curves(panels[1][0], data, "flip", None, "HDR-FLIP")
    draw_split(panels[1][1], data)
    return figure


if __name__ == "__main__":
    plotting.main(__doc__, draw)

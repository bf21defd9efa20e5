#!/usr/bin/env python3
"""Prints tests/unit/flip_figures.h: what the authors' evaluator says about the pictures of tests/unit/flip_pictures.h.

    python3 -m venv venv && venv/bin/pip install flip-evaluator numpy
    venv/bin/python tests/crosscheck/flip_figures.py > tests/unit/flip_figures.h
"""

import sys
from importlib import metadata

try:
    import flip_evaluator
    import numpy as np
except ImportError as error:
    print(f"flip_figures.py: skipped: {error}; pip install flip-evaluator numpy", file=sys.stderr)
    sys.exit(77)

DEFAULT_PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * np.pi / 180


def unit(x, y, channel, seed):
    """The hash of flip_pictures.h, to [0, 1): integers and powers of two, so exact in any language."""
    value = x * 0x8DA6B343 ^ y * 0xD8163841 ^ channel * 0xCB1AB31F ^ seed * 0x9E3779B9
    value &= 0xFFFFFFFF
    value ^= value >> 16
    value = value * 0x7FEB352D & 0xFFFFFFFF
    value ^= value >> 15
    value = value * 0x846CA68B & 0xFFFFFFFF
    value ^= value >> 16
    return (value >> 8) / 2.0**24


def picture(width, height, value):
    """value(x, y, channel) in double, rounded once to float."""
    return np.array([[[value(x, y, c) for c in range(3)] for x in range(width)] for y in range(height)], np.float32)


def noise_reference(x, y, c):
    level = 2.0 ** int(unit(x // 8, y // 8, 0, 1) * 10 - 6)
    return level * (0.25 + 0.75 * unit(x, y, c, 2))


def noise_test(x, y, c):
    return noise_reference(x, y, c) * (0.5 + unit(x, y, c, 3))


def gradient_reference(x, y, c):
    return (8 * (x + 0.5) / 97, 2 * (y + 0.5) / 61, (x + y + 1) / (4 * 158))[c]


def gradient_test(x, y, c):
    return gradient_reference(x, y, 2 - c) if x > 48 else 1.125 * gradient_reference(x, y, c)


def steps_reference(x, y, c):
    return (4.0, 1.0, 0.125)[c] if (x // 16 + y // 16) % 3 == 0 else 0.0


def steps_test(x, y, c):
    return steps_reference(x + 1, y, c) + (64.0 if unit(x, y, 0, 4) < 1 / 256 else 0.0)


PICTURES = {
    "noise": (64, 48, noise_test, noise_reference),
    "gradient": (97, 61, gradient_test, gradient_reference),
    "steps": (97, 61, steps_test, steps_reference),
}
CASES = [(name, hdr, ppd) for name in PICTURES for hdr in (True, False) for ppd in (DEFAULT_PIXELS_PER_DEGREE, 30.0)]
PLACES = [(0, 0), (63, 47), (16, 20), (40, 9)]


def figures(name, hdr, ppd):
    width, height, test_value, reference_value = PICTURES[name]
    scale = 1.0 if hdr else 0.25  # display pictures end at 1; a part is left above, to be clamped
    test = picture(width, height, lambda x, y, c: scale * test_value(x, y, c))
    reference = picture(width, height, lambda x, y, c: scale * reference_value(x, y, c))
    error_map, mean, parameters = flip_evaluator.evaluate(
        reference, test, "HDR" if hdr else "LDR", inputsRGB=False, applyMagma=False, parameters={"ppd": ppd}
    )
    exposures = [parameters[key] for key in ("startExposure", "stopExposure", "numExposures")] if hdr else [0, 0, 1]
    values = [float(np.squeeze(error_map)[y, x]) for x, y in PLACES]
    return mean, exposures, values


def main():
    print("// What flip-evaluator " + metadata.version("flip-evaluator") + " (PyPI, the authors' own) says about the pictures of")
    print("// flip_pictures.h. Written by tests/crosscheck/flip_figures.py, which says how to run it.")
    print("#pragma once\n\n#include <cstdint>\n\nnamespace manylight::test {\n")
    print("struct FlipFigures {")
    print("    const char* picture;\n    bool isHdr;\n    double pixelsPerDegree;\n    double mean;")
    print("    double startExposure, stopExposure;\n    uint32_t exposureCount;")
    print("    double values[%d];  // at kFlipPlaces\n};\n" % len(PLACES))
    print("constexpr uint32_t kFlipPlaces[][2] = {%s};\n" % ", ".join("{%d, %d}" % place for place in PLACES))
    print("constexpr FlipFigures kFlipFigures[] = {")
    for name, hdr, ppd in CASES:
        mean, (start, stop, count), values = figures(name, hdr, ppd)
        print('    {"%s", %s, %.10f, %.7f,' % (name, "true" if hdr else "false", ppd, mean), end=" ")
        print("%.6f, %.6f, %d, {%s}}," % (start, stop, count, ", ".join("%.7f" % value for value in values)))
    print("};\n\n}  // namespace manylight::test")


if __name__ == "__main__":
    main()

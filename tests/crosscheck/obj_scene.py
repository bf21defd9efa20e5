"""Reads OBJ files with their MTL: a second, independent reading of what engine/scene/obj.cpp reads."""

import collections

import numpy as np
from scene_description import Material, Refused, Scene, Triangles, without_area_removed


def keyword_and_rest(line):
    """The first word, which a blank or a tab ends, and all after it."""
    words = line.split(None, 1) + ["", ""]
    return words[0], words[1].strip()


def parse_colour(words):
    numbers = [float(word) for word in words[:3]]
    return tuple(numbers) if len(numbers) == 3 else tuple(numbers[:1] * 3)


def texture_file(folder, rest, place):
    if rest.startswith("-"):
        raise Refused(f"{place}: options of map_Kd are not converted")
    path = folder / rest.replace("\\", "/")
    return path if path.is_file() else None


def read_materials(path, materials):
    current = Material()
    for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        keyword, rest = keyword_and_rest(line)
        if keyword == "newmtl":
            current = materials.setdefault(rest, Material())
        elif keyword == "Kd":
            current.albedo = tuple(min(max(value, 0.0), 1.0) for value in parse_colour(rest.split()))
        elif keyword == "Ke":
            current.emission = parse_colour(rest.split())
        elif keyword == "Pm":
            current.is_metal = float(rest) == 1.0
        elif keyword == "Pr":
            current.roughness = float(rest)
        elif keyword == "map_Kd":
            current.texture = texture_file(path.parent, rest, f"{path}:{number}")


def fan(positions, place):
    """Triangles of a convex polygon, as corner numbers; a concave one is refused."""
    count = len(positions)
    if count > 3:
        edges = np.roll(positions, -1, axis=0) - positions
        turns = np.cross(edges, np.roll(edges, -1, axis=0))
        if (turns @ turns.sum(axis=0) < -1e-9 * np.abs(turns).max() ** 2).any():
            raise Refused(f"{place}: concave faces are not converted")
    return [(0, i, i + 1) for i in range(1, count - 1)]


class Reader:
    def __init__(self, path):
        self.path = path
        self.positions, self.normals, self.uvs = [], [], []
        self.materials, self.current = {}, ""
        self.corners = collections.defaultdict(list)  # by name of material: triples of (v, vt, vn), -1 for none

    def corner(self, word):
        indices = [int(index) if index else 0 for index in word.split("/")] + [0, 0]
        sizes = (len(self.positions), len(self.uvs), len(self.normals))
        return tuple(index + size if index < 0 else index - 1 for index, size in zip(indices, sizes))

    def face(self, words, place):
        corners = [self.corner(word) for word in words]
        positions = np.array([self.positions[corner[0]] for corner in corners]) if len(corners) > 3 else corners
        self.corners[self.current] += [[corners[i] for i in triangle] for triangle in fan(positions, place)]

    def statement(self, keyword, words, rest, place):
        if keyword == "v":
            self.positions.append([float(word) for word in words[:3]])
        elif keyword == "vn":
            self.normals.append([float(word) for word in words[:3]])
        elif keyword == "vt":
            self.uvs.append([float(words[0]), 1.0 - float(words[1])])
        elif keyword == "f":
            self.face(words, place)
        elif keyword == "usemtl":
            self.current = rest
        elif keyword == "mtllib" and (self.path.parent / rest).is_file():
            read_materials(self.path.parent / rest, self.materials)

    def parts(self):
        table = {"positions": (0, self.positions, 3), "normals": (2, self.normals, 3), "uvs": (1, self.uvs, 2)}
        for name, triangles in self.corners.items():
            corners = np.array(triangles)
            arrays = {}
            for key, (column, values, width) in table.items():
                rows = np.array(values + [[0.0] * width])  # index -1, which means none, is the row of zeros
                arrays[key] = rows[corners[:, :, column]]
            yield from without_area_removed(Triangles(self.materials.get(name, Material()), **arrays))


def read(path):
    reader = Reader(path)
    for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        keyword, rest = keyword_and_rest(line.partition("#")[0])
        reader.statement(keyword, rest.split(), rest, f"{path}:{number}")
    return Scene(list(reader.parts()))

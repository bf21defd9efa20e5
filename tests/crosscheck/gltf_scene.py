"""Reads plain glTF 2.0: triangle lists, base colour, emission, cameras, punctual lights. Refuses the rest clearly."""

import base64
import json
import math
import struct
import urllib.parse

import numpy as np
from scene_description import Material, Refused, Scene, Triangles, without_area_removed

KNOWN_EXTENSIONS = {"KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_mesh_quantization"}
COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}
WRAPS = {10497: "repeat", 33071: "clamp", 33648: "mirror"}


class File:
    def __init__(self, path):
        self.path = path
        data = path.read_bytes()
        self.binary = None
        if data[:4] == b"glTF":
            length = struct.unpack_from("<I", data, 12)[0]
            self.binary = data[20 + length + 8:]
            data = data[20:20 + length]
        self.json = json.loads(data)
        unknown = set(self.json.get("extensionsRequired", [])) - KNOWN_EXTENSIONS
        if unknown:
            raise Refused(f"{path}: extensions not converted: {', '.join(sorted(unknown))}")
        self.buffers = [self.bytes_of(buffer) for buffer in self.json.get("buffers", [])]

    def bytes_of(self, entry):
        uri = entry.get("uri")
        if uri is None:
            return self.binary
        if uri.startswith("data:"):
            return base64.b64decode(uri.partition(",")[2])
        return (self.path.parent / urllib.parse.unquote(uri)).read_bytes()

    def view(self, index):
        view = self.json["bufferViews"][index]
        start = view.get("byteOffset", 0)
        return self.buffers[view["buffer"]][start:start + view["byteLength"]], view.get("byteStride")

    def accessor(self, index):
        accessor = self.json["accessors"][index]
        if "sparse" in accessor or "bufferView" not in accessor:
            raise Refused(f"{self.path}: accessors[{index}]: sparse accessors are not converted")
        data, stride = self.view(accessor["bufferView"])
        kind, width = np.dtype(COMPONENTS[accessor["componentType"]]), WIDTHS[accessor["type"]]
        values = np.ndarray((accessor["count"], width), kind, data, accessor.get("byteOffset", 0),
                            (stride or width * kind.itemsize, kind.itemsize))
        if not accessor.get("normalized"):
            return values.astype(float) if accessor["type"] != "SCALAR" else values
        return np.maximum(values / np.iinfo(kind).max, -1.0)


def matrix_of(node):
    if "matrix" in node:
        return np.array(node["matrix"], float).reshape(4, 4).T
    x, y, z, w = node.get("rotation", (0, 0, 0, 1))
    matrix = np.eye(4)
    matrix[:3, :3] = [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                      [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                      [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]
    matrix[:3, :3] *= np.array(node.get("scale", (1, 1, 1)), float)
    matrix[:3, 3] = node.get("translation", (0, 0, 0))
    return matrix


def nodes_of(document):
    """All nodes of the scene shown, each with its transform to the world."""
    scenes = document.get("scenes", [])
    roots = scenes[document.get("scene", 0)].get("nodes", []) if scenes else []
    pending = [(index, np.eye(4)) for index in reversed(roots)]
    while pending:
        index, parent = pending.pop()
        node = document["nodes"][index]
        matrix = parent @ matrix_of(node)
        yield node, matrix
        pending += [(child, matrix) for child in reversed(node.get("children", []))]


def read_texture(file, info, folder, material):
    if "KHR_texture_transform" in info.get("extensions", {}):
        raise Refused(f"{file.path}: KHR_texture_transform is not converted")
    texture = file.json["textures"][info["index"]]
    image = file.json["images"][texture["source"]]
    data = file.view(image["bufferView"])[0] if "bufferView" in image else file.bytes_of(image)
    material.texture = folder / f"image{texture['source']}{'.png' if data[:4] == bytes([137]) + b'PNG' else '.jpg'}"
    material.texture.write_bytes(data)
    sampler = file.json["samplers"][texture["sampler"]] if "sampler" in texture else {}
    wraps = sampler.get("wrapS", 10497), sampler.get("wrapT", 10497)
    if wraps[0] != wraps[1]:
        raise Refused(f"{file.path}: textures that wrap differently across and down are not converted")
    material.wrap = WRAPS[wraps[0]]
    material.filter = "nearest" if sampler.get("magFilter") == 9728 else "bilinear"


def read_material(file, source, folder):
    pbr = source.get("pbrMetallicRoughness", {})
    strength = source.get("extensions", {}).get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1.0)
    emission = tuple(strength * value for value in source.get("emissiveFactor", (0, 0, 0)))
    material = Material(tuple(pbr.get("baseColorFactor", (1, 1, 1))[:3]), emission)
    if "baseColorTexture" in pbr:
        read_texture(file, pbr["baseColorTexture"], folder, material)
    return material


def read_primitive(file, primitive, matrix, materials):
    if primitive.get("mode", 4) != 4 or "targets" in primitive:
        raise Refused(f"{file.path}: only lists of triangles without morph targets are converted")
    attributes = primitive["attributes"]
    positions = file.accessor(attributes["POSITION"]) @ matrix[:3, :3].T + matrix[:3, 3]
    count = len(positions)
    indices = file.accessor(primitive["indices"]).ravel() if "indices" in primitive else np.arange(count)
    corners = indices.astype(int).reshape(-1, 3)
    if np.linalg.det(matrix[:3, :3]) < 0:
        corners = corners[:, ::-1]
    normals, uvs = np.zeros((count, 3)), np.zeros((count, 2))
    if "NORMAL" in attributes:
        normals = file.accessor(attributes["NORMAL"]) @ np.linalg.inv(matrix[:3, :3])
    number = primitive.get("material", len(materials) - 1)
    source = file.json["materials"][number] if "material" in primitive else {}
    texcoord = source.get("pbrMetallicRoughness", {}).get("baseColorTexture", {}).get("texCoord", 0)
    if f"TEXCOORD_{texcoord}" in attributes:
        uvs = file.accessor(attributes[f"TEXCOORD_{texcoord}"])
    return without_area_removed(Triangles(materials[number], positions[corners], normals[corners], uvs[corners]))


def read_camera(camera, matrix):
    origin, forward, up = matrix[:3, 3], -matrix[:3, 2], matrix[:3, 1]
    return {"origin": origin.tolist(), "target": (origin + forward).tolist(), "up": up.tolist(),
            "fov_y_deg": math.degrees(camera["perspective"]["yfov"])}


def read_light(light, matrix):
    colour = [light.get("intensity", 1.0) * value for value in light.get("color", (1, 1, 1))]
    position, direction = matrix[:3, 3].tolist(), (-matrix[:3, 2]).tolist()
    if light["type"] == "directional":
        return {"type": "directional", "direction": direction, "irradiance": colour}
    if light["type"] == "point":
        return {"type": "point", "position": position, "intensity": colour}
    cone = light.get("spot", {})
    return {"type": "spot", "position": position, "direction": direction, "intensity": colour,
            "beam_deg": math.degrees(cone.get("innerConeAngle", 0.0)),
            "cutoff_deg": math.degrees(cone.get("outerConeAngle", math.pi / 4))}


def read(path, folder):
    file = File(path)
    materials = [read_material(file, source, folder) for source in file.json.get("materials", []) + [{}]]
    scene = Scene([])
    for node, matrix in nodes_of(file.json):
        extensions = node.get("extensions", {})
        if "skin" in node or "EXT_mesh_gpu_instancing" in extensions:
            raise Refused(f"{path}: skins and instancing are not converted")
        if "mesh" in node:
            for primitive in file.json["meshes"][node["mesh"]]["primitives"]:
                scene.parts += read_primitive(file, primitive, matrix, materials)
        if "camera" in node and scene.camera is None:
            camera = file.json["cameras"][node["camera"]]
            scene.camera = read_camera(camera, matrix) if camera["type"] == "perspective" else None
        if "KHR_lights_punctual" in extensions:
            light = file.json["extensions"]["KHR_lights_punctual"]["lights"][extensions["KHR_lights_punctual"]["light"]]
            scene.lights.append(read_light(light, matrix))
    return scene

"""Scenes as another renderer can take them: triangles by material, a camera and lights as a sidecar spells them."""

import dataclasses
import json
import math
import pathlib

import numpy as np


class Refused(Exception):
    """The scene uses what this converter does not know; the message says what."""


@dataclasses.dataclass
class Material:
    albedo: tuple = (0.8, 0.8, 0.8)
    emission: tuple = (0.0, 0.0, 0.0)
    texture: pathlib.Path | None = None  # sRGB; a factor to the albedo
    wrap: str = "repeat"
    filter: str = "bilinear"
    is_metal: bool = False
    roughness: float = 1.0  # perceptual: GGX's alpha is its square

    def emits(self):
        return any(self.emission)


@dataclasses.dataclass
class Triangles:
    """Corners of triangles of one material, counter-clockwise on the front; no normals: flat; v grows downwards."""

    material: Material
    positions: np.ndarray  # (n, 3, 3)
    normals: np.ndarray | None
    uvs: np.ndarray  # (n, 3, 2)


@dataclasses.dataclass
class Scene:
    parts: list
    camera: dict | None = None
    lights: list = dataclasses.field(default_factory=list)

    def bounds(self):
        corners = np.concatenate([part.positions.reshape(-1, 3) for part in self.parts])
        return corners.min(axis=0), corners.max(axis=0)

    def emits(self):
        return bool(self.lights) or any(part.material.emits() for part in self.parts)


def without_area_removed(part):
    """Drops triangles that have no area or a corner that is no finite number, and splits off flat ones."""
    edges = part.positions[:, 1:] - part.positions[:, :1]
    area = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    keep = np.isfinite(area) & (area > 0)
    lengths = np.linalg.norm(part.normals, axis=2)
    smooth = keep & (np.isfinite(lengths) & (lengths > 1e-38)).all(axis=1)
    flat = keep & ~smooth
    pieces = []
    if smooth.any():
        unit = part.normals[smooth] / lengths[smooth][:, :, None]
        pieces.append(Triangles(part.material, part.positions[smooth], unit, part.uvs[smooth]))
    if flat.any():
        pieces.append(Triangles(part.material, part.positions[flat], None, part.uvs[flat]))
    return pieces


def rectangle(light):
    """A rect_area light: black, visible, emitting towards cross(u, v)."""
    center, u, v = (np.array(light[key], float) for key in ("center", "u", "v"))
    a, b, c, d = center - u - v, center + u - v, center + u + v, center - u + v
    material = Material((0.0, 0.0, 0.0), tuple(light["radiance"]))
    return Triangles(material, np.array([[a, b, c], [a, c, d]]), None, np.zeros((2, 3, 2)))


def default_camera(scene):
    """In front, upper right, the whole scene in view."""
    low, high = scene.bounds()
    centre, radius = (low + high) / 2, np.linalg.norm(high - low) / 2
    origin = centre + radius / math.sin(math.radians(25)) * np.array([0.45, 0.35, 1.0]) / math.hypot(0.45, 0.35, 1.0)
    return {"origin": origin.tolist(), "target": centre.tolist(), "up": [0, 1, 0], "fov_y_deg": 50.0}


def default_light(scene):
    """At the camera, which cannot be in shadow of itself, so that every pixel has light."""
    low, high = scene.bounds()
    strength = 1.5 * float(np.sum((np.array(scene.camera["origin"]) - (low + high) / 2) ** 2))
    return {"type": "point", "position": scene.camera["origin"], "intensity": [strength] * 3}


def read_scene_file(path, folder):
    """A file of geometry; textures that are not files of their own are written into `folder`."""
    import gltf_scene
    import obj_scene

    if path.suffix.lower() == ".obj":
        return obj_scene.read(path)
    if path.suffix.lower() in (".gltf", ".glb"):
        return gltf_scene.read(path, folder)
    raise Refused(f"{path}: not a sidecar, OBJ or glTF file")


def read(path, folder):
    """Returns the scene, its max_depth (None: not stated) and the file that makes Manylight see the same."""
    sidecar = json.loads(path.read_text(encoding="utf-8")) if path.suffix.lower() == ".json" else {"scene": path.name}
    scene_file = path.parent / sidecar["scene"]
    scene = read_scene_file(scene_file, folder)
    if "lights" in sidecar or not sidecar.get("use_gltf_lights", True):
        scene.lights = (scene.lights if sidecar.get("use_gltf_lights") else []) + sidecar.get("lights", [])
    for light in scene.lights:
        if light["type"] == "environment":
            light["image"] = str((path.parent / light["image"]).resolve())
    complete = bool(sidecar.get("camera") or scene.camera) and scene.emits()
    scene.camera = sidecar.get("camera") or scene.camera or default_camera(scene)
    if not scene.emits():
        scene.lights = [default_light(scene)]
    if not complete:
        path = folder / "completed.json"
        completed = sidecar | {"scene": str(scene_file.resolve()), "camera": scene.camera, "lights": scene.lights}
        path.write_text(json.dumps(completed, indent=2) + "\n", encoding="utf-8")
    scene.parts += [rectangle(light) for light in scene.lights if light["type"] == "rect_area"]
    return scene, sidecar.get("max_depth"), path

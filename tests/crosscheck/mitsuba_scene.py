"""Gives a scene to Mitsuba 3 under Manylight's conventions: see docs/scenes.md and docs/notation.md."""

import glob
import os
import re

import mitsuba as mi
import numpy as np

from scene_description import Refused


def choose_variant(wanted):
    """LLVM 17 is the first whose code generator has all that Dr.Jit asks for; without it, the scalar variant."""
    if wanted is None:
        libraries = {int(re.search(r"(\d+)", os.path.basename(path))[1]): path
                     for path in glob.glob("/usr/lib/*/libLLVM*-[0-9][0-9].so*") + glob.glob("/usr/lib/*/libLLVM.so.*")}
        newest = max(libraries, default=0)
        if newest >= 17:
            os.environ.setdefault("DRJIT_LIBLLVM_PATH", libraries[newest])
        wanted = "llvm_ad_rgb" if newest >= 17 else "scalar_rgb"
    mi.set_variant(wanted)


def write_ply(part, path):
    corners = part.positions.reshape(-1, 3)
    columns, names = [corners, part.uvs.reshape(-1, 2)], ["x", "y", "z", "u", "v"]
    if part.normals is not None:
        columns, names = [*columns, part.normals.reshape(-1, 3)], [*names, "nx", "ny", "nz"]
    faces = np.zeros(len(corners) // 3, [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"] = 3
    faces["corners"] = np.arange(len(corners)).reshape(-1, 3)
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(corners)}"]
    header += [f"property float {name}" for name in names]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header\n"]
    vertices = np.hstack(columns).astype("<f4")
    path.write_bytes("\n".join(header).encode() + vertices.tobytes() + faces.tobytes())


def rgb(values, scale=1.0):
    return {"type": "rgb", "value": [scale * value for value in values]}


def reflectance(material):
    if material.texture is None:
        return rgb(material.albedo)
    pixels = mi.Bitmap(str(material.texture)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)
    bitmap = mi.Bitmap(np.clip(np.array(pixels) * np.array(material.albedo, np.float32), 0, 1))
    return {"type": "bitmap", "bitmap": bitmap, "raw": True, "wrap_mode": material.wrap,
            "filter_type": material.filter}


def surface(material, materials):
    """With materials "full", metals are GGX with Schlick's Fresnel term, as Mitsuba's "principled" has it."""
    if materials == "full" and material.is_metal:
        return {"type": "principled", "base_color": reflectance(material), "metallic": 1.0,
                "roughness": material.roughness, "specular": 0.5}
    return {"type": "diffuse", "reflectance": reflectance(material)}


def shape(part, path, materials):
    write_ply(part, path)
    bsdf = {"type": "twosided", "bsdf": surface(part.material, materials)}
    entry = {"type": "ply", "filename": str(path), "face_normals": part.normals is None, "bsdf": bsdf}
    if part.material.emits():
        entry["emitter"] = {"type": "area", "radiance": rgb(part.material.emission)}
    return entry


def towards(position, direction):
    position, direction = np.array(position, float), np.array(direction, float)
    direction /= np.linalg.norm(direction)
    up = np.eye(3)[np.argmin(np.abs(direction))]
    return mi.ScalarTransform4f().look_at(position.tolist(), (position + direction).tolist(), up.tolist())


def emitter(light):
    kind = light["type"]
    if kind == "point":
        return {"type": "point", "position": light["position"], "intensity": rgb(light["intensity"])}
    if kind == "spot":
        return {"type": "spot", "to_world": towards(light["position"], light["direction"]),
                "intensity": rgb(light["intensity"]), "cutoff_angle": light["cutoff_deg"],
                "beam_width": light["beam_deg"]}
    if kind == "directional":
        return {"type": "directional", "direction": light["direction"], "irradiance": rgb(light["irradiance"])}
    if kind == "environment":
        scale = set(light.get("scale", [1]))
        if len(scale) != 1:
            raise Refused("an environment whose channels are scaled apart")
        # Its middle column is at +Z, and rows reach from pole to pole by the centres of their texels.
        turn = mi.ScalarTransform4f().rotate([0, 1, 0], 180 + light.get("rotation_deg", 0))
        return {"type": "envmap", "filename": light["image"], "scale": scale.pop(), "to_world": turn}
    return {"type": "constant", "radiance": rgb(light["radiance"])}


def sensor(scene, size):
    camera = scene.camera
    low, high = scene.bounds()
    origin = np.array(camera["origin"], float)
    farthest = float(np.linalg.norm(np.maximum(np.abs(origin - low), np.abs(origin - high))))
    film = {"type": "hdrfilm", "width": size[0], "height": size[1], "rfilter": {"type": "box"}, "pixel_format": "rgb",
            "component_format": "float32"}
    view = mi.ScalarTransform4f().look_at(camera["origin"], camera["target"], camera.get("up", [0, 1, 0]))
    return {"type": "perspective", "fov_axis": "y", "fov": camera["fov_y_deg"], "near_clip": 1e-5 * farthest,
            "far_clip": 2 * farthest, "to_world": view, "film": film, "sampler": {"type": "independent"}}


def load(scene, size, max_depth, folder, materials, aovs=None):
    integrator = {"type": "path", "max_depth": max_depth}
    if aovs is not None:
        integrator = {"type": "aov", "aovs": aovs, "path": integrator}
    entries = {"type": "scene", "integrator": integrator, "sensor": sensor(scene, size)}
    for i, part in enumerate(scene.parts):
        entries[f"part{i}"] = shape(part, folder / f"part{i}.ply", materials)
    for i, light in enumerate(scene.lights):
        if light["type"] != "rect_area":
            entries[f"light{i}"] = emitter(light)
    return mi.load_dict(entries)


def render(loaded, spp, seed):
    return np.array(mi.render(loaded, seed=seed, spp=spp))[:, :, :3].astype(np.float64)


def read_picture(path):
    bitmap = mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False)
    return np.array(bitmap).astype(np.float64)


def write_picture(path, pixels):
    mi.Bitmap(pixels.astype(np.float32)).write(str(path))

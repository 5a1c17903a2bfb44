#!/usr/bin/env python3
"""Renders a closed box with matte walls, a lamp and mirrors with ctpbench and with Mitsuba 3, and compares them.

    python3 -m venv venv && venv/bin/pip install mitsuba
    venv/bin/python tests/independent/cornell.py build/release/ctpbench WORK_DIR

The two programs share nothing but the numbers below: Mitsuba gets rectangles and a sphere, samples the lamp and
has its own intersections, materials and random numbers. WORK_DIR keeps the scene and the images. Exit codes: 0
they agree, 1 they do not, 2 something is missing.
"""

import argparse
import json
import subprocess
import sys
from pathlib import Path

try:
    import mitsuba
    import numpy
except ImportError:
    print("cornell.py: error: this Python has no mitsuba; make one that has: "
          "python3 -m venv venv && venv/bin/pip install mitsuba", file=sys.stderr)
    sys.exit(2)

sys.path.append(str(Path(__file__).resolve().parents[2] / "scripts"))
from comparison import agree
from difference_colours import difference_colours

BOUNCES = 10
CAMERA = {"eye": [0, -0.1, 1.45], "target": [0, -0.15, -1], "up": [0, 1, 0], "fov": 75}
SPHERE = {"center": [0.15, -0.7, 0.3], "radius": 0.3, "specular": [0.9, 0.8, 0.6]}
MATTE = {"white": [0.73, 0.73, 0.73], "red": [0.65, 0.05, 0.05], "green": [0.12, 0.45, 0.15]}
MIRROR = [0.7, 0.85, 0.9]
LAMP = [6.0, 5.0, 3.5]


def tower(material, centre, half, height, degrees):
    """Four sides and a lid, turned about the vertical, sunk a little into the floor."""
    turn = numpy.radians(degrees)
    a = half * numpy.array([numpy.cos(turn), 0, -numpy.sin(turn)])
    b = half * numpy.array([numpy.sin(turn), 0, numpy.cos(turn)])
    foot, up = numpy.array([centre[0], -1.05, centre[1]]), numpy.array([0, height + 0.05, 0])
    sides = [(material, foot + p - q, 2 * q, up) for p, q in ((a, b), (b, -a), (-a, -b), (-b, a))]
    return sides + [(material, foot + up - a - b, 2 * b, 2 * a)]


def quads():
    """(material, corner, edge, other edge). The lamp fills a hole in the ceiling and faces down: a light has one
    side in Mitsuba, two in ctpbench."""
    x, y, z = numpy.array([2, 0, 0]), numpy.array([0, 2, 0]), numpy.array([0, 0, 2.5])
    room = [("white", [-1, -1, -1], z, x), ("white", [-1, -1, -1], x, y), ("white", [-1, -1, 1.5], y, x),
            ("red", [-1, -1, -1], y, z), ("green", [1, -1, -1], z, y)]
    rim = [("white", [-1, 1, -1], 0.25 * x, z), ("white", [0.5, 1, -1], 0.25 * x, z),
           ("white", [-0.5, 1, -1], 0.5 * x, 0.2 * z), ("white", [-0.5, 1, 0.5], 0.5 * x, 0.4 * z)]
    lamp = [("lamp", [-0.5, 1, -0.5], 0.5 * x, 0.4 * z)]
    towers = tower("white", [-0.4, -0.3], 0.28, 1.15, 20) + tower("mirror", [0.45, -0.6], 0.25, 0.9, -25)
    return [tuple(numpy.array(part, float) if i else part for i, part in enumerate(quad))
            for quad in room + rim + lamp + towers]


def write_scene(folder):
    """The scene as ctpbench reads it; returns the scene file."""
    mtl = [f"newmtl {name}\nillum 1\nKd {r} {g} {b}\nKs 0 0 0\n" for name, (r, g, b) in MATTE.items()]
    mtl.append("newmtl mirror\nillum 3\nKd 0 0 0\nKs {} {} {}\n".format(*MIRROR))
    mtl.append("newmtl lamp\nillum 1\nKd 0 0 0\nKs 0 0 0\nKe {} {} {}\n".format(*LAMP))
    (folder / "cornell.mtl").write_text("\n".join(mtl))
    obj = ["mtllib cornell.mtl"]
    for material, corner, u, v in quads():
        obj += ["v {:.9g} {:.9g} {:.9g}".format(*p) for p in (corner, corner + u, corner + u + v, corner + v)]
        obj += [f"usemtl {material}", "f -4 -3 -2 -1"]
    (folder / "cornell.obj").write_text("\n".join(obj) + "\n")
    scene = {"schema_version": 1, "name": "cornell", "mesh": {"file": "cornell.obj"}, "camera": CAMERA,
             "ambient": [0, 0, 0], "exposure": 1,
             "spheres": {"specular": SPHERE["specular"],
                         "placed": [{"center": SPHERE["center"], "radius": SPHERE["radius"]}]}}
    path = folder / "cornell.json"
    path.write_text(json.dumps(scene, indent=2) + "\n")
    return path


def mitsuba_scene(size):
    """The same as Mitsuba's own shapes. A path of d edges has its light at the d-th intersection; ctpbench makes
    BOUNCES after the camera ray's. No roulette. A lamp reflects nothing."""
    def rgb(value):
        return {"type": "rgb", "value": value}

    def mirror(value):
        return {"type": "twosided", "bsdf": {"type": "conductor", "material": "none",
                                             "specular_reflectance": rgb(value)}}
    looks = {name: {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(value)}}
             for name, value in MATTE.items()}
    looks.update(mirror=mirror(MIRROR), lamp={"type": "diffuse", "reflectance": rgb([0, 0, 0])})
    transform = mitsuba.ScalarTransform4f
    scene = {"type": "scene",
             "integrator": {"type": "path", "max_depth": BOUNCES + 1, "rr_depth": BOUNCES + 2},
             "sensor": {"type": "perspective", "fov": CAMERA["fov"], "fov_axis": "smaller", "near_clip": 1e-3,
                        "to_world": transform().look_at(origin=CAMERA["eye"], target=CAMERA["target"],
                                                        up=CAMERA["up"]),
                        "film": {"type": "hdrfilm", "width": size, "height": size, "pixel_format": "rgb",
                                 "component_format": "float32", "rfilter": {"type": "box"}},
                        "sampler": {"type": "independent"}},
             "ball": {"type": "sphere", "center": SPHERE["center"], "radius": SPHERE["radius"],
                      "bsdf": mirror(SPHERE["specular"])}}
    for i, (material, corner, u, v) in enumerate(quads()):
        normal = numpy.cross(u, v)
        to_world = numpy.eye(4)
        to_world[:3] = numpy.column_stack([u / 2, v / 2, normal / numpy.linalg.norm(normal), corner + (u + v) / 2])
        scene[f"quad{i}"] = {"type": "rectangle", "to_world": transform(to_world), "bsdf": looks[material]}
        if material == "lamp":
            scene[f"quad{i}"]["emitter"] = {"type": "area", "radiance": rgb(LAMP)}
    return mitsuba.load_dict(scene)


def read_image(path):
    bitmap = mitsuba.Bitmap(str(path)).convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.Float32)
    return numpy.array(bitmap, dtype=numpy.float64)


def write_png(path, image, gamma=True):
    bitmap = mitsuba.Bitmap(image.astype(numpy.float32))
    bitmap.set_srgb_gamma(not gamma)  # whether the values are encoded already
    bitmap.convert(mitsuba.Bitmap.PixelFormat.RGB, mitsuba.Struct.Type.UInt8, True).write(str(path))
    print(path)


def our_image(program, scene, arguments, seed):
    image = scene.parent / f"ours{seed}.exr"
    command = [program, "render", scene, "--width", arguments.size, "--height", arguments.size, "--samples",
               arguments.samples, "--bounces", BOUNCES, "--seed", seed, "--image", image]
    if subprocess.run([str(part) for part in command], stdout=subprocess.DEVNULL, check=False).returncode != 0:
        print(f"cornell.py: error: this failed: {' '.join(map(str, command))}", file=sys.stderr)
        sys.exit(2)
    return read_image(image)


def their_image(scene, samples, seed):
    return numpy.array(mitsuba.render(scene, spp=samples, seed=seed), dtype=numpy.float64)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the ctpbench to check")
    parser.add_argument("work", type=Path, metavar="WORK_DIR", help="folder for the scene and the images")
    parser.add_argument("--size", type=int, default=128, help="pixels along a side (%(default)s)")
    parser.add_argument("--samples", type=int, default=128, help="of each pixel in each image (%(default)s)")
    parser.add_argument("--seeds", type=int, default=8, help="images of each program (%(default)s)")
    arguments = parser.parse_args()
    if not arguments.program.is_file():
        parser.error(f"{arguments.program}: no such program; build it: cmake --build build/release")
    if arguments.seeds < 3 or arguments.size < 8:
        parser.error("a comparison needs at least 3 seeds and 8 pixels along a side")
    arguments.work.mkdir(parents=True, exist_ok=True)
    mitsuba.set_variant("scalar_rgb")
    seeds = range(1, arguments.seeds + 1)
    scene_file = write_scene(arguments.work.resolve())
    ours = numpy.stack([our_image(arguments.program.resolve(), scene_file, arguments, seed) for seed in seeds])
    scene = mitsuba_scene(arguments.size)
    theirs = numpy.stack([their_image(scene, arguments.samples, seed) for seed in seeds])
    same = agree(ours, theirs)
    write_png(arguments.work / "ours.png", ours.mean(axis=0))
    write_png(arguments.work / "theirs.png", theirs.mean(axis=0))
    colours, scale = difference_colours((ours.mean(axis=0) - theirs.mean(axis=0)).mean(axis=2))
    write_png(arguments.work / "difference.png", colours, gamma=False)
    print(f"difference.png: orange where ours is brighter, blue where darker; full colour is {scale:.3g}")
    print("they agree" if same else "they do NOT agree")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())

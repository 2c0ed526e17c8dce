"""Times primary rays alone, on one thread: Mitsuba's depth integrator, and Embree on triangles.

Usage: rays.py SCENE, where SCENE is a PLY file, or a text file with x y z r of a sphere a line. The camera is at
(0, 0, 22) and looks along -z, 45 degrees high, 640 x 480. Prints a JSON object: nanoseconds a pixel by program.
"""
import json
import sys
import time

import mitsuba as mi

WIDTH, HEIGHT, FOVY, DISTANCE = 640, 480, 45.0, 22.0
RUNS = 5


def least(draw):
    """The least processor time of some runs, in nanoseconds a pixel."""
    best = float("inf")
    for _ in range(RUNS):
        start = time.process_time()
        draw()
        best = min(best, time.process_time() - start)
    return best / (WIDTH * HEIGHT) * 1e9


def embree(mesh):
    """Embree in single precision on the triangles of a mesh."""
    import embreex.rtcore_scene
    import numpy as np
    from embreex.mesh_construction import TriangleMesh

    parts = mi.traverse(mesh)
    vertices = np.array(parts["vertex_positions"], dtype=np.float32).reshape(-1, 3)
    faces = np.array(parts["faces"], dtype=np.int32).reshape(-1, 3)
    scene = embreex.rtcore_scene.EmbreeScene()
    TriangleMesh(scene, vertices, faces)
    half = np.tan(np.radians(FOVY / 2))
    x = ((np.arange(WIDTH) + 0.5) / WIDTH * 2 - 1) * half * WIDTH / HEIGHT
    y = (1 - (np.arange(HEIGHT) + 0.5) / HEIGHT * 2) * half
    x, y = np.meshgrid(x, y)
    directions = np.stack([x, y, -np.ones_like(x)], -1).reshape(-1, 3).astype(np.float32)
    origins = np.zeros_like(directions)
    origins[:, 2] = DISTANCE
    scene.run(origins[:10], directions[:10])
    return least(lambda: scene.run(origins, directions))


def main():
    path = sys.argv[1]
    mi.set_variant("scalar_rgb")
    # Warnings would go to standard output.
    mi.set_log_level(mi.LogLevel.Error)
    scene = {
        "type": "scene",
        "integrator": {"type": "depth"},
        "sensor": {
            "type": "perspective",
            "fov": FOVY,
            "fov_axis": "y",
            "near_clip": 1e-3,
            "far_clip": 1e6,
            "to_world": mi.ScalarTransform4f().look_at(
                origin=[0, 0, DISTANCE], target=[0, 0, 0], up=[0, 1, 0]
            ),
            "film": {
                "type": "hdrfilm",
                "width": WIDTH,
                "height": HEIGHT,
                "rfilter": {"type": "box"},
                "pixel_format": "luminance",
            },
            "sampler": {"type": "independent", "sample_count": 1},
        },
    }
    if path.endswith(".ply"):
        scene["mesh"] = {"type": "ply", "filename": path, "face_normals": True}
    else:
        with open(path) as file:
            for number, line in enumerate(file):
                x, y, z, r = map(float, line.split())
                scene[f"s{number}"] = {"type": "sphere", "center": [x, y, z], "radius": r}
    loaded = mi.load_dict(scene, parallel=False)
    found = {"mitsuba": least(lambda: mi.render(loaded))}
    if path.endswith(".ply"):
        try:
            found["embree"] = embree(loaded.shapes()[0])
        except ImportError:
            pass
    print(json.dumps(found))


main()

# A run's animation opened in Blender: blender -b --factory-startup -noaudio -P open_in_blender.py -- FOLDER. Prints "Blender reads ..." where all is well.
import json
import pathlib
import struct
import sys

import bpy
import numpy

for name, kind in (("bool", bool), ("object", object), ("int", int), ("float", float)):  # the importer of Blender 3.4 wants an older NumPy
    if not hasattr(numpy, name):
        setattr(numpy, name, kind)

folder = pathlib.Path(sys.argv[sys.argv.index("--") + 1])
glb = (folder / "surface.glb").read_bytes()
document = json.loads(glb[20 : 20 + struct.unpack_from("<I", glb, 12)[0]])
names = {node["name"] for node in document["nodes"] if "mesh" in node}

bpy.ops.object.select_all(action="SELECT")
bpy.ops.object.delete()
bpy.ops.import_scene.gltf(filepath=str(folder / "surface.glb"))
meshes = {thing.name: thing for thing in bpy.data.objects if thing.type == "MESH"}


def seen_at(frame):
    """Names of what has a size at a frame of the file's own clock."""
    bpy.context.scene.frame_set(frame)
    bpy.context.view_layer.update()
    return {name for name, thing in meshes.items() if max(abs(part) for part in thing.matrix_world.to_scale()) > 0.5}


statistics = json.loads((folder / "statistics.json").read_text())
last = round(bpy.context.scene.render.fps / bpy.context.scene.render.fps_base * statistics["frames"] / 30)
problems = []
if len(meshes) != len(names):
    problems.append(f"{len(meshes)} meshes of {len(names)}")
if len(seen_at(0)) != 1:
    problems.append(f"{len(seen_at(0))} things at the start instead of one")
if len(seen_at(last)) != statistics["fragments"]:
    problems.append(f"{len(seen_at(last))} things in the end instead of {statistics['fragments']}")
print(f"Blender does not read it: {problems}" if problems else f"Blender reads {len(meshes)} meshes, {len(seen_at(last))} seen in the end")
sys.stdout.flush()

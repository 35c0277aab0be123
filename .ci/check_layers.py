#!/usr/bin/env python3
"""Fails when a file includes a module, a room of its own module, or a library that it may not use (tables below)."""
import pathlib
import re
import sys

MAY_USE = {  # module: modules it may include (its own is implied)
    "core": "",
    "scene": "core",
    "gpu": "core",
    "io": "core scene",
    "membrane": "core scene gpu",
    "mesoscale": "core scene gpu",
    "extrusion": "core scene",
    "render": "core scene gpu membrane mesoscale",
    "session": "core scene gpu io membrane mesoscale extrusion render",
    "app": "core scene gpu io extrusion render session",
    "gui": "core scene gpu extrusion render session",
}
ROOMS = {  # module: {room: rooms of the module it may include (its own is implied); "." is the module's own folder}
    # A module's own folder may include each room unless it is listed.
    "scene": {"json": ".", ".": ""},
    "gpu": {"context": ".", ".": ""},
    "io": {"read": "", "volumes": "read", "labels": "read volumes", "meshes": "read", "models": "read", "images": "read", "looks": "read",
           "phantoms": "models", "kinds": "images labels looks meshes models volumes"},
    "membrane": {"forces": "", "sheet": "forces"},
    # The module's own folder has both the frame, which all know, and the renderer, which knows all.
    "render": {"upload": ".", "passes": ". upload", "section": ". upload"},
    "session": {"command": ". cut document extrusion growth look membrane model picture section structure", "document": "growth model", "model": "cut", "growth": ".", "section": "", "structure": "", "cut": ".", "look": "document",
                "extrusion": ". cut growth look structure", "membrane": ". cut look structure",
                "picture": "document extrusion growth membrane"},
    # A membrane is a cut: the panel of cuts holds its form.
    "gui": {"kit": "", "tool": "kit", "view": "kit tool", "look": "kit tool view", "structure": "kit tool view", "model": "kit tool view",
            "membrane": "kit tool view", "cut": "kit tool view membrane", "extrusion": "kit tool view",
            "window": "kit tool view look structure model cut membrane extrusion"},
}
ONLY_IN = {  # library header: modules that may name it
    r"<Q[A-Z]": "gui",
    r"<(itk|gdcm|vtk|openvdb|OpenImageIO|gemmi)": "io",
    r"<(EGL|GL)/": "gpu",
    r"<(tbb|oneapi)/": "core",
    r"<GLFW/": "app",
    r"<CLI/": "app",
}


def home(root, path):
    """Module and room of a file of ours; the room is "." in the module's own folder."""
    parts = path.relative_to(root).parts
    parts = parts[2:] if parts[0] == "include" else parts[1:]
    return parts[0], parts[1] if len(parts) > 2 else "."


def target(root, path, include):
    """Module and room that an include leads to; nothing when it is none of ours."""
    if include.startswith("velum/"):
        return home(root, root / "include" / include)
    module, _ = home(root, path)
    for folder in (path.parent, root / "src" / module):
        if (folder / include).is_file():
            return home(root, (folder / include).resolve())
    return None


def violations(root):
    for path in sorted([*root.glob("include/velum/*/**/*.h"), *root.glob("src/*/**/*.[ch]*")]):
        module, room = home(root, path)
        rooms = ROOMS.get(module, {})
        if rooms and room not in rooms and room != ".":
            yield f"{path}: the room {room} of {module} is not in the table of {sys.argv[0]}"
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            quoted = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            there = target(root, path, quoted[1]) if quoted else None
            if there and there[0] != module and there[0] not in MAY_USE[module].split():
                yield f"{path}:{number}: {module} may not include {there[0]}"
            if there and there[0] == module and there[1] != room and room in rooms:
                if there[1] not in rooms[room].split():
                    yield f"{path}:{number}: {module}/{room} may not include {module}/{there[1]}"
            for pattern, homes in ONLY_IN.items():
                if re.match(r"\s*#\s*include\s*" + pattern, line) and module not in homes.split():
                    yield f"{path}:{number}: {pattern} belongs to {homes} only"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "layers ok")
    sys.exit(bool(found))

#!/usr/bin/env python3
"""Fails when a file includes a module, a room of its own module, or a library that it may not use (tables below), or a header of
another module that is not in that module's list of HEADERS (CMakeLists.txt)."""
import pathlib
import re
import sys

MAY_USE = {  # module: modules it may include (its own is implied)
    "core": "",
    "scene": "core",
    "gpu": "core",
    "io": "core scene",
    "membrane": "core scene gpu",
    "model": "core scene gpu",
    "growth": "core scene",
    "render": "core scene gpu membrane model",
    "vector": "core",
    "session": "core scene gpu io membrane model growth render vector",
    "app": "core scene gpu io growth render session vector",
    "gui": "core scene gpu growth render session vector",
    "python": "core scene gpu io render session",  # the folder python/ beside src/
}
ROOMS = {  # module: {room: rooms of the module it may include (its own is implied); "." is the module's own folder}
    # A module's own folder may include each room unless it is listed.
    "scene": {"json": ".", "timeline": ". json", ".": ""},
    "gpu": {"context": ".", ".": ""},
    # Plugins.h, in the module's own folder, names what is in plug-ins, of whichever room.
    "io": {"read": ".", "stores": ". read", "volumes": ". read stores", "labels": ". read stores volumes", "video": "", "meshes": ". read", "models": "read", "images": ". read", "looks": "read",
           "phantoms": "models", "kinds": "images labels looks meshes models stores volumes"},
    "membrane": {"forces": "", "sheet": "forces"},
    # The module's own folder has both the frame, which all know, and the renderer, which knows all.
    "render": {"upload": ".", "kept": ". upload", "residency": ". upload", "passes": ". upload residency", "section": ". kept residency"},
    "session": {"bar": "", "lettering": ". mark measure model section structure", "mark": ". measure model structure",
                "command": ". cut document extrusion growth look mark measure membrane model picture section structure film",
                "document": "growth model", "model": ". bar cut", "growth": ".", "section": "", "structure": "",
                "measure": "model structure", "cut": ".", "look": "document",
                "extrusion": ". bar cut growth look structure", "membrane": ". cut look model structure",
                "plate": ". document lettering model picture structure", "each": "film",
                "picture": ". document extrusion growth lettering membrane model",
                "film": ". document extrusion growth lettering membrane model picture structure"},
    # A membrane is a cut: the panel of cuts holds its form.
    "gui": {"kit": "", "rows": "kit", "service": "kit rows", "tool": "kit", "timeline": "kit rows service tool view", "view": "kit rows service tool",
            "look": "kit rows service tool view", "structure": "kit rows service tool view", "model": "kit rows service tool view",
            "membrane": "kit rows service tool view", "cut": "kit rows service tool view membrane",
            "extrusion": "kit rows service tool view", "mark": "kit rows service tool view",
            "window": "kit rows service tool view look structure model cut membrane extrusion mark timeline"},
}
ONLY_ROOMS = {  # module: {other module: rooms of it that it may include}
    # Commands, and what shows.
    "python": {"session": ". command document film measure membrane model picture structure", "io": "labels stores volumes", "render": "kept"},
}
ONLY_IN = {  # library header: modules that may name it
    r"<Q[A-Z]": "gui",
    r"<(itk|gdcm|vtk|openvdb|OpenImageIO|gemmi|hdf5|tiff)": "io",
    r"<(EGL|GL)/": "gpu",
    r"<(tbb|oneapi)/": "core",
    r"<GLFW/": "app",
    r"<CLI/": "app",
    r"<(ft2build|freetype)": "vector",
    r"<(cairo|qpdf|png)": "vector",
    r"<(pybind11|Python)": "python",
}


def home(root, path):
    """Module and room of a file under src, or under python; the room is "." in the module's own folder."""
    if path.is_relative_to(root / "python"):
        return "python", "."
    parts = path.relative_to(root / "src").parts
    return parts[0], parts[1] if len(parts) > 2 else "."


def public_headers(root):
    """What other modules may include: the HEADERS of each list of sources."""
    for made in root.glob("src/*/**/CMakeLists.txt"):
        for names in re.findall(r"HEADERS\s+((?:[\w/]+\.h\s*)+)", made.read_text()):
            yield from (made.parent / name for name in names.split())


def violations(root):
    public = set(public_headers(root))
    yield from (f"{path}: listed as a header, but not there" for path in sorted(public) if not path.is_file())
    for path in sorted([*root.glob("src/*/**/*.[ch]*"), *root.glob("python/*.[ch]*")]):
        module, room = home(root, path)
        rooms = ROOMS.get(module, {})
        if rooms and room not in rooms and room != ".":
            yield f"{path}: the room {room} of {module} is not in the table of {sys.argv[0]}"
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            quoted = re.match(r'\s*#\s*include\s*[<"]([^>"]+)[>"]', line)
            included = root / "src" / quoted[1] if quoted and not quoted[1].startswith("../translations/") else None
            there = home(root, included) if included and included.is_file() else None
            if there and there[0] != module and included not in public:
                yield f"{path}:{number}: {quoted[1]} is not among the headers that {there[0]} lists for others"
            if there and there[0] != module and there[0] not in MAY_USE[module].split():
                yield f"{path}:{number}: {module} may not include {there[0]}"
            seen = ONLY_ROOMS.get(module, {}).get(there[0]) if there else None
            if seen is not None and there[1] not in seen.split():
                yield f"{path}:{number}: {module} may not include {there[0]}/{there[1]}"
            if there and there[0] == module and there[1] != room and room in rooms:
                if there[1] not in rooms[room].split():
                    yield f"{path}:{number}: {module}/{room} may not include {module}/{there[1]}"
            if module in ("gui", "app") and re.search(r"[dD]ocument(\(\))?(\.|->)edit\(", line):
                yield f"{path}:{number}: {module} changes a scene by commands: session::edit, or editByHand for what a hand drags"
            for pattern, homes in ONLY_IN.items():
                if re.match(r"\s*#\s*include\s*" + pattern, line) and module not in homes.split():
                    yield f"{path}:{number}: {pattern} belongs to {homes} only"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "layers ok")
    sys.exit(bool(found))

#!/usr/bin/env python3
"""Fails when a file includes a module, or a library, that its own module may not use (tables below)."""
import pathlib
import re
import sys

MAY_USE = {  # module: modules it may include (its own is implied)
    "core": "",
    "scene": "core",
    "gpu": "core",
    "io": "core scene",
    "membrane": "core scene gpu",
    "render": "core scene gpu membrane",
    "session": "core scene gpu io membrane render",
    "app": "core scene gpu io render session",
    "gui": "core scene gpu render session",
}
ONLY_IN = {  # library header: modules that may name it
    r"<Q[A-Z]": "gui",
    r"<(itk|gdcm|vtk|openvdb|OpenImageIO)": "io",
    r"<(EGL|GL)/": "gpu",
    r"<GLFW/": "app",
    r"<CLI/": "app",
}


def violations(root):
    for path in sorted([*root.glob("include/velum/*/**/*.h"), *root.glob("src/*/**/*.[ch]*")]):
        parts = path.relative_to(root).parts
        module = parts[2] if parts[0] == "include" else parts[1]
        for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
            target = re.match(r'\s*#\s*include\s*[<"]velum/(\w+)/', line)
            if target and target[1] != module and target[1] not in MAY_USE[module].split():
                yield f"{path}:{number}: {module} may not include {target[1]}"
            for pattern, homes in ONLY_IN.items():
                if re.match(r"\s*#\s*include\s*" + pattern, line) and module not in homes.split():
                    yield f"{path}:{number}: {pattern} belongs to {homes} only"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "layers ok")
    sys.exit(bool(found))

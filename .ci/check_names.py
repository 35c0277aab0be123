#!/usr/bin/env python3
"""Fails when a source is not found by its header's name: X.cpp has its X.h in the same room, or is a
part of one (XMouse.cpp of X.h). A header without a source must hold all that it declares. ALONE lists the rest."""
import fnmatch
import pathlib
import re
import sys

ALONE = {  # sources without a header of their name: why
    "src/*/main.cpp": "programs",
    "src/app/*.cpp": "a verb each, declared in Verbs.h",
    "src/gpu/context/*.cpp": "ways to a Context",
    "src/io/*Plugin.cpp": "what a plug-in exports, declared in Plugins.h",
    "src/io/labels/*Reader.cpp": "declared in Readers.h, as every reader of GDCM",
    "src/io/meshes/*Reader.cpp": "a row each of the table in ReadMesh.cpp, declared in MeshReaders.h",
    "src/io/models/*Model.cpp": "flavours of CIF, declared in CifModels.h",
    "src/io/models/*Reader.cpp": "a row each of the table in ReadModel.cpp, declared in ModelReaders.h",
    "src/io/models/*Writer.cpp": "a row or two each of the table in WriteModel.cpp, declared in ModelWriters.h",
    "src/io/phantoms/*.cpp": "a row each of the table in Sample.cpp, declared in Phantom.h",
    "src/io/volumes/*Reader.cpp": "a row each of the table in Formats.cpp, declared in Readers.h",
    "src/io/volumes/*Writer.cpp": "a row each of the table in Formats.cpp, declared in Readers.h",
}
TABLES = {  # headers without a source of their name: why
    "src/app/Verbs.h": "the verbs",
    "src/io/meshes/MeshReaders.h": "the readers of surfaces",
    "src/io/models/ModelReaders.h": "the readers of models",
    "src/io/models/ModelWriters.h": "the writers of models",
    "src/io/volumes/Readers.h": "the readers",
    "src/io/volumes/Writers.h": "what the writer of labels adds to two of them",
    "src/io/volumes/FormatTable.h": "the table that Formats.cpp holds",
    "src/io/volumes/NiftiHeader.h": "what NiftiReader.cpp reads first",
    "src/gpu/Gl.h": "the table that context/Context.cpp fills",
    "src/gpu/ShaderFiles.h": "made while building, by cmake/EmbedShaders.cmake",
    "src/gpu/Context.h": "src/gpu/context",
}


def is_listed(path, table):
    return any(fnmatch.fnmatch(path, pattern) for pattern in table)


def declares_only(path):
    """The first line at the outermost level that declares a function, but does not hold it; nothing when all is there."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if re.match(r"(?!using |namespace |struct |class |enum |template|inline |constexpr |static_assert|#|//|extern )\w[^=]*\)( const)?;", line):
            return number
    return 0


def violations(root):
    headers = sorted([*root.glob("src/**/*.h"), *root.glob("src/**/*.h")])
    sources = sorted(root.glob("src/**/*.cpp"))
    room = lambda path: path.parent
    header_names, source_names = {}, {}
    for path in headers:
        header_names.setdefault(room(path), set()).add(path.stem)
    for path in sources:
        source_names.setdefault(room(path), set()).add(path.stem)
    for path in sources:
        names, name = header_names.get(room(path), set()), str(path.relative_to(root))
        is_part = any(path.stem.startswith(n) and path.stem[len(n):len(n) + 1].isupper() for n in names)
        if path.stem not in names and not is_part and not is_listed(name, ALONE):
            yield f"{name}: has no {path.stem}.h in its room"
    for path in headers:
        name = str(path.relative_to(root))
        if path.stem in source_names.get(room(path), set()) or is_listed(name, TABLES):
            continue
        if number := declares_only(path):
            yield f"{name}:{number}: declares what no {path.stem}.cpp in its room holds"


if __name__ == "__main__":
    found = list(violations(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "names ok")
    sys.exit(bool(found))

"""Packs the programs, the GPU's tests and what they link into one tar that runs where nothing is installed.

    bundle.py PROGRAMS_FOLDER TESTS_FOLDER SOURCE_FOLDER OUT.tar.xz

Velum's own libraries are those of the programs, for the tests, too. What the machine's graphics driver brings stays the
machine's; docs/TESTING.md says how the bundle finds it.
"""
import glob
import os
import re
import shutil
import subprocess
import sys

PROGRAMS = ["velum", "velum-batch"]
TESTS = ["gpu-test", "membrane-gl-test", "render-test", "session-gl-test", "golden-test"]
PLUGINS = ["platforms/libqxcb.so", "platforms/libqoffscreen.so", "platforms/libqwayland-generic.so",
           "platforms/libqwayland-egl.so", "wayland-shell-integration/libxdg-shell.so",
           "wayland-graphics-integration-client/libqt-plugin-wayland-egl.so", "xcbglintegrations/libqxcb-glx-integration.so",
           "xcbglintegrations/libqxcb-egl-integration.so", "imageformats/libqsvg.so", "iconengines/libqsvgicon.so",
           "platforminputcontexts/libcomposeplatforminputcontextplugin.so"]
QT_PLUGINS = "/usr/lib/x86_64-linux-gnu/qt6/plugins"
FONTS = ["/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"]

# The driver's own. Those of GLVND only hand calls on to it: a machine that has a driver without them is lent ours.
DRIVER = re.compile(r"lib(gbm|drm\w*|OSMesa|glapi)\.so")
DISPATCH = re.compile(r"lib(GL|EGL|GLX|OpenGL|GLdispatch)\.so")
# The C library and its loader, and C++'s: the newer of the machine's and ours.
C_LIBRARIES = ["ld-linux-x86-64.so.2", "libc.so.6", "libm.so.6", "libmvec.so.1", "libdl.so.2", "librt.so.1", "libpthread.so.0",
               "libresolv.so.2", "libutil.so.1", "libanl.so.1", "libnss_files.so.2", "libnss_dns.so.2"]
C_FOLDER = "/lib/x86_64-linux-gnu"
CPP = re.compile(r"lib(stdc\+\+|gcc_s)\.so")
# What drivers load, too: the machine's, where it has them.
SHARED = re.compile(r"lib(X11|X11-xcb|xcb|xcb-(dri2|dri3|present|sync|xfixes|shm|randr|glx)|Xext|Xfixes|xshmfence|Xxf86vm|Xau|Xdmcp|bsd|md|"
                    r"wayland-\w+|ffi|elf|expat|z|zstd|tinfo|edit|sensors|pciaccess)\.so")
# OpenImageIO links these for films, for HEIF and to talk to OpenCV, which Velum never asks of it; with what they link they would be
# half of the bundle. Stand-ins take their places: their functions stop the program.
STUBBED = re.compile(r"lib(opencv_\w+|avcodec|avformat|avutil|swscale|heif)\.so")


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def needed(path):
    return re.findall(r"\(NEEDED\).*\[(.*)\]", output("readelf", "-dW", path))


def libraries(roots):
    """{soname: file} of all that the roots link, not looking behind what is stubbed or the driver's."""
    places = {}
    for root in roots:
        for name, path in re.findall(r"^\s*(\S+) => (/\S+)", output("ldd", root), re.M):
            places.setdefault(name, os.path.realpath(path))
    for name in C_LIBRARIES:
        places[name] = os.path.realpath(os.path.join(C_FOLDER, name))
    found, todo = {}, list(roots)
    while todo:
        for name in needed(todo.pop()):
            if name in found or DRIVER.match(name):
                continue
            if name not in places:
                sys.exit(f"bundle: {name} is not on this machine")
            found[name] = places[name]
            if not STUBBED.match(name):
                todo.append(places[name])
    return found


SYMBOL = re.compile(r"^[0-9a-f]+ (.{7}) (\S+)\s+([0-9a-f]+)\s+(?:\(?([\w.+]+)\)?\s+)?(?:\.\w+ )?(\S+)$")


def symbols(path):
    """[(name, version, isData, bytes, isDefined)] of a library's dynamic symbols."""
    found = []
    for line in output("objdump", "-T", path).splitlines():
        match = SYMBOL.match(line)
        if match:
            flags, section, size, version, name = match.groups()
            found.append((name, version if version != "Base" else None, "O" in flags, int(size, 16), section != "*UND*"))
    return found


def make_stub(name, real, users, folder):
    """A library with those of the real one's symbols that its users want. Calling one ends the program."""
    wanted = {symbol[0] for user in users for symbol in symbols(user) if not symbol[4]}
    kept = {s[0]: s for s in symbols(real) if s[4] and s[0] in wanted}
    lines, versions = [], {}
    for symbol, version, is_data, size, _ in kept.values():
        kind, section = ("object", ".bss") if is_data else ("function", ".text")
        body = f".skip {max(size, 8)}" if is_data else "ud2"
        lines.append(f'.section {section}\n.globl "{symbol}"\n.type "{symbol}", @{kind}\n.balign 16\n"{symbol}": {body}\n'
                     f'.size "{symbol}", {max(size, 8) if is_data else 2}\n')
        versions.setdefault(version, []).append(symbol)
    source, script = os.path.join(folder, "stub.s"), os.path.join(folder, "stub.map")
    with open(source, "w") as out:
        out.write("".join(lines) + '.section .note.GNU-stack,"",@progbits\n')
    command = ["gcc", "-shared", "-nostdlib", f"-Wl,-soname,{name}", "-o", os.path.join(folder, name), source]
    if any(versions):
        with open(script, "w") as out:
            for version, names in versions.items():
                quoted = "".join(f' "{n}";' for n in names)
                out.write(f"{version or ''} {{ global:{quoted} }};\n")
        command.append(f"-Wl,--version-script={script}")
    output(*command)
    for path in (source, script):
        if os.path.exists(path):
            os.remove(path)


def place_of(name):
    if name in C_LIBRARIES:
        return "lib/c"
    for folder, pattern in (("lib/dispatch", DISPATCH), ("lib/cpp", CPP), ("lib/shared", SHARED)):
        if pattern.match(name):
            return folder
    return "lib"


def newest(tags):
    return max(tags, key=lambda tag: [int(part) for part in re.findall(r"\d+", tag)])


def version_wanted(files, prefix):
    """The newest version of a library that any of the files wants."""
    return newest({version for file in files for _, version, *_ in symbols(file)
                   if version and re.fullmatch(prefix + r"_\d[\d.]*", version)})


def copy(source, target):
    os.makedirs(os.path.dirname(target), exist_ok=True)
    shutil.copyfile(source, target)
    os.chmod(target, 0o755)


def write_script(source, target, words):
    with open(source) as file:
        text = file.read()
    for word, value in words.items():
        text = text.replace(f"@{word}@", value)
    with open(target, "w") as file:
        file.write(text)
    os.chmod(target, 0o755)


def main():
    programs, tests, sources, archive = sys.argv[1:5]
    root = os.path.join(os.path.dirname(os.path.abspath(archive)), "velum-bundle")
    shutil.rmtree(root, ignore_errors=True)

    # The programs, without what debuggers read, our plug-ins, and Qt's.
    binaries = [os.path.join(programs, name) for name in PROGRAMS] + [os.path.join(tests, name) for name in TESTS]
    for binary in binaries:
        copy(binary, os.path.join(root, "bin", os.path.basename(binary)))
        output("strip", os.path.join(root, "bin", os.path.basename(binary)))
    readers = glob.glob(os.path.join(programs, "../lib/velum/*.so"))
    for reader in readers:
        copy(reader, os.path.join(root, "lib/velum", os.path.basename(reader)))
    plugins = [plugin for plugin in PLUGINS if os.path.exists(os.path.join(QT_PLUGINS, plugin))]
    for plugin in plugins:
        copy(os.path.join(QT_PLUGINS, plugin), os.path.join(root, "plugins", plugin))

    # What they link.
    roots = binaries + readers + [os.path.join(QT_PLUGINS, plugin) for plugin in plugins]
    found = libraries(roots)
    kept = {name: path for name, path in found.items() if not STUBBED.match(name)}
    for name in C_LIBRARIES:  # all of one version, whether the driver or the programs ask for them
        kept[name] = os.path.realpath(os.path.join(C_FOLDER, name))
    for name, path in kept.items():
        copy(path, os.path.join(root, place_of(name), name))
    for name in found.keys() - kept.keys():
        users = [path for path in [*roots, *kept.values()] if name in needed(path)]
        make_stub(name, found[name], users, os.path.join(root, "lib"))

    # What the tests read, fonts, and the scripts that start it all.
    for folder in ("shaders", "tests/golden"):
        shutil.copytree(os.path.join(sources, folder), os.path.join(root, "source", folder),
                        ignore=shutil.ignore_patterns("*.new.png", "*.diff.png"))
    for font in FONTS:
        copy(font, os.path.join(root, "fonts", os.path.basename(font)))
    with open(os.path.join(root, "fonts", "fonts.conf"), "w") as file:
        file.write('<?xml version="1.0"?>\n<!DOCTYPE fontconfig SYSTEM "fonts.dtd">\n<fontconfig><dir prefix="relative">.</dir>'
                   '<cachedir prefix="xdg">fontconfig</cachedir></fontconfig>\n')
    wanting = [path for name, path in kept.items() if place_of(name) not in ("lib/c", "lib/dispatch")] + roots
    words = {"C_VERSION": version_wanted(wanting, "GLIBC"), "CPP_VERSION": version_wanted(wanting, "GLIBCXX"), "TESTS": " ".join(TESTS)}
    here = os.path.dirname(os.path.abspath(__file__))
    for script in ("start", "test"):
        write_script(os.path.join(here, script), os.path.join(root, script), words)
    for program in PROGRAMS:
        with open(os.path.join(root, program), "w") as file:
            file.write(f'#!/bin/sh\nexec "$(dirname "$0")/start" {program} "$@"\n')
        os.chmod(os.path.join(root, program), 0o755)

    # One file.
    output("tar", "-C", os.path.dirname(root), "--sort=name", "--owner=0", "--group=0", "-I", "xz -9 -T2", "-cf", archive, "velum-bundle")
    megabytes = os.path.getsize(archive) / 1e6
    print(f"{archive}: {megabytes:.1f} MB; needs {words['C_VERSION']} and {words['CPP_VERSION']} of the machine, else takes its own")
    if megabytes > 60:
        sys.exit("bundle: that is more than 60 MB")


if __name__ == "__main__":
    main()

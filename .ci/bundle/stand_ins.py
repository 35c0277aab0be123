"""Makes the bundle's stand-ins for what a program links and never asks for, so that tests start it in half of the time.

    stand_ins.py PROGRAM FOLDER
"""
import os
import sys

import bundle


def main():
    program, folder = sys.argv[1:3]
    os.makedirs(folder, exist_ok=True)
    found = bundle.libraries([program])
    kept = [program, *(path for name, path in found.items() if not bundle.STUBBED.match(name))]
    for name in filter(bundle.STUBBED.match, found):
        bundle.make_stub(name, found[name], [path for path in kept if name in bundle.needed(path)], folder)


if __name__ == "__main__":
    main()

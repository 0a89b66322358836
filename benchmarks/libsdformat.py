"""The checker of libsdformat over files, in one process: ``libsdformat.py LIBRARY FILE…``."""

import ctypes
import os
import sys


def main(library: str, paths: list[str]) -> None:
    checker = ctypes.CDLL(library)
    for path in paths:
        checker.cmdCheck(os.fsencode(path))
    os._exit(0)  # its exit handlers may crash


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2:])

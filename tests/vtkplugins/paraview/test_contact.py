#!/usr/bin/env python3
"""The source AFM contact has the numbers of the force map at its place, on 1 and 2 ranks."""

import paraview_setup as paraview

SCAN = paraview.TREE / "data/samples/granular_film.gsf"
SCENE = paraview.TREE / "data/scenes/granular_film.toml"


def main():
    for ranks in (1, 2):
        print(paraview.pvbatch("contact.py", paraview.plugin(), SCENE, SCAN, ranks=ranks))


if __name__ == "__main__":
    main()

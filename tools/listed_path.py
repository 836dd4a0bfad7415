#!/usr/bin/env python3
"""Makes a folder of links to the programs of listed Debian packages, of the packages that these need
and of those on every Debian machine, and prints its path. With that folder as PATH, what calls a
program of no listed package fails as on a fresh machine. Not covered: Python modules, and programs
called by an absolute path. Usage: PATH=$(tools/listed_path.py FOLDER LIST...)"""

import pathlib
import re
import subprocess
import sys

FIELDS = ("binary:Package", "db:Status-Status", "Essential", "Priority", "Provides", "Pre-Depends",
          "Depends")
PROGRAMS = [pathlib.Path(folder) for folder in ("/usr/bin", "/usr/sbin")]
CHECKOUT = "git"  # where there is a checkout to test, there is git, which made it


def names(field):
    """Package names of a field such as "a (>= 1), b | c:any": a list for each comma."""
    return [[re.match(r"[^\s(:]+", choice.strip())[0] for choice in group.split("|")]
            for group in field.split(",") if group.strip()]


def dpkg_query(*arguments):
    return subprocess.run(["dpkg-query", *arguments], check=True, capture_output=True,
                          text=True).stdout


def installed_packages():
    """Names that packages are found by, their own first, and what each needs."""
    form = "\t".join(f"${{{field}}}" for field in FIELDS) + "\n"
    packages = {}
    for line in dpkg_query("--show", f"--showformat={form}").splitlines():
        package = dict(zip(FIELDS, line.split("\t")))
        if package["db:Status-Status"] == "installed":
            packages[package["binary:Package"].partition(":")[0]] = {
                "name": package["binary:Package"],
                "everywhere": package["Essential"] == "yes" or package["Priority"] == "required",
                "provides": [name for group in names(package["Provides"]) for name in group],
                "needs": names(package["Pre-Depends"]) + names(package["Depends"])}
    return packages


def closure(packages, roots):
    """The roots and all that they need: of alternatives (a | b) the first that is installed, as apt
    has it, or that an installed package provides."""
    found_by = {name: [name] for name in packages}
    for name, package in packages.items():
        for provided in package["provides"]:
            if provided not in packages:
                found_by.setdefault(provided, []).append(name)
    needed = set()
    left = list(roots)
    while left:
        name = left.pop()
        if name not in needed:
            needed.add(name)
            for choices in packages[name]["needs"]:
                left += next((found_by[choice] for choice in choices if choice in found_by), [])
    return needed


def listed_packages(lists, packages):
    """The packages of these files; ends the program where one is not installed."""
    listed = [line for file in lists for line in pathlib.Path(file).read_text().splitlines()
              if line and not line.startswith("#")]
    missing = [name for name in listed if name not in packages]
    if missing:
        sys.exit(f"not installed: {' '.join(missing)} (tools/install_packages.sh)")
    return listed


def programs(packages):
    """The programs, by name, that these packages own or an alternative (/etc/alternatives) leads to."""
    listing = dpkg_query("--listfiles", *(package["name"] for package in packages))
    # /bin is /usr/bin today; packages still say /bin.
    owned = {path.parent.resolve() / path.name for path in map(pathlib.Path, listing.splitlines())
             if path.parent.name in ("bin", "sbin")}
    return {path.name: path for folder in PROGRAMS for path in folder.iterdir()
            if path in owned or (is_alternative(path) and path.resolve() in owned)}


def is_alternative(path):
    return path.is_symlink() and path.readlink().parent == pathlib.Path("/etc/alternatives")


def main(folder, *lists):
    packages = installed_packages()
    roots = listed_packages(lists, packages)
    roots += [name for name, package in packages.items()
              if package["everywhere"] or name == CHECKOUT]
    folder = pathlib.Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for link in filter(pathlib.Path.is_symlink, folder.iterdir()):
        link.unlink()
    for name, path in programs([packages[each] for each in closure(packages, roots)]).items():
        (folder / name).symlink_to(path)
    print(folder)


if __name__ == "__main__":
    main(*sys.argv[1:])

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Usage: repair_wheel.py WHEEL FOLDER

Writes the wheel to FOLDER with the shared libraries that it needs, stripped, and with the platform tag that is true of it:
what auditwheel does, which Debian 12 does not have. The tag follows PEP 600: manylinux_2_N is a system with version 2.N of the
GNU C library or newer, and a libstdc++ of its time. For another architecture than the machine's, the environment names the
program that strips: STRIP. Needs binutils, patchelf and python3-wheel; takes libraries and their licences from Debian's packages.
"""

import hashlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

# What auditwheel, too, expects of every system
OF_THE_SYSTEM = re.compile(r"lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z)\.so\.\d+|ld-linux-.*")
# The newest symbols of libstdc++ on systems by the version of their C library, from the policies of auditwheel
NEWEST_SYMBOLS = {
    (2, 28): {"GLIBCXX": (3, 4, 24), "CXXABI": (1, 3, 11)},
    (2, 31): {"GLIBCXX": (3, 4, 28), "CXXABI": (1, 3, 12)},
    (2, 34): {"GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13)},
    (2, 35): {"GLIBCXX": (3, 4, 30), "CXXABI": (1, 3, 13)},
    (2, 39): {"GLIBCXX": (3, 4, 33), "CXXABI": (1, 3, 14)},
}
ARCHITECTURES = {"Advanced Micro Devices X86-64": "x86_64", "AArch64": "aarch64"}


def output(*command: object) -> str:
    return subprocess.run([*map(str, command)], check=True, capture_output=True, text=True).stdout


def is_binary(file: Path) -> bool:
    return file.is_file() and file.open("rb").read(4) == b"\x7fELF"


def needed(file: Path) -> list[str]:
    return [name for name in output("patchelf", "--print-needed", file).split() if not OF_THE_SYSTEM.fullmatch(name)]


def bundle(tree: Path, libraries: Path, licences: Path, architecture: str) -> None:
    """Copies what the files of the tree need, and lets them find it. The copies get names of their own: another package may
    have brought along another library of the same name."""
    names: dict[str, str] = {}
    waiting = [file for file in tree.rglob("*") if is_binary(file)]
    while waiting:
        file = waiting.pop()
        output(os.environ.get("STRIP", "strip"), "--strip-unneeded", file)
        renamed: list[str] = []
        for name in needed(file):
            if name not in names:
                found = Path("/usr/lib", f"{architecture}-linux-gnu", name).resolve(strict=True)
                digest = hashlib.sha256(found.read_bytes()).hexdigest()[:8]
                stem, _, suffix = name.partition(".so")
                names[name] = f"{stem}-{digest}.so{suffix}"
                libraries.mkdir(exist_ok=True)
                waiting.append(Path(shutil.copy(found, libraries / names[name])))
                package = output("dpkg-query", "--search", f"*/{found.name}").split(":")[0]
                shutil.copy(f"/usr/share/doc/{package}/copyright", licences / package)
            renamed += ["--replace-needed", name, names[name]]
        # one after the other: patchelf 0.14 mixes them up
        if file.parent == libraries:
            output("patchelf", "--set-soname", file.name, file)
        if renamed:
            output("patchelf", *renamed, file)
            output("patchelf", "--set-rpath", f"$ORIGIN/{os.path.relpath(libraries, file.parent)}", file)


def platform_tag(tree: Path, architecture: str) -> str:
    """The oldest system that has what the files need."""
    newest: dict[str, tuple[int, ...]] = {"GLIBC": (2, 17), "GLIBCXX": (0,), "CXXABI": (0,)}
    for file in filter(is_binary, tree.rglob("*")):
        for what, version in re.findall(r"Name: (GLIBC|GLIBCXX|CXXABI)_([\d.]+)", output("readelf", "--version-info", file)):
            newest[what] = max(newest[what], tuple(map(int, version.split("."))))
    of_its_time = min(glibc for glibc, has in NEWEST_SYMBOLS.items() if all(has[what] >= newest[what] for what in has))
    return f"manylinux_2_{max(newest['GLIBC'], of_its_time)[1]}_{architecture}"


def main(wheel: Path, folder: Path) -> None:
    with tempfile.TemporaryDirectory() as scratch:
        output(sys.executable, "-m", "wheel", "unpack", "--dest", scratch, wheel)
        (tree,) = Path(scratch).iterdir()
        (info,) = tree.glob("*.dist-info")
        binaries = [file for file in tree.rglob("*") if is_binary(file)]
        for file in binaries:
            file.chmod(0o755)  # which `wheel unpack` forgets
        machine = re.search(r"Machine: *(.*)", output("readelf", "--file-header", binaries[0]))
        architecture = ARCHITECTURES[machine.group(1)]
        licences = info / "licenses"
        licences.mkdir(exist_ok=True)
        bundle(tree, tree / f"{info.name.partition('-')[0]}.libs", licences, architecture)
        lines = (info / "WHEEL").read_text()
        (info / "WHEEL").write_text(re.sub(r"linux_\w+$", platform_tag(tree, architecture), lines, flags=re.M))
        folder.mkdir(parents=True, exist_ok=True)
        output(sys.executable, "-m", "wheel", "pack", "--dest-dir", folder, tree)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))

#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-3.0-or-later
"""No header and no source is longer than 300 lines.
usage: check_sizes.py PROJECT_FOLDER [KNOWN...]   files that are longer still; one that no longer is must leave the list"""
import pathlib
import sys

MOST = 300


def main():
    project, known = pathlib.Path(sys.argv[1]), set(sys.argv[2:])
    paths = [path for folder in ("include", "src") for path in sorted((project / folder).rglob("*"))]
    lengths = {str(path.relative_to(project)): len(path.read_text(encoding="utf-8").splitlines())
               for path in paths if path.suffix in (".h", ".cpp")}
    complaints = [f"{path} has {lines} lines; expected at most {MOST}"
                  for path, lines in lengths.items() if lines > MOST and path not in known]
    complaints += [f"{path} is no longer than {MOST} lines; expected it off the list of those that are"
                   for path in sorted(known) if lengths.get(path, 0) <= MOST]
    if not lengths:
        complaints.append(f"no file in {project}/include and {project}/src")
    print("\n".join(complaints) or f"{len(lengths)} files")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""What a directory of results must look like at any time, and how two of them are compared.

Every .csv is RFC 4180 with CR LF after the last row and as many fields in every row, every .json can be parsed, every
.vtu and .pvd is well-formed XML, every file that a .pvd names is there. Temporary files end in .part and do not count.
"""
import csv
import io
import json
import xml.etree.ElementTree as xml


def check_csv(path):
    text = path.read_bytes().decode()
    if not text.endswith("\r\n"):
        return "the last row is cut off"
    if "\n" in text.replace("\r\n", ""):
        return "bare line feed"
    lengths = {len(row) for row in csv.reader(io.StringIO(text, newline=""), strict=True)}
    return None if len(lengths) == 1 else f"rows of {sorted(lengths)} fields"


def check_pvd(path):
    for entry in xml.parse(path).getroot().findall("./Collection/DataSet"):
        if not (path.parent / entry.get("file")).is_file():
            return f"names {entry.get('file')}, which is not there"
    return None


CHECKS = {".csv": check_csv, ".pvd": check_pvd,
          ".json": lambda path: json.loads(path.read_text()) and None,
          ".vtu": lambda path: xml.parse(path) and None}


def check_directory(directory, complaints):
    """Adds what is wrong to the complaints; returns the number of files."""
    n_files = 0
    for path in sorted(directory.iterdir()):
        if path.suffix == ".part" or path.name == "run.lock":
            continue
        n_files += 1
        try:
            complaint = CHECKS.get(path.suffix, lambda path: None)(path)
        except Exception as error:  # any failure to read is what is looked for
            complaint = repr(error)
        if complaint:
            complaints.append(f"{path.name}: {complaint}")
    return n_files


def results(directory):
    """Files by name, without times, memory, and what tells of restarts."""
    files = {}
    for path in directory.iterdir():
        content = path.read_bytes()
        if path.name == "summary.json":
            summary = json.loads(content)
            del summary["seconds"], summary["memory_MB"], summary["work"]
            content = json.dumps(summary)
        elif path.name == "log.txt":
            content = [line for line in content.splitlines() if not line.startswith((b"Time ", b"Restarted "))]
        if path.name != "checkpoint.cbor":
            files[path.name] = content
    return files

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The hand-written part of a generated page: a file of doc/remarks, marked as such."""
import os

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))), "doc", "remarks")


def remarks(page):
    """A section that ends the page."""
    with open(os.path.join(FOLDER, page + ".md"), encoding="utf-8") as file:
        text = file.read()
    return (f"## Remarks\n\n*Written by hand in [remarks/{page}.md](remarks/{page}.md). The numbers above are computed; these "
            f"explanations are not, and a new run does not change them.*\n\n{text}")

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The hand-written part of a generated page: a file of doc/remarks, marked as such."""
import os

FOLDER = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "doc", "remarks")


def by_hand(name, link, text):
    """A section that ends a page; `text` is what the file `name`, relative to the page `link`, says."""
    return (f"## Remarks\n\n*Written by hand in [{name}]({link}). The numbers above are computed; these "
            f"explanations are not, and a new run does not change them.*\n\n{text}")


def remarks(page):
    """The section of doc/remarks/`page`.md."""
    with open(os.path.join(FOLDER, page + ".md"), encoding="utf-8") as file:
        return by_hand(f"remarks/{page}.md", f"remarks/{page}.md", file.read())

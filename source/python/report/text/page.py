# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The pages of a report: sections of parts (texts, tables, numbered figures), put into HTML by the templates beside this
file. A page is one file and needs nothing from the network."""

import dataclasses
import os

import jinja2
import markupsafe

from report.text.words import DIGITS, rounded

_FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "templates")


@dataclasses.dataclass
class Text:
    """A paragraph."""

    text: str
    look: str = ""  # class of the paragraph, such as "warning"
    kind: str = "text"


@dataclasses.dataclass
class Heading:
    """A heading within a section."""

    text: str
    kind: str = "heading"


@dataclasses.dataclass
class Table:
    """Rows of texts and numbers; `name` becomes its id, `digits` are those of its numbers."""

    rows: list
    head: list = None
    name: str = ""
    digits: int = DIGITS
    kind: str = "table"

    @property
    def numeric(self):
        """By column, whether it has a number."""
        return [any(isinstance(row[k], (int, float, Number)) for row in self.rows) for k in range(len(self.head))]


@dataclasses.dataclass
class Fold:
    """Parts that are shown on demand, and printed."""

    title: str
    parts: list
    kind: str = "fold"


@dataclasses.dataclass
class Figure:
    """A drawing as inline SVG. Its `label` is read where it cannot be seen."""

    svg: str
    caption: str
    kind: str = "figure"

    @property
    def label(self):
        return self.caption.split(":")[0]

    @property
    def drawing(self):
        return markupsafe.Markup(self.svg)


@dataclasses.dataclass
class Verdict:
    """The box on top: `look` is good, limit, bad or nothing."""

    look: str
    heading: str
    sentences: list


class Number(str):
    """A number in words already."""


class Page:
    """A page in the making: sections in their order, figures numbered through. `look`: "short" if pages are few."""

    def __init__(self, title, verdict, footer, look=""):
        self.title, self.verdict, self.footer, self.look = title, verdict, footer, look
        self.sections = []

    def section(self, name, title, parts):
        """Parts that are None are left out; without parts there is no section."""
        parts = [part for part in parts if part]
        if parts:
            self.sections.append((name, title, parts))

    def html(self, other=""):
        """The whole page. `other`: (address, words) of the page that belongs to it."""
        environment = jinja2.Environment(loader=jinja2.FileSystemLoader(_FOLDER), autoescape=True, trim_blocks=True,
                                         lstrip_blocks=True)
        environment.filters["rounded"] = rounded
        environment.tests["numeric"] = lambda value: isinstance(value, (int, float, Number)) and not isinstance(value, bool)
        environment.tests["figures"] = lambda value: isinstance(value, (int, float))
        return environment.get_template("page.html").render(page=self, other=other)

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The HTML page of a report: sections, tables, numbered figures; one file, nothing from the network."""

import html
import math

STYLE = """
:root { color: #111; background: #fff; font: 15px/1.5 "DejaVu Sans", Verdana, Arial, sans-serif; }
body { max-width: 58rem; margin: 0 auto; padding: 1.5rem; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .3rem; }
h2 { font-size: 1.25rem; margin: 2.2rem 0 .6rem; padding-bottom: .2rem; border-bottom: 1px solid #999; }
h3 { font-size: 1rem; margin: 1.4rem 0 .4rem; }
p { margin: .4rem 0; }
nav { margin: .8rem 0; font-size: .87rem; }
nav a { margin-right: 1.1em; white-space: nowrap; color: #111; }
.verdict { border: 2px solid #111; border-left-width: 10px; padding: .6rem 1rem; margin: 1rem 0; }
.verdict strong { font-size: 1.15rem; }
.verdict.good { border-color: #009e73; } .verdict.limit { border-color: #c07000; } .verdict.bad { border-color: #b00020; }
.warning { border-left: 5px solid #c07000; padding-left: .7rem; }
table { border-collapse: collapse; margin: .6rem 0; font-size: .85rem; }
th, td { border-bottom: 1px solid #ccc; padding: .18rem .6rem; text-align: left; vertical-align: top; }
thead th { border-bottom: 1.5px solid #333; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
.wide { overflow-x: auto; }
figure { margin: 1.2rem 0; }
figure svg { width: 100%; height: auto; display: block; }
figcaption { font-size: .87rem; margin-top: .3rem; }
summary { cursor: pointer; font-weight: bold; margin: .5rem 0; }
footer { margin-top: 2.5rem; padding-top: .4rem; border-top: 1px solid #999; font-size: .8rem; }
@page { size: A4; margin: 16mm 15mm 18mm; }
@media print {
  :root { font-size: 10pt; }
  body { max-width: none; padding: 0; }
  nav { display: none; }
  h2, h3, h2 + p { break-after: avoid; }
  figure, .verdict, tr, p, #certificate, #remarks { break-inside: avoid; }
  figure svg { max-height: 110mm; }
  thead { display: table-header-group; }
  .wide { overflow: visible; break-inside: avoid; }
  table { font-size: 7.5pt; }
  th, td { padding: .12rem .35rem; }
  details::details-content { content-visibility: visible; }
}
"""
# What is collapsed on the screen is printed.
SCRIPT = """
addEventListener("beforeprint", () => document.querySelectorAll("details").forEach(d => {
  d.dataset.was = d.open; d.open = true; }));
addEventListener("afterprint", () => document.querySelectorAll("details").forEach(d => {
  d.open = d.dataset.was === "true"; }));
"""


def escape(text):
    return html.escape(str(text))


class Shown(str):
    """A number that is HTML already."""


def number(value, digits=6, shown=None):
    """A number for reading, `shown` in its place if given; its attribute `value` has all digits."""
    if isinstance(value, bool) or value is None:
        return escape(value)
    if isinstance(value, float) and not math.isfinite(value):
        return {math.inf: "\u221e", -math.inf: "\u2212\u221e"}.get(value, "\u2013")
    text = f"{value if shown is None else shown:.{digits}g}" if isinstance(value, float) else str(value)
    return f'<data value="{value!r}">{text.replace("-", chr(0x2212))}</data>'


def cell(value, head=False, digits=6):
    """A cell of a table: numbers on the right, text escaped."""
    tag = "th" if head else "td"
    if isinstance(value, Shown):
        return f'<{tag} class="number">{value}</{tag}>'
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return f'<{tag} class="number">{number(value, digits)}</{tag}>'
    return f"<{tag}>{escape(value)}</{tag}>"


def table(rows, head=None, name="", digits=6):
    """A table; `name` becomes its id."""
    text = f'<div class="wide"><table{f""" id="{escape(name)}" """ if name else ""}>'
    if head:
        numeric = [rows and isinstance(value, (int, float, Shown)) for value in rows[0]] if rows else [False] * len(head)
        text += "<thead><tr>" + "".join(f'<th{" class=number" if right else ""}>{escape(title)}</th>'
                                        for title, right in zip(head, numeric)) + "</tr></thead>"
    text += "<tbody>" + "".join("<tr>" + "".join(cell(value, digits=digits) for value in row) + "</tr>\n"
                                for row in rows)
    return text + "</tbody></table></div>\n"


def collapsed(title, content):
    return f"<details><summary>{escape(title)}</summary>\n{content}</details>\n"


class Page:
    """A report in the making: sections in their order, figures numbered through."""

    def __init__(self, title):
        self._title = title
        self._sections = []
        self._figures = 0

    def section(self, name, title, content):
        """`content`: HTML text, or a list of HTML texts and figures. Without content there is no section."""
        parts = [self._figure(part) if hasattr(part, "svg") else part
                 for part in ([content] if isinstance(content, str) else content) if part]
        if parts:
            self._sections.append((name, title, "\n".join(parts)))

    def _figure(self, figure):
        self._figures += 1
        caption = escape(figure.caption)
        label = html.escape(figure.caption.split(":")[0], quote=True)
        svg = figure.svg.replace("<svg ", f'<svg role="img" aria-label="{label}" ', 1)
        return (f'<figure id="figure-{self._figures}">{svg}'
                f"<figcaption><b>Figure {self._figures}.</b> {caption}</figcaption></figure>")

    def text(self, head, foot):
        """The whole page; `head` stands above the sections, `foot` below."""
        links = "\n".join(f'<a href="#{name}">{escape(title)}</a>' for name, title, _ in self._sections)
        sections = "".join(f'<section id="{name}"><h2>{escape(title)}</h2>\n'
                           f"{content}</section>\n" for name, title, content in self._sections)
        return ("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
                '<meta name="viewport" content="width=device-width, initial-scale=1">'
                f"<title>{escape(self._title)}</title><style>{STYLE}</style><script>{SCRIPT}</script></head>\n"
                f"<body><header><h1>{escape(self._title)}</h1>\n{head}</header><nav>{links}</nav>\n"
                f"<main>{sections}</main>\n<footer>{foot}</footer></body></html>\n")

# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""The two pages of the report of a run: what they show, in which order."""

import functools

from report.drawings import joint_diagrams, load_diagrams, motion_diagrams, sketch, stress_diagram
from report.drawings.pictures import Fields, NoPictures, plane_pictures
from report.drawings.space_pictures import joint_maps, space_pictures
from report.text import sections
from report.text.page import Page, Text

# Detailed diagrams are drawn of so many joints, the least safe first; the short version has the first figure of
DRAWN_JOINTS, SHORT_JOINTS = 4, 2
# as many rows of its table, and as many warnings
SHORT_ROWS, SHORT_WARNINGS = 12, 6


class RunParts:
    """What both pages are made of; everything is drawn once. `progress` is told what is being done."""

    def __init__(self, results, progress):
        self.results, self.progress = results, progress

    @property
    def summary(self):
        return self.results.summary

    @functools.cached_property
    def overview(self):
        return sections.joint_overview(self.results)

    @functools.cached_property
    def joints(self):
        """All joints, the least safe first."""
        return [row[0] for row in self.overview.rows]

    @property
    def choice(self):
        """In words, if not all joints are drawn."""
        number = len(self.results.joints)
        return [Text(f"The {DRAWN_JOINTS} least safe of {number} joints.")] if number > DRAWN_JOINTS else []

    def each(self, draw, *arguments):
        """A diagram per drawn joint."""
        figures = []
        for joint in self.joints[:DRAWN_JOINTS]:
            self.progress(f"Report: drawing joint '{joint}' ...")
            figures.append(draw(self.results, joint, *arguments))
        return figures

    @functools.cached_property
    def stresses(self):
        """What presses across the joints: along those in the plane, over those in space."""
        if not self.results.in_space:
            return self.each(stress_diagram.joint_stresses)
        return [Text(self.fields)] if isinstance(self.fields, str) else self.each(joint_maps, self.fields)

    @functools.cached_property
    def sketch(self):
        self.progress("Report: drawing the model ...")
        return sketch.model_sketch(self.results, self.fields)

    @functools.cached_property
    def fields(self):
        """The fields, or the words why there are none."""
        try:
            return Fields(self.results)
        except NoPictures as reason:
            return str(reason)

    @functools.cached_property
    def pictures(self):
        """Figures by name."""
        self.progress("Report: drawing the bodies ...")
        if isinstance(self.fields, str):
            return {"": Text(self.fields)}
        return (space_pictures if self.results.in_space else plane_pictures)(self.results, self.fields)

    @functools.cached_property
    def load(self):
        self.progress("Report: drawing the loads ...")
        return load_diagrams.load_displacement(self.results, self.joints)

    @functools.cached_property
    def motion(self):
        return motion_diagrams.histories(self.results)

    @functools.cached_property
    def spectra(self):
        return motion_diagrams.spectra(self.results)

    @functools.cached_property
    def safety(self):
        return load_diagrams.safety(self.results, self.joints)


def _page(results, title, look=""):
    return Page(title, sections.verdict(results.summary), sections.footer(results.summary), look)


def _empty_page(parts):
    """Of a run that ended before its first level."""
    page = _page(parts.results, parts.results.title or "fuga")
    page.section("results", "Results", [Text("The run ended before its first load level: there is nothing to draw.")])
    page.section("certificate", "Certificate", sections.certificate_table(parts.summary))
    page.section("parameters", "Parameters", sections.parameters(parts.summary))
    return page


def long_page(parts):
    results, summary = parts.results, parts.summary
    if not results.levels:
        return _empty_page(parts)
    levels = results.representative_levels()
    page = _page(results, results.title or "fuga")
    page.section("stresses", "Stresses across the joints", parts.choice + parts.stresses)
    page.section("model", "Model", parts.sketch)
    page.section("joints", "Joints at the end of the loads", [parts.overview])
    page.section("resultants", "Resultants", sections.resultant_tables(results, levels))
    page.section("monitors", "Monitors", sections.monitor_tables(results, levels))
    page.section("motion", "Motion", [sections.continuations(results), parts.motion, parts.spectra])
    page.section("safety", "Safety", [parts.safety])
    page.section("load", "Load and displacement", [parts.load, load_diagrams.beyond_limit(results)])
    if not results.in_space:
        page.section("shear", "Shear stresses and strength", parts.each(joint_diagrams.shear_and_strength, levels))
        page.section("levels", "Stresses at load levels", parts.each(joint_diagrams.pressures, levels))
        page.section("displacements", "Relative displacements", parts.each(joint_diagrams.displacements, levels))
    page.section("pictures", "Bodies", parts.pictures.values())
    page.section("states", "States and events", [load_diagrams.timeline(results)])
    if not results.in_space:
        page.section("paths", "Most used elements", parts.each(joint_diagrams.coulomb_paths))
        page.section("hysteresis", "Hysteresis", parts.each(joint_diagrams.hysteresis))
    page.section("energy", "Energy balance", [load_diagrams.energies(results)
                                              or Text("Energies are not known: the run took implicit steps.")])
    page.section("certificate", "Certificate", sections.certificate_table(summary))
    page.section("remarks", "Joints and warnings", sections.remarks(summary))
    page.section("sizes", "Sizes and work", sections.sizes(summary))
    page.section("parameters", "Parameters", sections.parameters(summary))
    page.section("events", "Events", sections.event_list(results))
    page.section("files", "Files", sections.files(results.directory))
    return page


def short_page(parts):
    results = parts.results
    if not results.levels:
        return _empty_page(parts)
    page = _page(results, f"{results.title or 'fuga'} (short)", "short")
    page.section("stresses", "Stresses across the joints", parts.stresses[:SHORT_JOINTS])
    page.section("model", "Model", parts.sketch)
    page.section("joints", "Joints at the end of the loads", [sections.shortened(parts.overview, SHORT_ROWS)])
    page.section("motion", "Motion", [sections.continuations(results), parts.motion, parts.spectra])
    page.section("safety", "Safety", [parts.safety])
    page.section("load", "Load and displacement", [parts.load])
    page.section("pictures", "Bodies", [parts.pictures.get(name) for name in ("", "principal", "joints", "bodies")])
    page.section("remarks", "Warnings", sections.warnings(parts.summary)[:SHORT_WARNINGS])
    return page

#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
# Copyright (C) 2026 by the Fuga authors
"""Opens a report in Chromium without a network, and prints it. Fails if there is no Chromium; ./check installs it.

usage: report_in_browser.py FUGA

A script in a copy of the page measures it: nothing may be wider than the window, every drawing has a height, every
picture of the bodies is decoded and more than a plain surface, and errors are heard of. The print is a PDF of A4
pages that has the collapsed tables too; that of the short report has at most six.
"""
import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
# Everything is ready at the event "load" and measured in it: nothing waits for Chromium's clock.
MEASURE = """<script>
const errors = []; addEventListener("error", e => errors.push(e.message || "a picture was not read"), true);
const pictures = [...document.querySelectorAll("image")].map(i => {
  const p = document.createElement("img"); p.hidden = true; p.src = i.href.baseVal; document.body.append(p); return p; });
function colours(picture) {
  const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
  canvas.width = picture.naturalWidth; canvas.height = picture.naturalHeight; context.drawImage(picture, 0, 0);
  return new Set(new Uint32Array(context.getImageData(0, 0, canvas.width, canvas.height).data.buffer)).size;
}
addEventListener("load", () => {
  document.title = JSON.stringify({errors, width: document.documentElement.scrollWidth, window: innerWidth,
    drawings: [...document.querySelectorAll("figure svg")].map(s => Math.round(s.getBoundingClientRect().height)),
    pictures: pictures.map(p => p.naturalWidth > 0 ? colours(p) : 0)});
});
</script></body>"""
complaints = []


def check(condition, text):
    if not condition:
        complaints.append(text)


def chromium(program, folder, *arguments):
    return subprocess.run([program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile",
                           "--host-resolver-rules=MAP * ~NOTFOUND", "--no-pdf-header-footer", *arguments],
                          capture_output=True, text=True, timeout=120)


def measure(program, folder, page, width):
    dump = chromium(program, folder, f"--window-size={width},1200", "--dump-dom", page.as_uri())
    title = re.search(r"<title>(.*?)</title>", dump.stdout, re.DOTALL)
    if dump.returncode != 0 or title is None or not title[1].startswith("{"):
        check(False, f"Chromium did not measure the page: {dump.returncode} {dump.stderr[-300:]}")
        return None
    return json.loads(html.unescape(title[1]))


def check_page(program, folder, report):
    text = report.read_text(encoding="utf-8")
    copy = folder / "measured.html"
    copy.write_text(text.replace("</body>", MEASURE), encoding="utf-8")
    for width in (1100, 700):
        found = measure(program, folder, copy, width)
        if not found:
            return
        check(not found["errors"], f"errors: {found['errors']}")
        check(found["width"] <= found["window"], f"{found['width']} wide in a window of {found['window']}")
        check(len(found["drawings"]) == text.count("<figure") and min(found["drawings"]) > 50, f"drawings {found['drawings']}")
        check(len(found["pictures"]) >= 2 and min(found["pictures"]) > 2, f"pictures with {found['pictures']} colours")


def check_print(program, folder, report, fewest, most):
    pdf = folder / "report.pdf"
    run = chromium(program, folder, f"--print-to-pdf={pdf}", report.as_uri())
    check(run.returncode == 0 and pdf.exists(), f"print: {run.returncode} {run.stderr[-300:]}")
    content = pdf.read_bytes() if pdf.exists() else b""
    boxes = re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+) ([\d.]+)", content)
    check(fewest <= len(boxes) <= most, f"{report.name}: {len(boxes)} printed pages")
    # A4 is 595.3 x 841.9 points.
    check(all(abs(float(w) - 595.3) < 1.5 and abs(float(h) - 841.9) < 1.5 for w, h in boxes), f"pages of {set(boxes)}")


def main():
    program = shutil.which("chromium")
    if program is None:
        sys.exit("there is no program 'chromium'; ./check installs it, or: apt-get install chromium")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run = subprocess.run([sys.argv[1], ROOT / "parameters/paper_3_cubic_root.prm", "--quiet", "--output-dir", folder / "run",
                              "--set", "Output/Report=true", "--set", "Output/Fields=end"], capture_output=True, text=True)
        check(run.returncode == 0, f"the run: {run.stderr}")
        for name, fewest, most in (("report.html", 6, 40), ("report_short.html", 2, 6)):
            report = folder / "run" / name
            check_page(program, folder, report)
            check_print(program, folder, report, fewest, most)
    print("\n".join(complaints) or "the report can be seen and printed")
    sys.exit(1 if complaints else 0)


main()

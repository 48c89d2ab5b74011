#!/usr/bin/python3
"""One page about a run, from the run's own files.

Usage: scripts/report.py FOLDER

Writes FOLDER/report.html, which needs no other file: what was computed and how it
ended, warnings and advice, forces and penetrations of each interface, where the time
went, the pictures that are in FOLDER, and all parameters.
"""
import base64
import glob
import html
import json
import os
import re
import sys

STYLE = """
body { font: 15px/1.45 sans-serif; max-width: 62em; margin: 2em auto; color: #222 }
h1 { font-size: 1.5em } h2 { font-size: 1.15em; margin-top: 2em }
table { border-collapse: collapse } td, th { padding: .2em .9em .2em 0; text-align: right }
td:first-child, th:first-child { text-align: left } tr { border-bottom: 1px solid #ddd }
img { max-width: 100% } pre { font-size: 12px; background: #f6f6f6; padding: 1em; overflow: auto }
.note { background: #fff4d6; padding: .6em 1em; margin: .4em 0 }
"""
NOTES = re.compile(r"WARNING|NOTE:|ERROR|ACCURACY:|SPEED:|No convergence|Stopped")
COLUMNS = {
    "force": "force on the secondary",
    "largest_pressure": "largest pressure at a point, on the undeformed area",
    "largest_penetration": "largest penetration",
    "penetration_over_release": "over release",
    "penalty_share": "penalty's share of energy",
    "integration_error": "error of integration",
}


def number(value):
    if isinstance(value, int):
        return f"{value:,}"
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def row(cells, tag="td"):
    return "<tr>" + "".join(f"<{tag}>{html.escape(c)}</{tag}>" for c in cells) + "</tr>"


def table(head, rows):
    return "<table>" + row(head, "th") + "".join(row(r) for r in rows) + "</table>"


def main():
    if len(sys.argv) != 2 or not os.path.exists(os.path.join(sys.argv[1], "summary.json")):
        sys.exit(__doc__)
    folder = sys.argv[1]

    def text_of(name):
        path = os.path.join(folder, name)
        if not os.path.exists(path):
            return ""
        with open(path, encoding="utf-8") as file:
            return file.read()

    summary = json.loads(text_of("summary.json"))
    log = text_of("run.log").splitlines()
    title = html.escape(os.path.basename(os.path.abspath(folder)))
    page = [
        f"<!doctype html><html lang=en><meta charset=utf-8><title>{title}</title>",
        f"<style>{STYLE}</style><h1>{title}</h1>",
        table(["", ""], [
            ["status", summary["status"]],
            ["time reached", number(summary["time"])],
            ["unknowns", f"{summary['dofs']:,}"],
            ["steps", number(summary["steps"])],
            ["Newton iterations", number(summary["newton_iterations"])],
            ["rejected tries", number(summary["cut_backs"])],
            ["wall time", f"{summary['wall_seconds']:.1f} s on {summary['ranks']} ranks"],
            ["peak memory", f"{summary['peak_memory_kB'] / 1e6:.2f} GB"],
            ["MortarContact", summary["version"]],
            ["deal.II", summary["deal.II version"]],
        ]),
    ]

    rejected = [line.strip() for line in log if " rejected: " in line]
    notes = [line.strip() for line in log if NOTES.search(line)]
    # the same words at every step are said once, with their number
    counted = {}
    for line in notes + rejected:
        words = line if ("ACCURACY" in line or "SPEED" in line) else re.sub(
            r"[0-9.eE+-]+", "#", line)
        first, count = counted.get(words, (line, 0))
        counted[words] = (first, count + 1)
    page.append("<h2>Warnings and advice</h2>")
    for first, count in counted.values():
        times = f" ({count} times like this)" if count > 1 else ""
        page.append(f"<p class=note>{html.escape(first)}{times}</p>")
    if not counted:
        page.append("<p>None.</p>")

    interfaces = summary.get("interfaces") or {}
    if interfaces:
        page.append("<h2>Contact at the end</h2>")
        rows = []
        for name, values in interfaces.items():
            cells = [name]
            for key in COLUMNS:
                value = values.get(key, "")
                cells.append(", ".join(number(v) for v in value)
                             if isinstance(value, list) else number(value))
            rows.append(cells)
        page.append(table(["interface"] + list(COLUMNS.values()), rows))

    seconds = sorted(summary.get("seconds", {}).items(), key=lambda item: -item[1])
    if seconds:
        page.append("<h2>Time</h2>")
        page.append(table(["", "s", "%"], [
            [name, f"{s:.1f}", f"{100 * s / summary['wall_seconds']:.0f}"]
            for name, s in seconds]))

    pictures = sorted(glob.glob(os.path.join(folder, "*.png")))
    if pictures:
        page.append("<h2>Pictures</h2>")
    for picture in pictures:
        with open(picture, "rb") as file:
            data = base64.b64encode(file.read()).decode()
        name = html.escape(os.path.basename(picture))
        page.append(f'<p><img alt="{name}" src="data:image/png;base64,{data}"></p>')

    parameters = text_of("parameters.prm")
    if parameters:
        page.append("<h2>Parameters</h2><details><summary>All, as used</summary>"
                    f"<pre>{html.escape(parameters)}</pre></details>")
    path = os.path.join(folder, "report.html")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(page) + "\n</html>\n")
    print(f"Report: {path}")


if __name__ == "__main__":
    main()

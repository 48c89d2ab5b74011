#!/usr/bin/python3
"""Two leaflets in a channel on finer and finer meshes, with shorter and shorter steps.

Usage: benchmarks/immersed_valve.py [--end-time T] [--most-cells N] [--output DIR]

Runs benchmarks/immersed_valve.prm with 16, 32, 64 cells across at the leaflets (in all
other things as it is), then with half the step, and prints how far the curves of a tip
lie from those of the finest, over their range, and how well the two leaflets mirror
each other.
"""
import csv
import os

import numpy as np

from run_driver import ROOT, parser, run


def curves(folder):
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def main():
    options = parser(__doc__, "immersed_valve")
    options.add_argument("--end-time", default="1")
    options.add_argument("--most-cells", type=int, default=64)
    options.set_defaults(ranks=1)
    arguments = options.parse_args()
    file = os.path.join(ROOT, "benchmarks/immersed_valve.prm")
    variants = [(n, "0.01") for n in (16, 32, 64) if n <= arguments.most_cells]
    variants.append((32, "0.005"))
    results = {}
    for n, step in variants:
        settings = [f"Channel/Cells={5 * n // 4}, {n // 4}", f"Steps/First step={step}",
                    f"Steps/End time={arguments.end_time}", "Output/Every=0"]
        summary, folder = run("immersed_leaflets", file, f"{n} {step}", settings, arguments)
        results[n, step] = summary, curves(folder)

    def difference(one, other, name):
        a, b = results[one][1], results[other][1]
        return np.abs(np.interp(a["time"], b["time"], b[name]) - a[name]).max() / np.ptp(b[name])

    finest = (max(n for n, _ in variants), "0.01")
    print("| cells across | step | iterations | per step | cut-backs | seconds | mirror | tip x % | tip y % |")
    print("|" + "---|" * 9)
    for (n, step), (summary, c) in results.items():
        other = finest if step == "0.01" else (n, "0.01")
        height = c["leaflet_0:tip_y"][0] + c["leaflet_1:tip_y"][0]
        mirror = max(np.abs(c["leaflet_0:tip_x"] - c["leaflet_1:tip_x"]).max(),
                     np.abs(c["leaflet_0:tip_y"] + c["leaflet_1:tip_y"] - height).max())
        text = [f"{100 * difference((n, step), other, 'leaflet_0:tip_' + x):.2f}" for x in "xy"]
        print(f"| {n} | {step} | {summary['newton_iterations']} "
              f"| {summary['newton_iterations'] / max(1, summary['steps']):.1f} | {summary['cut_backs']} "
              f"| {summary['wall_seconds']:.0f} | {mirror:.1e} | {text[0]} | {text[1]} |")


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Contact methods compared on the dummy on the hood.

Usage: benchmarks/dummy_on_hood.py [--file FILE.prm] [--repeat N] [--ranks N]
         [--output DIR] [--reference] [--reference-run DIR] [--tight] [--set "Section/Entry=value"]...

Runs the same scene, with the same solver and tolerances, by
  segments   mortar contact over the overlaps of facets,
  points     mortar contact at fixed points of the secondary's facets,
  nodes      node-to-segment contact with the linear law,
  smoothed   the same with the smoothed stiffness of the mortar contact's law,
in turn, N times each, and writes DIR/table.md and DIR/forces.png from the runs'
own files. --reference adds a run with a finer panel and dummy and tolerances
a hundred times tighter, --reference-run takes a run that is there (as of
dummy_on_hood_fine.prm), --tight adds one such run of each method on its own mesh.

Roughness of the force at equal steps of the motion, while pressed / while slid:
  ripple     rms distance from the local parabola through 7 samples, over the mean
  kink       largest second difference, over the mean
  excess     total variation over the range, less 1 (both phases are one-way)
Snaps of the sheets are in all of them: compare methods, not with zero.
"""
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from run_driver import ROOT, parser, run

METHODS = {
    "segments": ["Contact/Integration=segments"],
    "points": ["Contact/Integration=points"],
    "nodes": ["Contact/Integration=nodes", "Contact/Law=linear"],
    "smoothed": ["Contact/Integration=nodes"],
}
TIGHT = [
    "Solver/Newton/Force tolerance=1e-10",
    "Solver/Newton/Displacement tolerance=1e-8",
]
FINE = ["Hood/Panel cells=60, 72", "Dummy/Facet size=5"] + TIGHT
WINDOW = 7


def sampled(name, settings, arguments):
    """One run at equal samples, whatever the steps between: summary and history."""
    times = ", ".join(f"{arguments.sample * i:.10g}" for i in range(1, 1000)
                      if arguments.sample * i < 2.0)
    settings = [f"Steps/Times to meet={times}", "Output/Every=0"] + settings
    summary, folder = run("dummy_on_hood", arguments.file, name, settings, arguments)
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        return summary, list(csv.DictReader(file))


def curve(rows, sample):
    """Times on the grid and the force on the dummy there, upward."""
    time = np.array([float(row["time"]) for row in rows])
    force = -np.array([float(row["dummy:force_z"]) for row in rows])
    on_grid = np.abs(time / sample - np.round(time / sample)) < 1e-6
    return time[on_grid], force[on_grid]


def roughness(time, force):
    """Measures of the text above: while pressed, while slid."""
    pressed = (force > 0.1 * force.max()) & (time <= 1.0 + 1e-9)
    measures = []
    for f in (force[pressed], force[time > 1.0 + 1e-9]):
        if len(f) < WINDOW + 1:
            return None
        mean = f.mean()
        x = np.arange(WINDOW) - WINDOW // 2
        rest = [
            f[i : i + WINDOW] - np.polyval(np.polyfit(x, f[i : i + WINDOW], 2), x)
            for i in range(len(f) - WINDOW + 1)
        ]
        measures.append(
            {
                "ripple": np.sqrt(np.mean(np.square(rest))) / mean,
                "kink": np.abs(np.diff(f, 2)).max() / mean,
                "excess": np.abs(np.diff(f)).sum() / np.ptp(f) - 1.0,
            }
        )
    return measures


def error(curve_of_run, reference):
    """rms and largest distance from the reference, over its mean force."""
    t, f = curve_of_run
    t, f = t[t <= reference[0][-1] + 1e-9], f[t <= reference[0][-1] + 1e-9]
    other = np.interp(t, *reference)
    mean = reference[1][reference[1] > 0.0].mean()
    return np.sqrt(np.mean((f - other) ** 2)) / mean, np.abs(f - other).max() / mean


def main():
    options = parser(__doc__, "hood_methods")
    options.add_argument("--file", default=os.path.join(ROOT, "prm/dummy_on_hood.prm"))
    options.add_argument("--repeat", type=int, default=1)
    options.add_argument("--sample", type=float, default=0.05, help="time between samples")
    options.add_argument("--reference", action="store_true")
    options.add_argument("--reference-run", metavar="DIR")
    options.add_argument("--tight", action="store_true")
    arguments = options.parse_args()
    os.makedirs(arguments.output, exist_ok=True)

    results, seconds = {}, {name: [] for name in METHODS}
    for _ in range(arguments.repeat):
        for name, settings in METHODS.items():
            results[name] = sampled(name, settings, arguments)
            seconds[name].append(results[name][0]["wall_seconds"])
    reference = tight = None
    if arguments.reference:
        reference = curve(sampled("reference", FINE, arguments)[1], arguments.sample)
    if arguments.reference_run:
        with open(os.path.join(arguments.reference_run, "history.csv"), newline="") as file:
            reference = curve(list(csv.DictReader(file)), arguments.sample)
    if arguments.tight:
        tight = {
            name: curve(sampled(f"{name} tight", settings + TIGHT, arguments)[1], arguments.sample)
            for name, settings in METHODS.items()
        }

    base = np.median(seconds["segments"])
    lines = [
        "| method | finished | iterations | per step | cut-backs | time | ripple % | kink % "
        "| excess % | error rms % | error max % | tolerance 1/100 % | penetration % |",
        "|" + "---|" * 13,
    ]
    figure, axis = plt.subplots(figsize=(9, 5))
    if reference is not None:
        axis.plot(*reference, "k", linewidth=2.5, alpha=0.4, label="reference")
    for name in METHODS:
        summary, rows = results[name]
        t, f = curve(rows, arguments.sample)
        axis.plot(t, f, ".-", linewidth=1, markersize=3, label=name)
        finished = summary["status"] == "finished"
        r = roughness(t, f)
        rough = ["", "", ""]
        if r is not None:
            rough = [
                " / ".join(f"{100 * phase[key]:.2f}" for phase in r)
                for key in ("ripple", "kink", "excess")
            ]
        steps = max(1, summary["steps"])
        against = ("", "")
        if reference is not None:
            against = tuple(f"{100 * e:.2f}" for e in error((t, f), reference))
        change = f"{100 * error((t, f), tight[name])[0]:.4f}" if tight else ""
        deepest = max(float(row["dummy:penetration_over_release"]) for row in rows)
        lines.append(
            f"| {name} | {'yes' if finished else 'to ' + str(round(t[-1], 3))} "
            f"| {summary['newton_iterations']} | {summary['newton_iterations'] / steps:.1f} "
            f"| {summary['cut_backs']} | {np.median(seconds[name]) / base:.2f} "
            f"| {rough[0]} | {rough[1]} | {rough[2]} | {against[0]} | {against[1]} | {change} | {100 * deepest:.1f} |"
        )
    lines += [
        "",
        f"Time: median of {arguments.repeat} over that of segments, {base:.1f} s on "
        f"{arguments.ranks} ranks. {' '.join(arguments.set)}",
    ]
    axis.set_xlabel("time: pressed until 1, then slid")
    axis.set_ylabel("force on the dummy [N]")
    axis.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.output, "forces.png"), dpi=110)
    text = "\n".join(lines) + "\n"
    with open(os.path.join(arguments.output, "table.md"), "w") as file:
        file.write(text)
    print(text)


if __name__ == "__main__":
    main()

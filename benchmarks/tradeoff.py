#!/usr/bin/python3
"""What accuracy costs: five scenes over integration, stiffness, tolerances, order, mesh.

Usage: benchmarks/tradeoff.py [--scene NAME]... [--ranks N] [--repeat N] [--output DIR]

Each setting is varied alone, from the scene's own file; then the presets of
'Accuracy'. Errors are against the references beside the scenes: closed forms and
published values, or the same mesh with contact solved to 1e-10 with a penalty so stiff
that it hardly matters: what the settings of contact add to the error of the mesh. Times are ratios to the default of the same round, median of the rounds.

Writes DIR/table.md (with the Pareto front of error and time marked by *) and
DIR/tradeoff.png.
"""
import csv
import os

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from run_driver import ROOT, parser, run

INTEGRATION = {
    "nodes": ["Integration=nodes"],
    **{f"points {n}": ["Integration=points", f"Points per direction={n}"] for n in (2, 3, 5, 10)},
    **{f"segments, degree {n}": ["Integration=segments", f"Degree={n}"] for n in range(2, 7)},
}
TOLERANCE = {
    f"force tolerance {t:g}": [
        f"Solver/Newton/Force tolerance={t:g}",
        f"Solver/Newton/Displacement tolerance={100 * t:g}",
    ]
    for t in (1e-2, 1e-4, 1e-6, 1e-10)
}
PRESETS = {f"Accuracy = {name}": [f"Accuracy={name}"] for name in ("fast", "balanced", "exact")}


def history(folder, column):
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    return (
        np.array([float(row["time"]) for row in rows]),
        np.array([float(row[column]) for row in rows]),
    )


def ripple(times, values, start, end):
    """Distance from the best parabola, peak to peak, over the mean."""
    inside = (times >= start) & (times <= end)
    t, v = times[inside], values[inside]
    if len(t) < 8:
        return float("nan")
    rest = v - np.polyval(np.polyfit(t, v, 2), t)
    return np.ptp(rest) / abs(v.mean())


def last(folder, column):
    return history(folder, column)[1][-1]


class Scene:
    """A file, its interface, what is varied beside what all scenes share."""

    def __init__(self, driver, file, section, name, base=(), scale=1.0, mesh=None, order=None,
                 length=1.0, linear=False):
        self.driver, self.file, self.section = driver, os.path.join(ROOT, file), section
        self.name, self.base = name, list(base)
        self.settings = {"default": []}
        for label, entries in INTEGRATION.items():
            self.settings[label] = [f"{section}/{e}" for e in entries]
        for factor in (0.1, 10, 100)[: 2 if isinstance(self, Compared) else 3]:
            self.settings[f"stiffness x {factor:g}"] = [f"{section}/Stiffness scale={scale * factor:g}"]
        for share in (1e-3, 1e-4):
            self.settings[f"Uzawa to {share:g} h"] = [
                f"{section}/Augmentation=Uzawa",
                f"{section}/Penetration tolerance={share * length:g}",
            ]
        self.settings.update(TOLERANCE)
        if linear:
            for t in (1e-1, 1e-3, 1e-6):
                self.settings[f"iterative, linear tolerance {t:g}"] = [
                    "Solver/Linear/Type=iterative", f"Solver/Linear/Mixed tolerance={t:g}"]
        self.settings.update(mesh or {})
        self.settings.update(order or {})
        self.settings.update(PRESETS)
        # contact as exact as it gets on this mesh
        self.exact = [
            f"{section}/Degree=6",
            f"{section}/Stiffness scale={scale * 30:g}",
            "Solver/Newton/Force tolerance=1e-10",
            "Solver/Newton/Displacement tolerance=1e-8",
        ]

    def contact(self, summary):
        return summary["interfaces"][self.name]


class Hertz(Scene):
    def __init__(self):
        super().__init__(
            "contact_scene", "benchmarks/trade/hertz.prm", "Contact/contact", "contact",
            scale=100, length=0.04,
            mesh={"mesh / 2": ["Bodies/sphere/Mesh/Local refinements=2"],
                  "mesh x 2": ["Bodies/sphere/Mesh/Local refinements=4"]},
            order={"degree 2": ["Bodies/sphere/Degree=2"]})

    def measure(self, summary, folder):
        c = self.contact(summary)
        # Hertz: F, p0 = (6 F E*^2/(pi^3 R^2))^(1/3)
        return {"force": abs(-c["force"][2] / 7071.0678 - 1.0),
                "pressure": abs(c["largest_pressure"] / 675237.2 - 1.0)}


class Rings(Scene):
    def __init__(self):
        super().__init__(
            "contact_scene", "benchmarks/trade/rings.prm", "Contact/fit", "fit",
            scale=200, length=0.02,
            mesh={"mesh / 2": ["Bodies/inner/Mesh/Cells=24, 4", "Bodies/outer/Mesh/Cells=32, 4"],
                  "mesh x 2": ["Bodies/inner/Mesh/Cells=96, 16", "Bodies/outer/Mesh/Cells=128, 16"]},
            order={"degree 2": ["Bodies/inner/Degree=2", "Bodies/outer/Degree=2"]})

    def measure(self, summary, folder):
        # Michell: force of a quarter along x, R (p0 + p2/3), and motion of the outer ring
        # at theta = 0. (Single pressures between polygons that do not match scatter.)
        force = 0.6 * (462963.0 + 67859.0 / 3.0)
        return {"force": abs(abs(self.contact(summary)["force"][0]) / force - 1.0),
                "motion": abs(summary["probes"]["out"][0] / (0.05 * -7.17366e-3) - 1.0)}


class Ironing(Scene):
    def __init__(self):
        super().__init__(
            "contact_scene", "prm/verification/ironing.prm", "Contact/ironing", "ironing",
            base=["Steps/End time=1.6", "Steps/First step=0.02", "Steps/Largest step=0.02",
                  "Steps/Smallest step=0.005"],
            scale=100, length=0.1,
            mesh={"mesh / 2": ["Bodies/block/Mesh/Cells=60, 8", "Bodies/indenter/Mesh/Cells=6, 4"]})

    def measure(self, summary, folder):
        t, f = history(folder, "ironing:force_y")
        # Poulios & Renard's curve, see ironing.expected
        return {"force": abs(np.interp(1.55, t, f) / -3.385e8 - 1.0),
                "ripple": ripple(t, f, 1.3, 1.6)}


class Compared(Scene):
    """The reference is the run with `exact`."""

    reference = None


class RubberFit(Compared):
    def __init__(self):
        super().__init__(
            "rubber_fit", "prm/rubber_fit.prm", "Contact", "fit", scale=20, length=0.5,
            linear=True)
        # overlaps that are taken away over time and augmented take for ever
        for name in [name for name in self.settings if name.startswith("Uzawa")]:
            del self.settings[name]

    def value(self, summary, folder):
        c = self.contact(summary)
        return {"force": np.linalg.norm(c["force"]), "pressure": c["largest_pressure"]}


class Hood(Compared):
    def __init__(self):
        super().__init__(
            "dummy_on_hood", "tests/prm/small_hood.prm", "Contact", "dummy", scale=1, length=15)

    def value(self, summary, folder):
        t, f = history(folder, "dummy:force_z")
        return {"force": f[-1]}


SCENES = {"hertz": Hertz, "rings": Rings, "ironing": Ironing, "rubber_fit": RubberFit, "hood": Hood}


def errors(scene, summary, folder):
    if summary["status"] != "finished":
        return {}
    if not isinstance(scene, Compared):
        return scene.measure(summary, folder)
    values = scene.value(summary, folder)
    return {key: abs(v / scene.reference[key] - 1.0) for key, v in values.items()}


def front(points):
    """Labels of points that no other beats in both error and time."""
    return {
        a for a, (x, y) in points.items()
        if not any(u <= x and v <= y and (u < x or v < y) for u, v in points.values())
    }


def percent(x):
    return "" if np.isnan(x) else f"{100 * x:.3g}"


def study(label, arguments, axis):
    scene = SCENES[label]()

    def once(name, settings):
        return run(scene.driver, scene.file, f"{label} {name}",
                   ["Output/Every=0"] + scene.base + settings, arguments)

    if isinstance(scene, Compared):
        scene.reference = scene.value(*once("exact", scene.exact))
    rows = {name: {"ratio": []} for name in scene.settings}
    for _ in range(arguments.repeat):
        base = None
        for name, settings in scene.settings.items():
            summary, folder = once(name, settings)
            base = base or summary["wall_seconds"]
            row = rows[name]
            row["ratio"].append(summary["wall_seconds"] / base)
            row.update(errors=errors(scene, summary, folder), summary=summary)
    keys = sorted({key for row in rows.values() for key in row["errors"]})
    main_key = keys[0]
    points = {
        name: (row["errors"][main_key], float(np.median(row["ratio"])))
        for name, row in rows.items() if row["errors"]
    }
    best = front(points)
    lines = [
        f"## {label}",
        "",
        "| setting | time | iterations | cut-backs | "
        + " | ".join(f"{key} error %" if key != "ripple" else "ripple %" for key in keys)
        + " | penetration / release % | integration % | penalty % |",
        "|" + "---|" * (7 + len(keys)),
    ]
    for name, row in rows.items():
        s = row["summary"]
        c = scene.contact(s)
        cells = [percent(row["errors"].get(key, float("nan"))) for key in keys]
        if not row["errors"]:
            cells[0] = f"to {s['time']:.3g}"
        lines.append(
            f"| {'*' if name in best else ''}{name} | {np.median(row['ratio']):.2f} "
            f"| {s['newton_iterations']} | {s['cut_backs']} | " + " | ".join(cells)
            + f" | {percent(c['penetration_over_release'])} | {percent(c['integration_error'])} "
            f"| {percent(c['penalty_share'])} |")
    memory = rows["default"]["summary"]["peak_memory_kB"] / 1e6
    lines += ["", f"Time 1: {rows['default']['summary']['wall_seconds']:.2f} s, "
              f"{rows['default']['summary']['dofs']} dofs, {memory:.2f} GB.", ""]

    for name, (x, y) in points.items():
        preset = name.startswith("Accuracy")
        axis.plot(y, max(x, 1e-6), "s" if preset else ("o" if name in best else "."),
                  color="C3" if preset else ("C0" if name in best else "0.6"))
        if preset or name in best:
            axis.annotate(name.replace("Accuracy = ", ""), (y, max(x, 1e-6)), fontsize=6)
    axis.set_xscale("log")
    axis.set_yscale("log")
    axis.set_title(f"{label}: {main_key}", fontsize=9)
    axis.set_xlabel("time over default", fontsize=8)
    axis.set_ylabel("relative error", fontsize=8)
    return lines


def main():
    options = parser(__doc__, "tradeoff")
    options.add_argument("--scene", action="append", choices=list(SCENES))
    options.add_argument("--repeat", type=int, default=1)
    arguments = options.parse_args()
    os.makedirs(arguments.output, exist_ok=True)
    chosen = arguments.scene or list(SCENES)
    figure, axes = plt.subplots(1, len(chosen), figsize=(3.6 * len(chosen), 3.6), squeeze=False)
    lines = []
    for label, axis in zip(chosen, axes[0]):
        lines += study(label, arguments, axis)
        figure.tight_layout()
        figure.savefig(os.path.join(arguments.output, "tradeoff.png"), dpi=110)
        with open(os.path.join(arguments.output, "table.md"), "w") as file:
            file.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()

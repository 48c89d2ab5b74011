#!/usr/bin/python3
"""Pictures of a finished run of dummy_on_hood, from the run's own files.

Usage: scripts/hood_pictures.py FOLDER

Writes FOLDER/hood.png (panel with its displacement upward and dummy, at the end
of pressing and at the end) and FOLDER/force.png (force on the dummy over time).
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from vtu_polygons import files_at, polygons_of


def draw(axis, folder, time):
    now, solution = files_at(folder, "solution.pvd", time)
    polygons, colors, points = [], [], []
    norm = plt.Normalize(-20.0, 2.0)
    for name, file in solution.items():
        p, lift, _ = polygons_of(file, True)
        if "frame" in name:
            continue  # hidden below the panel; drawing by depth mixes them
        if "panel" in name:
            points = np.concatenate(p)
            norm = plt.Normalize(lift.min(), max(lift.max(), 1e-9))
            colors += list(plt.cm.viridis(norm(lift)))
        else:
            colors += [(0.85, 0.55, 0.4, 1.0)] * len(p)
        polygons += p
    for name, file in files_at(folder, "contact.pvd", time)[1].items():
        if name.startswith("contact-dummy"):
            p, _, side = polygons_of(file, False)
            # the rigid dummy is the primary side; draw its lower part only
            keep = [q for q, s in zip(p, side) if s > 0.5]
            polygons += keep
            colors += [(0.85, 0.55, 0.4, 0.55)] * len(keep)
    axis.add_collection3d(
        Poly3DCollection(polygons, facecolors=colors, edgecolors=(0, 0, 0, 0.25), linewidths=0.15)
    )
    low, high = points.min(axis=0), points.max(axis=0)
    high[2] += 200.0
    axis.set_xlim(low[0], high[0])
    axis.set_ylim(low[1], high[1])
    axis.set_zlim(low[2], high[2])
    axis.set_box_aspect(high - low)
    axis.view_init(elev=28, azim=-125)
    axis.set_axis_off()
    axis.set_title(f"time {now:.2f}")
    return plt.cm.ScalarMappable(norm=norm, cmap="viridis")


def main():
    if len(sys.argv) != 2 or not os.path.exists(os.path.join(sys.argv[1], "solution.pvd")):
        sys.exit(__doc__)
    folder = sys.argv[1]
    figure = plt.figure(figsize=(13, 5))
    for i, time in enumerate((1.0, 2.0)):
        axis = figure.add_subplot(1, 2, i + 1, projection="3d")
        figure.colorbar(draw(axis, folder, time), ax=axis, shrink=0.6, label="panel, up")
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "hood.png"), dpi=120)

    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    time = [float(row["time"]) for row in rows]
    figure, axis = plt.subplots(figsize=(7, 4))
    for c, name in zip("xyz", ("along the car", "across", "up")):
        axis.plot(time, [-float(row["dummy:force_" + c]) for row in rows], ".-", label=name)
    axis.set_xlabel("time: pressed until 1, then slid")
    axis.set_ylabel("force on the dummy")
    axis.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "force.png"), dpi=120)
    print(f"Pictures: {folder}/hood.png, force.png")


if __name__ == "__main__":
    main()

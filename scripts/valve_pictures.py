#!/usr/bin/python3
"""Pictures of a finished run of shell_leaflet, from the run's own files.

Usage: scripts/valve_pictures.py FOLDER

Writes FOLDER/valve.png (the leaflets from the aorta and from the side, at six times)
and FOLDER/valve_history.png (over time: force of the leaflets on the tube and area in
contact; with a fluid also pressures, flow, orifice, and what the leaflets sweep).
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

VIEWS = {"from the aorta": (90, 0), "from the side": (25, -60)}


def main():
    if len(sys.argv) != 2 or not os.path.exists(os.path.join(sys.argv[1], "solution.pvd")):
        sys.exit(__doc__)
    folder = sys.argv[1]
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    time = np.array([float(row["time"]) for row in rows])

    # states that differ: equal shares of the path of the volume that the leaflets sweep,
    # or of the force on the tube
    force = np.array([float(row["reaction:attachment_z"]) for row in rows])
    moves = force
    if "fluid:lumen_volume_change" in rows[0]:
        moves = np.array([float(row["fluid:lumen_volume_change"]) for row in rows])
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(moves)))])
    path = path / max(path[-1], 1e-300) + time / time[-1]
    times = [0.0] + [float(np.interp(s * path[-1], path, time)) for s in (0.2, 0.4, 0.6, 0.8, 1.0)]
    figure = plt.figure(figsize=(3 * len(times), 6))
    for column, wanted in enumerate(times):
        now, files = files_at(folder, "solution.pvd", wanted)
        polygons, lifts = [], []
        for file in files.values():
            p, lift, _ = polygons_of(file, True)
            polygons += p
            lifts.append(lift)
        lifts = np.concatenate(lifts)
        points = np.concatenate(polygons)
        for row, (name, (elevation, azimuth)) in enumerate(VIEWS.items()):
            axis = figure.add_subplot(
                2, len(times), 1 + column + row * len(times), projection="3d"
            )
            colors = plt.cm.viridis(plt.Normalize(-0.5, 0.5)(lifts / np.ptp(points[:, 0])))
            axis.add_collection3d(
                Poly3DCollection(
                    polygons, facecolors=colors, edgecolors=(0, 0, 0, 0.3), linewidths=0.2
                )
            )
            if column == 0:
                low, high = points.min(axis=0), points.max(axis=0)
                low[2], high[2] = low[2] - 0.3 * (high[2] - low[2]), high[2] + 0.5 * (
                    high[2] - low[2]
                )
                axis.set_title(name, loc="left", fontsize=8)
            axis.set_xlim(low[0], high[0])
            axis.set_ylim(low[1], high[1])
            axis.set_zlim(low[2], high[2])
            axis.set_box_aspect(high - low)
            axis.view_init(elev=elevation, azim=azimuth)
            axis.set_axis_off()
            if row == 0:
                axis.text2D(0.5, 0.95, f"time {now:.3g}", transform=axis.transAxes, ha="center")
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "valve.png"), dpi=110)

    def series(name):
        return [float(row[name]) for row in rows]

    has_fluid = "fluid:jet" in rows[0]
    figure, axes = plt.subplots(
        5 if has_fluid else 1, 1, figsize=(7, 11 if has_fluid else 4), sharex=True, squeeze=False
    )
    axis = axes[-1, 0]
    axis.plot(time, -force, ".-", markersize=3, label="on the tube, up")
    twin = axis.twinx()
    for column in rows[0]:
        if column.endswith(":active_area"):
            twin.plot(time, series(column), "--", label="contact area, " + column[:-12])
    twin.set_ylabel("area in contact")
    twin.legend(loc="lower right")
    if has_fluid:
        panels = [
            ("pressure", ["ventricle_pressure", "lumen_pressure", "aortic_pressure"]),
            ("flow", ["jet", "aortic_flow"]),
            ("area", ["orifice_area", "edge_area"]),
            ("volume", ["sinus_1_volume_change", "lumen_volume_change"]),
        ]
        for panel, (label, names) in zip(axes[:, 0], panels):
            for name in names:
                panel.plot(time, series("fluid:" + name), label=name.replace("_", " "))
            panel.set_ylabel(label)
            panel.legend(fontsize=8)
    axis.set_xlabel("time")
    axis.set_ylabel("force")
    axis.legend(loc="upper left")
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "valve_history.png"), dpi=110)
    print(f"Pictures: {folder}/valve.png, valve_history.png")


if __name__ == "__main__":
    main()

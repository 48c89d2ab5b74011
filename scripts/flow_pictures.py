#!/usr/bin/python3
"""Pictures of a run of immersed_leaflets, from the run's own files.

Usage: scripts/flow_pictures.py FOLDER

Writes FOLDER/flow.png (speed of the fluid and leaflets at six times that differ) and
FOLDER/flow_history.png (flow, pressures, tips and contact force over time).
"""
import csv
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from matplotlib.collections import LineCollection
from vtk.util.numpy_support import vtk_to_numpy

from vtu_polygons import files_at

N_TIMES = 6


def grid_of(file):
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def flow_of(file):
    """Quadrilaterals split into triangles: x, y, triangles, velocity."""
    grid = grid_of(file)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)
    triangles = np.concatenate([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])
    velocity = vtk_to_numpy(grid.GetPointData().GetArray("velocity"))
    return x[:, 0], x[:, 1], triangles, velocity


def lines_of(file):
    """Present ends of the leaflets' cells."""
    grid = grid_of(file)
    x = vtk_to_numpy(grid.GetPoints().GetData())
    x = x + vtk_to_numpy(grid.GetPointData().GetArray("displacement"))
    return x[vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 2), :2]


def main():
    if len(sys.argv) != 2 or not os.path.exists(os.path.join(sys.argv[1], "solution.pvd")):
        sys.exit(__doc__)
    folder = sys.argv[1]
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    series = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
    time = series["time"]

    # equal shares of the path of a tip, and of time; files of the fluid, of the leaflets
    path = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(series["leaflet_0:tip_y"])))])
    path = path / max(path[-1], 1e-300) + 0.3 * time / time[-1]
    states = []
    for share in np.linspace(0.0, 1.0, N_TIMES):
        now, files = files_at(folder, "solution.pvd", float(np.interp(share * path[-1], path, time)))
        states.append((now, sorted(files.values())))
    figure, axes = plt.subplots(N_TIMES // 2, 2, figsize=(11, 1.9 * N_TIMES // 2))
    for axis, (now, files) in zip(axes.T.flat, states):
        x, y, triangles, velocity = flow_of(files[0])
        speed = np.linalg.norm(velocity, axis=1)
        axis.tricontourf(
            x, y, triangles, speed, levels=np.linspace(0.0, max(speed.max(), 1e-12), 33)
        )
        lines = lines_of(files[1])
        axis.add_collection(LineCollection(lines, colors="w", linewidths=3, capstyle="round"))
        axis.add_collection(LineCollection(lines, colors="r", linewidths=1.5, capstyle="round"))
        axis.set_aspect("equal")
        # where the leaflets are, with as much again on either side
        middle, reach = lines[..., 0].mean(), 1.5 * np.ptp(y)
        axis.set_xlim(max(x.min(), middle - reach), min(x.max(), middle + reach))
        axis.set_title(f"time {now:.3g}, speed to {speed.max():.2g}", fontsize=8, loc="left")
        axis.set_xticks([])
        axis.set_yticks([])
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "flow.png"), dpi=110)

    panels = [
        ("flow", ["inflow", "outflow"]),
        ("pressure", ["inlet_pressure", "outlet_pressure"]),
        ("tips", [name for name in series if ":tip_" in name]),
    ]
    if "contact:force_y" in series:
        panels.append(("contact", ["contact:force_x", "contact:force_y"]))
    figure, axes = plt.subplots(len(panels), 1, figsize=(7, 2.4 * len(panels)), sharex=True)
    for axis, (label, names) in zip(axes, panels):
        for name in names:
            axis.plot(time, series[name], label=name.replace("_", " "))
        axis.set_ylabel(label)
        axis.legend(fontsize=8)
    axes[-1].set_xlabel("time")
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "flow_history.png"), dpi=110)
    print(f"Pictures: {folder}/flow.png, flow_history.png")


if __name__ == "__main__":
    main()

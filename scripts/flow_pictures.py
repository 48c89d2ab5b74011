#!/usr/bin/python3
"""Pictures of a run of immersed_leaflets, from the run's own files.

Usage: scripts/flow_pictures.py FOLDER

Writes FOLDER/flow.png (speed of the fluid, streamlines and leaflets at six times) and
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

    # fluid, then leaflets
    states = []
    for t in np.linspace(time[0], time[-1], N_TIMES):
        now, files = files_at(folder, "solution.pvd", t)
        states.append((now, sorted(files.values())))
    flows = [flow_of(files[0]) for _, files in states]
    fastest = max(np.linalg.norm(flow[3], axis=1).max() for flow in flows)
    figure, axes = plt.subplots(N_TIMES, 1, figsize=(9, 2.1 * N_TIMES), sharex=True)
    for axis, (now, files), (x, y, triangles, velocity) in zip(axes, states, flows):
        speed = np.linalg.norm(velocity, axis=1)
        colours = axis.tricontourf(
            x, y, triangles, speed, levels=np.linspace(0.0, max(fastest, 1e-300), 33)
        )
        lines = lines_of(files[1])
        for line in lines:
            axis.plot(line[:, 0], line[:, 1], "w-", linewidth=3)
            axis.plot(line[:, 0], line[:, 1], "r-", linewidth=1.5)
        axis.set_aspect("equal")
        # where the leaflets are, with as much again on either side
        middle, reach = lines[..., 0].mean(), 2.0 * np.ptp(y)
        axis.set_xlim(max(x.min(), middle - reach), min(x.max(), middle + 1.5 * reach))
        axis.set_title(f"time {now:.3g}", fontsize=8, loc="left")
        figure.colorbar(colours, ax=axis, label="speed", format="%.2g")
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

#!/usr/bin/python3
"""A picture of any finished run: bodies and forces.

Usage: scripts/plot_run.py FOLDER [--time T] [COLUMN...]

Writes FOLDER/run.png: the deformed bodies at time T (by default of the last step),
coloured by von Mises stress, and columns of history.csv over time (by default all contact forces and
reactions that are not zero).
"""
import argparse
import csv
import os
import xml.etree.ElementTree as xml

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import vtk
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from vtk.util.numpy_support import vtk_to_numpy


def files_near(folder, time):
    """Files of the time of solution.pvd that is nearest to a given one."""
    by_time = {}
    for entry in xml.parse(os.path.join(folder, "solution.pvd")).iter("DataSet"):
        at = float(entry.get("timestep"))
        by_time.setdefault(at, []).append(os.path.join(folder, entry.get("file")))
    return by_time[min(by_time, key=lambda t: abs(t - min(time, max(by_time))))]


def surface_of(file):
    """Polygons (points moved by the displacement) and a stress for each."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    warp = vtk.vtkWarpVector()
    reader.GetOutput().GetPointData().SetActiveVectors("displacement")
    warp.SetInputData(reader.GetOutput())
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputConnection(warp.GetOutputPort())
    surface.Update()
    mesh = surface.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    data = mesh.GetPointData().GetArray("von_Mises")
    on_cells = data is None
    if on_cells:
        data = mesh.GetCellData().GetArray("von_Mises")
    stress = vtk_to_numpy(data)
    polygons, values = [], []
    for c in range(mesh.GetNumberOfCells()):
        ids = mesh.GetCell(c).GetPointIds()
        ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        polygons.append(points[ids])
        values.append(stress[c] if on_cells else stress[ids].mean())
    return polygons, values


def cut(polygon, size):
    """Pieces no longer than size: matplotlib hides by the order of centres."""
    edges = np.linalg.norm(polygon - np.roll(polygon, -1, axis=0), axis=1)
    if edges.max() <= size:
        return [polygon]
    middle = 0.5 * (polygon + np.roll(polygon, -1, axis=0))
    centre = polygon.mean(axis=0)
    if len(polygon) == 3:
        pieces = [np.array([polygon[i], middle[i], middle[i - 1]]) for i in range(3)] + [middle]
    else:
        pieces = [
            np.array([polygon[i], middle[i], centre, middle[i - 1]]) for i in range(len(polygon))
        ]
    return [q for piece in pieces for q in cut(piece, size)]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("folder")
    arguments.add_argument("--time", type=float, default=float("inf"))
    arguments.add_argument("columns", nargs="*")
    arguments = arguments.parse_args()
    folder = arguments.folder
    polygons, values = [], []
    for file in files_near(folder, arguments.time):
        p, v = surface_of(file)
        polygons += p
        values += v
    values = np.array(values)
    everything = np.concatenate(polygons)
    plane = np.ptp(everything[:, 2]) == 0.0

    figure = plt.figure(figsize=(13, 5.5))
    scale = plt.Normalize(0.0, np.percentile(values, 99.5))
    colors = plt.cm.viridis(scale(values))
    if plane:
        axis = figure.add_subplot(1, 2, 1)
        axis.add_collection(
            matplotlib.collections.PolyCollection(
                [p[:, :2] for p in polygons],
                facecolors=colors,
                edgecolors="k",
                linewidths=0.1,
            )
        )
        axis.autoscale()
        axis.set_aspect("equal")
        axis.set_xlabel("x")
        axis.set_ylabel("y")
    else:
        axis = figure.add_subplot(1, 2, 1, projection="3d")
        low, high = everything.min(axis=0), everything.max(axis=0)
        size = np.linalg.norm(high - low) / (30 if len(polygons) < 5000 else 3)
        pieces = [cut(np.asarray(polygon), size) for polygon in polygons]
        is_whole = sum(len(of_one) for of_one in pieces) == len(polygons)
        colors = np.repeat(colors, [len(of_one) for of_one in pieces], axis=0)
        axis.add_collection3d(
            Poly3DCollection(
                [piece for of_one in pieces for piece in of_one],
                facecolors=colors,
                edgecolors="k" if is_whole else colors,
                linewidths=0.1,
            )
        )
        axis.set_xlim(low[0], high[0])
        axis.set_ylim(low[1], high[1])
        axis.set_zlim(low[2], high[2])
        axis.set_box_aspect(high - low)
        axis.set_xlabel("x")
        axis.set_ylabel("y")
        axis.set_zlabel("z")
    figure.colorbar(
        plt.cm.ScalarMappable(norm=scale, cmap="viridis"), ax=axis, label="von Mises"
    )

    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    time = [float(row["time"]) for row in rows]
    largest = {
        key: max(abs(float(row[key])) for row in rows)
        for key in rows[0]
        if "force_" in key or key.startswith("reaction:")
    }
    shown = min(time, key=lambda t: abs(t - min(arguments.time, time[-1])))
    figure.suptitle(f"time {shown:g}, displacements as they are", fontsize=10)
    round_off = 1e-9 * max(largest.values(), default=0.0)
    columns = arguments.columns or [key for key in largest if largest[key] > round_off]
    axis = figure.add_subplot(1, 2, 2)
    for column in columns:
        # reactions often lie on the forces that they balance
        style = "--" if column.startswith("reaction:") else ".-"
        axis.plot(time, [float(row[column]) for row in rows], style, label=column)
    axis.set_xlabel("time")
    axis.set_ylabel("force, in the units of the scene")
    if columns:
        axis.legend(fontsize=7, loc="upper center", bbox_to_anchor=(0.5, -0.12), ncol=2)
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "run.png"), dpi=110)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Pictures of a finished run of rubber_fit, from the run's own files.

Usage: scripts/pictures.py FOLDER

Writes into FOLDER: pressure.png (contact pressure on the rubber), section.png
(section cut before and after) and overlap.png (overlap and contact force over
time).
"""
import csv
import glob
import os
import sys
import xml.etree.ElementTree as xml

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import vtk
from mpl_toolkits.mplot3d.art3d import Poly3DCollection
from vtk.util.numpy_support import vtk_to_numpy


def files_of(folder, collection):
    """Files of a collection by time."""
    by_time = {}
    for entry in xml.parse(os.path.join(folder, collection)).iter("DataSet"):
        time = float(entry.get("timestep"))
        by_time.setdefault(time, []).append(os.path.join(folder, entry.get("file")))
    return [by_time[t] for t in sorted(by_time)]


def read(file, factor=1.0):
    """A VTU file, moved by factor times its displacements."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    if grid.GetPointData().HasArray("displacement"):
        grid.GetPointData().SetActiveVectors("displacement")
        warp = vtk.vtkWarpVector()
        warp.SetInputData(grid)
        warp.SetScaleFactor(factor)
        warp.Update()
        grid = warp.GetOutput()
    return grid


def outline_in_section(grid):
    """Line segments of the surface in the half plane y = x, as (r, z)."""
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    plane = vtk.vtkPlane()
    plane.SetNormal(1.0, -1.0, 0.0)
    cutter = vtk.vtkCutter()
    cutter.SetCutFunction(plane)
    cutter.SetInputConnection(surface.GetOutputPort())
    cutter.Update()
    cut = cutter.GetOutput()
    if cut.GetNumberOfPoints() == 0:
        return []
    points = vtk_to_numpy(cut.GetPoints().GetData())
    segments = []
    for c in range(cut.GetNumberOfCells()):
        ids = cut.GetCell(c).GetPointIds()
        line = [points[ids.GetId(k)] for k in range(ids.GetNumberOfIds())]
        segments.append(
            ([(p[0] ** 2 + p[1] ** 2) ** 0.5 for p in line], [p[2] for p in line])
        )
    return segments


def section_picture(folder):
    steps = files_of(folder, "solution.pvd")
    figure, axes = plt.subplots(1, 2, figsize=(9, 5), sharey=True)
    for axis, files, title in (
        (axes[0], steps[0], "initial"),
        (axes[1], steps[-1], "final"),
    ):
        for file in files:
            color = "tab:orange" if "rubber" in os.path.basename(file) else "tab:blue"
            for r, z in outline_in_section(read(file)):
                axis.plot(r, z, color=color, linewidth=1)
        axis.set_title(title)
        axis.set_xlabel("r")
        axis.set_aspect("equal")
    axes[0].set_ylabel("z")
    figure.suptitle("Section: rubber (orange) and seat (blue)")
    figure.savefig(os.path.join(folder, "section.png"), dpi=120)


def overlap_picture(folder):
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        rows = list(csv.DictReader(file))
    time = [float(row["time"]) for row in rows]
    name = next(key for key in rows[0] if key.endswith(":largest_overlap"))
    prefix = name[: -len("largest_overlap")]
    figure, axis = plt.subplots(figsize=(6, 4))
    axis.plot(time, [float(row[name]) for row in rows], "o-")
    axis.set_xlabel("time")
    axis.set_ylabel("largest overlap of the meshes")
    axis.set_ylim(bottom=0)
    right = axis.twinx()
    force = [
        sum(float(row[prefix + "force_" + c]) ** 2 for c in "xyz") ** 0.5
        for row in rows
    ]
    right.plot(time, force, "s--", color="tab:red")
    right.set_ylabel("contact force of the sector", color="tab:red")
    figure.tight_layout()
    figure.savefig(os.path.join(folder, "overlap.png"), dpi=120)


def pressure_picture(folder):
    grid = read(files_of(folder, "contact.pvd")[-1][0])
    # the rubber is the secondary side
    threshold = vtk.vtkThreshold()
    threshold.SetInputData(grid)
    threshold.SetInputArrayToProcess(
        0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "side"
    )
    threshold.SetLowerThreshold(0.5)
    threshold.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_LOWER)
    threshold.Update()
    rubber = threshold.GetOutput()
    points = vtk_to_numpy(rubber.GetPoints().GetData())
    pressure = vtk_to_numpy(rubber.GetPointData().GetArray("pressure"))
    polygons, values = [], []
    for c in range(rubber.GetNumberOfCells()):
        ids = rubber.GetCell(c).GetPointIds()
        ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        polygons.append(points[ids])
        values.append(pressure[ids].mean())

    figure = plt.figure(figsize=(8, 6))
    axis = figure.add_subplot(projection="3d")
    colors = plt.cm.ScalarMappable(cmap="jet")
    colors.set_array(values)
    axis.add_collection3d(
        Poly3DCollection(
            polygons,
            facecolors=colors.to_rgba(values),
            edgecolors="black",
            linewidths=0.3,
        )
    )
    low, high = points.min(axis=0), points.max(axis=0)
    axis.set_xlim(low[0], high[0])
    axis.set_ylim(low[1], high[1])
    axis.set_zlim(low[2], high[2])
    axis.set_box_aspect(high - low)
    axis.view_init(elev=25, azim=40)
    figure.colorbar(colors, ax=axis, label="contact pressure on the rubber")
    figure.savefig(os.path.join(folder, "pressure.png"), dpi=120)


def main():
    if len(sys.argv) != 2 or not glob.glob(os.path.join(sys.argv[1], "*.pvd")):
        sys.exit(__doc__)
    folder = sys.argv[1]
    section_picture(folder)
    overlap_picture(folder)
    pressure_picture(folder)
    print(f"Pictures: {folder}/pressure.png, section.png, overlap.png")


if __name__ == "__main__":
    main()

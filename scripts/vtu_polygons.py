"""Polygons of a run's VTU files, for pictures."""
import os
import xml.etree.ElementTree as xml

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


def files_at(folder, collection, time):
    """Files of the time nearest to the one given, by the name of the part."""
    entries = list(xml.parse(os.path.join(folder, collection)).iter("DataSet"))
    times = {float(e.get("timestep")) for e in entries}
    nearest = min(times, key=lambda t: abs(t - time))
    return nearest, {
        e.get("file"): os.path.join(folder, e.get("file"))
        for e in entries
        if float(e.get("timestep")) == nearest
    }


def polygons_of(file, moved):
    """Corners of all cells, in place, and the vertical displacement of each cell."""
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(file)
    reader.Update()
    surface = vtk.vtkDataSetSurfaceFilter()
    surface.SetInputData(reader.GetOutput())
    surface.Update()
    mesh = surface.GetOutput()
    points = vtk_to_numpy(mesh.GetPoints().GetData()).copy()
    lift = np.zeros(len(points))
    if moved:
        u = vtk_to_numpy(mesh.GetPointData().GetArray("displacement"))
        points += u
        lift = u[:, 2]
    polygons, values, sides = [], [], []
    side = mesh.GetPointData().GetArray("side")
    for c in range(mesh.GetNumberOfCells()):
        ids = mesh.GetCell(c).GetPointIds()
        ids = [ids.GetId(k) for k in range(ids.GetNumberOfIds())]
        polygons.append(points[ids])
        values.append(lift[ids].mean())
        sides.append(side.GetTuple1(ids[0]) if side else 0.0)
    return polygons, np.array(values), np.array(sides)

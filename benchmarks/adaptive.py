#!/usr/bin/python3
"""Error of Hertz's pressure against the number of dofs, uniform and adaptive.

Usage: benchmarks/adaptive.py [--output DIR] [--ranks N] [--set "Section/Entry=value"]...

The steel cylinder on the aluminium block of prm/verification/roller.prm (NAFEMS
CGS-1; Hertz: half width a = 6.21463 mm, p0 = 3585.36 MPa), from a mesh without local
refinement: all cells halved n times, or the step done again n times on meshes that
follow the error indicators. Writes DIR/table.md and DIR/error.png; the error is
  int |p - p_Hertz| dx / int p_Hertz dx
of the pressures at the vertices of the block's contact facets, linear between them.
"""
import os
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from run_driver import ROOT, parser, run

sys.path.insert(0, os.path.join(ROOT, "scripts"))
from vtu_polygons import files_at

import vtk
from vtk.util.numpy_support import vtk_to_numpy

A, P0 = 6.21463, 3585.36
FILE = os.path.join(ROOT, "prm/verification/roller.prm")
COARSE = [
    "Bodies/block/Mesh/Cells=8, 16",
    "Bodies/block/Mesh/Local refinements=0",
    "Bodies/roller/Mesh/Cells=6, 6",
    "Bodies/roller/Mesh/Local refinements=0",
    "Steps/First step=1",
    # that of the cells would change the contact stiffness from facet to facet
    "Contact/contact/Characteristic length=1",
]


def pressures(folder):
    """Undeformed x (the block moves little) and pressure along the block, sorted."""
    _, files = files_at(folder, "contact.pvd", 1.0)
    (name,) = files.values()
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(name)
    reader.Update()
    mesh = reader.GetOutput()
    side = vtk_to_numpy(mesh.GetPointData().GetArray("side"))
    x = vtk_to_numpy(mesh.GetPoints().GetData())[side == 0, 0]
    p = vtk_to_numpy(mesh.GetPointData().GetArray("pressure"))[side == 0]
    order = np.lexsort((p, x))
    return x[order], p[order]


def error(folder):
    """Of the text above."""
    x, p = pressures(folder)
    fine = np.linspace(0.0, 2.0 * A, 20001)
    exact = P0 * np.sqrt(np.maximum(0.0, 1.0 - (fine / A) ** 2))
    return np.abs(np.interp(fine, x, p) - exact).sum() / exact.sum()


def main():
    options = parser(__doc__, "adaptive")
    options.add_argument("--uniform", type=int, default=5, help="uniform refinements")
    options.add_argument("--cycles", type=int, default=10, help="adaptive refinements")
    arguments = options.parse_args()
    arguments.ranks = 1 if "--ranks" not in sys.argv else arguments.ranks
    os.makedirs(arguments.output, exist_ok=True)
    rows = {"uniform": [], "adaptive": []}
    for n in range(arguments.uniform + 1):
        settings = COARSE + [f"Bodies/{b}/Mesh/Refinements={n}" for b in ("block", "roller")]
        summary, folder = run("contact_scene", FILE, f"uniform {n}", settings, arguments)
        rows["uniform"].append((summary, error(folder)))
    for n in range(0, arguments.cycles + 1, 2):
        settings = COARSE + ["Refinement/Most levels=12"]
        if n > 0:
            settings += ["Refinement/Every=1", f"Refinement/Cycles={n}"]
        summary, folder = run("contact_scene", FILE, f"adaptive {n}", settings, arguments)
        rows["adaptive"].append((summary, error(folder)))

    lines = ["| meshes | dofs | error % | largest pressure / p0 | iterations | seconds |",
             "|" + "---|" * 6]
    figure, axis = plt.subplots(figsize=(6, 4.5))
    for name, results in rows.items():
        for summary, e in results:
            p = summary["interfaces"]["contact"]["largest_pressure"]
            lines.append(f"| {name} | {summary['dofs']} | {100 * e:.3f} | {p / P0:.4f} "
                         f"| {summary['newton_iterations']} | {summary['wall_seconds']:.2f} |")
        axis.loglog([s["dofs"] for s, _ in results], [100 * e for _, e in results], "o-",
                    label=name)
    axis.set_xlabel("dofs")
    axis.set_ylabel("error of the pressure [%]")
    axis.grid(which="both", alpha=0.3)
    axis.legend()
    figure.tight_layout()
    figure.savefig(os.path.join(arguments.output, "error.png"), dpi=120)
    with open(os.path.join(arguments.output, "table.md"), "w") as file:
        file.write("\n".join(lines) + "\n")
    print("\n".join(lines))


if __name__ == "__main__":
    main()

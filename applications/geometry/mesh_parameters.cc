// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_parameters.h"

#include "../structure/numbers_of.h"

#include <deal.II/base/patterns.h>

namespace Structure
{
  void
  MeshParameters::declare(ParameterHandler &prm)
  {
    const Patterns::List doubles(Patterns::Double(), 0, 3);
    prm.declare_entry(
      "Type",
      "box",
      Patterns::Selection("box|revolution|ball|ball sector|cylinder|file"),
      "box: Lower and Upper corner, Cells; boundary ids 0 1 at low and high x, 2 "
      "3 at y, 4 5 at z. revolution: ring around z from Inner to Outer radius, z "
      "from 0 to Length, Cells around, across and along; ids 0 1 at Last and "
      "First angle (none if closed), 2 inside, 3 outside, 4 5 at the ends. ball: "
      "Radius, id 0. ball sector: the part with x, y(, z) > 0; id 0 outside, 1 "
      "on the planes. cylinder: Radius, from -Length/2 to Length/2 along z; ids "
      "0 outside, 1 2 at the ends. file: gmsh .msh, Abaqus .inp, .vtk.");
    prm.declare_entry("File", "", Patterns::Anything(), "Mesh file.");
    prm.declare_entry("Scale",
                      "1.0",
                      Patterns::Double(1e-300),
                      "Factor on the coordinates of a file [-].");
    prm.declare_entry("Lower corner",
                      "0, 0, 0",
                      doubles,
                      "Of the box [length].");
    prm.declare_entry("Upper corner",
                      "1, 1, 1",
                      doubles,
                      "Of the box [length].");
    prm.declare_entry("Cells",
                      "1, 1, 1",
                      Patterns::List(Patterns::Integer(0), 1, 3),
                      "Cells per direction [-].");
    prm.declare_entry("Inner radius",
                      "1.0",
                      Patterns::Anything(),
                      "Of the ring: number or formula in z, phi [length].");
    prm.declare_entry("Outer radius",
                      "2.0",
                      Patterns::Anything(),
                      "Of the ring: number or formula in z, phi [length].");
    prm.declare_entry("First angle", "0.0", Patterns::Double(), "[degree]");
    prm.declare_entry("Last angle", "360.0", Patterns::Double(), "[degree]");
    prm.declare_entry("Radius",
                      "1.0",
                      Patterns::Double(1e-300),
                      "Of ball and cylinder [length].");
    prm.declare_entry("Length",
                      "1.0",
                      Patterns::Double(1e-300),
                      "Of ring and cylinder [length].");
    prm.declare_entry("Refinements",
                      "0",
                      Patterns::Integer(0, 10),
                      "Times that all cells are split in halves [-].");
    prm.declare_entry("Refine near",
                      "",
                      doubles,
                      "Point around which cells are split further; the radius "
                      "halves each time [length].");
    prm.declare_entry("Refine radius",
                      "0.0",
                      Patterns::Double(0.),
                      "Distance from the point for the first split [length].");
    prm.declare_entry("Local refinements",
                      "0",
                      Patterns::Integer(0, 12),
                      "Times that cells near the point are split [-].");
    prm.declare_entry("Simplices",
                      "false",
                      Patterns::Bool(),
                      "Split the cells into tetrahedra (triangles).");
    prm.declare_entry(
      "Distortion",
      "0.0",
      Patterns::Double(0., 0.4),
      "Random motion of inner vertices, for boxes also of those "
      "on faces along the faces, over the cell size [-].");
    prm.declare_entry("Map",
                      "",
                      Patterns::Anything(),
                      "Where each vertex goes: formulas in x, y, z, one per "
                      "coordinate, separated by semicolons; after refinement, "
                      "before rotation. Edges become straight.");
    prm.declare_entry("Rotation axis",
                      "0, 0, 1",
                      doubles,
                      "Axis through the origin (3d) [-].");
    prm.declare_entry("Rotation angle",
                      "0.0",
                      Patterns::Double(),
                      "About the axis (3d), the origin (2d) [degree].");
    prm.declare_entry("Merge vertices",
                      "false",
                      Patterns::Bool(),
                      "Of a shell: vertices at one place after Map are one, "
                      "which closes rings and joins sheets.");
    prm.declare_entry(
      "Boundary id formula",
      "",
      Patterns::Anything(),
      "In x, y, z, at the middle of each face of the boundary, in its place: "
      "the id it gets; negative: keeps its own. For example "
      "if(x < 10, 7, -1). Empty: none change.");
    prm.declare_entry("Move", "", doubles, "Shift after rotation [length].");
  }


  void
  MeshParameters::read(ParameterHandler &prm)
  {
    type  = prm.get("Type");
    file  = prm.get("File");
    scale = prm.get_double("Scale");
    lower = numbers_of(prm.get("Lower corner"));
    upper = numbers_of(prm.get("Upper corner"));
    cells.clear();
    for (const double n : numbers_of(prm.get("Cells")))
      cells.push_back(static_cast<unsigned int>(n));
    inner_radius      = prm.get("Inner radius");
    outer_radius      = prm.get("Outer radius");
    first_angle       = prm.get_double("First angle");
    last_angle        = prm.get_double("Last angle");
    radius            = prm.get_double("Radius");
    length            = prm.get_double("Length");
    refinements       = prm.get_integer("Refinements");
    refine_near       = numbers_of(prm.get("Refine near"));
    refine_radius     = prm.get_double("Refine radius");
    local_refinements = prm.get_integer("Local refinements");
    simplices         = prm.get_bool("Simplices");
    distortion        = prm.get_double("Distortion");
    rotation_axis     = numbers_of(prm.get("Rotation axis"));
    map               = prm.get("Map");
    boundary_ids      = prm.get("Boundary id formula");
    merges            = prm.get_bool("Merge vertices");
    rotation_angle    = prm.get_double("Rotation angle");
    move              = numbers_of(prm.get("Move"));
    AssertThrow(type != "file" || !file.empty(),
                ExcMessage("'Mesh/Type' is 'file' but 'Mesh/File' is empty; "
                           "expected the name of a mesh file."));
    AssertThrow(!simplices || local_refinements == 0,
                ExcMessage("'Mesh/Simplices' and 'Mesh/Local refinements' are "
                           "both set; tetrahedra cannot be refined locally. "
                           "Remove one of them."));
  }
} // namespace Structure

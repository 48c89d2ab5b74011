// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_parameters.h"

#include "../structure/expression.h"
#include "structured_mesh.h"

#include <deal.II/base/function_parser.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <cmath>
#include <fstream>
#include <random>

namespace Structure
{
  namespace
  {
    std::vector<double>
    numbers_of(const std::string &list)
    {
      return Utilities::string_to_double(Utilities::split_string_list(list));
    }

    /// A point from a list of numbers, with an error that names the entry.
    template <int dim>
    Point<dim>
    point_of(const std::vector<double> &list, const std::string &entry)
    {
      AssertThrow(list.size() == dim,
                  ExcMessage(
                    "'Mesh/" + entry + "' has " + std::to_string(list.size()) +
                    " numbers; expected " + std::to_string(dim) + "."));
      Point<dim> p;
      for (unsigned int i = 0; i < dim; ++i)
        p[i] = list[i];
      return p;
    }

    template <int dim>
    std::array<unsigned int, dim>
    cells_of(const MeshParameters &m)
    {
      AssertThrow(m.cells.size() == dim,
                  ExcMessage("'Mesh/Cells' has " +
                             std::to_string(m.cells.size()) +
                             " numbers; expected " + std::to_string(dim) +
                             ", one per direction."));
      std::array<unsigned int, dim> n;
      for (unsigned int i = 0; i < dim; ++i)
        {
          AssertThrow(m.cells[i] > 0,
                      ExcMessage("'Mesh/Cells' has a 0; expected positive "
                                 "numbers of cells."));
          n[i] = m.cells[i];
        }
      return n;
    }

    /// A formula of z (3d) and phi in radians, as a function.
    class RadiusFormula
    {
    public:
      RadiusFormula(const std::string &text, const std::string &entry)
        : function(1)
        , entry(entry)
      {
        try
          {
            function.initialize("z,phi", text, {{"pi", numbers::PI}});
            (void)function.value(Point<2>());
          }
        catch (const std::exception &)
          {
            AssertThrow(false,
                        ExcMessage(
                          "'Mesh/" + entry + "' is '" + text +
                          "'; expected a number or a formula in z, phi "
                          "and pi."));
          }
      }

      double
      operator()(const double z, const double phi) const
      {
        return function.value(Point<2>(z, phi));
      }

    private:
      FunctionParser<2> function;
      std::string       entry;
    };

    /// Ring around the z axis: first direction the angle, then from the inner
    /// to the outer radius, then z from 0 to the length.
    template <int dim>
    void
    make_revolution(const MeshParameters &m, Triangulation<dim> &mesh)
    {
      AssertThrow(m.last_angle > m.first_angle &&
                    m.last_angle - m.first_angle <= 360. + 1e-9,
                  ExcMessage("'Mesh/First angle' and 'Mesh/Last angle' span " +
                             std::to_string(m.last_angle - m.first_angle) +
                             " degrees; expected more than 0, at most 360."));
      const bool closed = m.last_angle - m.first_angle > 360. - 1e-9;
      AssertThrow(!closed || cells_of<dim>(m)[0] >= 3,
                  ExcMessage("'Mesh/Cells' has fewer than 3 cells around a "
                             "closed ring; expected at least 3."));
      const RadiusFormula inner(m.inner_radius, "Inner radius");
      const RadiusFormula outer(m.outer_radius, "Outer radius");
      make_structured_mesh<dim>(
        cells_of<dim>(m),
        closed,
        [&](const Point<dim> &s) {
          // angles run backwards so that (angle, radius, z) is right-handed
          const double phi =
            numbers::PI / 180. *
            (m.last_angle + s[0] * (m.first_angle - m.last_angle));
          const double z = (dim == 3) ? s[dim - 1] * m.length : 0.;
          const double a = inner(z, phi), b = outer(z, phi);
          AssertThrow(b > a && a > 0.,
                      ExcMessage("'Mesh/Inner radius' is " + std::to_string(a) +
                                 " and 'Mesh/Outer radius' is " +
                                 std::to_string(b) +
                                 " at z = " + std::to_string(z) +
                                 "; expected 0 < inner < outer."));
          const double r = a + s[1] * (b - a);
          Point<dim>   p;
          p[0] = r * std::cos(phi);
          p[1] = r * std::sin(phi);
          if constexpr (dim == 3)
            p[2] = z;
          return p;
        },
        mesh);
      // new vertices of refined cells go on circles around the axis
      if constexpr (dim == 2)
        mesh.set_manifold(1, PolarManifold<2>());
      else
        mesh.set_manifold(1, CylindricalManifold<3>(2));
      mesh.set_all_manifold_ids(1);
    }

    template <int dim>
    void
    read_file(const MeshParameters &m, Triangulation<dim> &mesh)
    {
      std::ifstream in(m.file);
      AssertThrow(in,
                  ExcMessage("'Mesh/File' is '" + m.file +
                             "'; this file cannot be opened."));
      const std::string ending = m.file.substr(m.file.find_last_of('.') + 1);
      GridIn<dim>       reader;
      reader.attach_triangulation(mesh);
      try
        {
          if (ending == "msh")
            reader.read_msh(in);
          else if (ending == "inp")
            reader.read_abaqus(in);
          else if (ending == "vtk")
            reader.read_vtk(in);
          else
            AssertThrow(false, ExcMessage("unknown ending"));
        }
      catch (const std::exception &e)
        {
          AssertThrow(false,
                      ExcMessage(
                        "'Mesh/File' is '" + m.file +
                        "'; expected a readable mesh of dimension " +
                        std::to_string(dim) +
                        ": gmsh (.msh, ASCII 2 or 4), Abaqus (.inp) or "
                        "VTK (.vtk)."));
        }
    }
  } // namespace


  namespace
  {
    template <int dim>
    void
    map_mesh(const MeshParameters &m, Triangulation<dim> &mesh)
    {
      const std::vector<std::string> components =
        Utilities::split_string_list(m.map, ';');
      AssertThrow(components.size() == dim,
                  ExcMessage("'Mesh/Map' has " +
                             std::to_string(components.size()) +
                             " components; expected " + std::to_string(dim) +
                             ", separated by semicolons."));
      std::vector<Expression<dim>> formulas;
      for (const std::string &c : components)
        formulas.emplace_back(c, "Mesh/Map");
      mesh.reset_all_manifolds();
      GridTools::transform(
        [&](const Point<dim> &x) {
          Point<dim> y;
          for (unsigned int i = 0; i < dim; ++i)
            y[i] = formulas[i].value(x, 0.);
          return y;
        },
        mesh);
      // triangulations do not look at the sign themselves
      for (const auto &cell : mesh.active_cell_iterators())
        AssertThrow(cell->measure() > 0.,
                    ExcMessage("'Mesh/Map' turns a cell inside out."));
    }
  } // namespace


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


  template <int dim>
  void
  make_mesh(const MeshParameters &m, Triangulation<dim> &mesh)
  {
    // Step 1: the primitive.
    if (m.type == "box")
      {
        const Point<dim> low  = point_of<dim>(m.lower, "Lower corner");
        const Point<dim> high = point_of<dim>(m.upper, "Upper corner");
        for (unsigned int i = 0; i < dim; ++i)
          AssertThrow(high[i] > low[i],
                      ExcMessage(
                        "'Mesh/Upper corner' is not beyond 'Mesh/Lower "
                        "corner' in direction " +
                        std::string(1, "xyz"[i]) + "."));
        const std::array<unsigned int, dim> n = cells_of<dim>(m);
        std::mt19937                        random(1);
        make_structured_mesh<dim>(
          n,
          false,
          [&](const Point<dim> &s) {
            Point<dim> p;
            for (unsigned int i = 0; i < dim; ++i)
              {
                // vertices on faces, edges, corners stay there
                const bool   stays = s[i] == 0. || s[i] == 1.;
                const double share = random() / double(random.max()) - 0.5;
                const double moved =
                  s[i] + (stays ? 0. : 2. * m.distortion * share / n[i]);
                p[i] = low[i] + moved * (high[i] - low[i]);
              }
            return p;
          },
          mesh);
      }
    else if (m.type == "revolution")
      make_revolution(m, mesh);
    else if (m.type == "ball")
      GridGenerator::hyper_ball(mesh, Point<dim>(), m.radius);
    else if (m.type == "ball sector")
      GridGenerator::quarter_hyper_ball(mesh, Point<dim>(), m.radius);
    else if (m.type == "cylinder")
      {
        AssertThrow(dim == 3,
                    ExcMessage(
                      "'Mesh/Type' is 'cylinder' but 'Dimension' is 2; "
                      "a disc is a 'ball' there."));
        if constexpr (dim == 3)
          {
            GridGenerator::cylinder(mesh, m.radius, 0.5 * m.length);
            // deal.II's axis is x
            mesh.reset_all_manifolds();
            GridTools::rotate(Point<3>::unit_vector(1),
                              -0.5 * numbers::PI,
                              mesh);
            mesh.set_manifold(0, CylindricalManifold<3>(2));
            mesh.set_all_manifold_ids_on_boundary(0, 0);
          }
      }
    else
      {
        read_file(m, mesh);
        GridTools::scale(m.scale, mesh);
      }

    // Step 2: finer.
    if (m.refinements > 0)
      mesh.refine_global(m.refinements);
    if (m.local_refinements > 0)
      {
        const Point<dim> centre = point_of<dim>(m.refine_near, "Refine near");
        double           r      = m.refine_radius;
        for (unsigned int i = 0; i < m.local_refinements; ++i, r *= 0.5)
          {
            for (const auto &cell : mesh.active_cell_iterators())
              for (const unsigned int v : cell->vertex_indices())
                if (cell->vertex(v).distance(centre) < r)
                  cell->set_refine_flag();
            mesh.execute_coarsening_and_refinement();
          }
      }
    if (m.simplices)
      {
        Triangulation<dim> cubes, flat;
        cubes.copy_triangulation(mesh);
        mesh.clear();
        GridGenerator::flatten_triangulation(cubes, flat);
        GridGenerator::convert_hypercube_to_simplex_mesh(flat, mesh);
      }
    if (m.distortion > 0. && m.type != "box")
      GridTools::distort_random(m.distortion, mesh, true);

    if (!m.map.empty())
      map_mesh(m, mesh);

    // Step 4: in its place, manifolds too: elements of degree 2 get their
    // middle nodes from them.
    if (m.rotation_angle == 0. && m.move.empty())
      return;
    mesh.reset_all_manifolds();
    const double angle = numbers::PI / 180. * m.rotation_angle;
    Point<dim>   origin;
    if (!m.move.empty())
      origin = point_of<dim>(m.move, "Move");
    Tensor<1, dim> z;
    if constexpr (dim == 2)
      GridTools::rotate(angle, mesh);
    else
      {
        const Point<dim> given =
          point_of<dim>(m.rotation_axis, "Rotation axis");
        AssertThrow(given.norm() > 0.,
                    ExcMessage("'Mesh/Rotation axis' is 0, 0, 0; expected a "
                               "direction."));
        const Tensor<1, 3> axis = given / given.norm();
        if (angle != 0.)
          GridTools::rotate(axis, angle, mesh);
        // the axis of rings and cylinders, turned (Rodrigues)
        z[2] = 1.;
        z = std::cos(angle) * z + std::sin(angle) * cross_product_3d(axis, z) +
            (1. - std::cos(angle)) * (axis * z) * axis;
      }
    GridTools::shift(Tensor<1, dim>(origin), mesh);
    if (m.type == "ball" || m.type == "ball sector")
      mesh.set_manifold(0, SphericalManifold<dim>(origin));
    if constexpr (dim == 2)
      {
        if (m.type == "revolution")
          mesh.set_manifold(1, PolarManifold<2>(origin));
      }
    else
      {
        if (m.type == "revolution")
          mesh.set_manifold(1, CylindricalManifold<3>(z, origin));
        if (m.type == "cylinder")
          mesh.set_manifold(0, CylindricalManifold<3>(z, origin));
      }
  }



  template void
  make_mesh(const MeshParameters &, Triangulation<2> &);
  template void
  make_mesh(const MeshParameters &, Triangulation<3> &);
} // namespace Structure

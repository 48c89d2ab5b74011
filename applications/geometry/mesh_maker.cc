// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_maker.h"

#include "../structure/expression.h"
#include "abaqus_solid.h"
#include "gmsh_check.h"
#include "map_manifold.h"
#include "structured_mesh.h"

#include <mortar_contact/host/cell_volume.h>

#include <deal.II/base/function_parser.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_in.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <deal.II/physics/transformations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <random>

namespace Structure
{
  namespace
  {
    /// The boundary of meshes with a 'Map'.
    constexpr types::manifold_id map_manifold = 2;

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

    template <int dim, int spacedim>
    MeshParts
    read_file(const MeshParameters &m, Triangulation<dim, spacedim> &mesh)
    {
      std::ifstream in(m.file);
      AssertThrow(in,
                  ExcMessage("'Mesh/File' is '" + m.file +
                             "'; this file cannot be opened."));
      const std::string ending = m.file.substr(m.file.find_last_of('.') + 1);
      if (ending == "msh")
        check_gmsh(m.file);
      if constexpr (dim == spacedim)
        if (ending == "inp")
          return read_abaqus_solid(m.file, mesh);
      AssertThrow(ending != "k" && ending != "key" && ending != "dyn",
                  ExcMessage("'Mesh/File' is '" + m.file +
                             "': keyword files of LS-DYNA are not read; "
                             "expected the mesh as gmsh (.msh), Abaqus (.inp) "
                             "or VTK (.vtk) file."));
      GridIn<dim, spacedim> reader;
      reader.attach_triangulation(mesh);
      try
        {
          if (ending == "msh")
            reader.read_msh(in);
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
      return ending == "msh" ? gmsh_parts(m.file, dim) : MeshParts();
    }

    /// 'Map' as a function.
    template <int dim>
    std::function<Point<dim>(const Point<dim> &)>
    map_of(const MeshParameters &m)
    {
      const std::vector<std::string> components =
        Utilities::split_string_list(m.map, ';');
      AssertThrow(components.size() == dim,
                  ExcMessage("'Mesh/Map' has " +
                             std::to_string(components.size()) +
                             " components; expected " + std::to_string(dim) +
                             ", separated by semicolons."));
      auto formulas = std::make_shared<std::vector<Expression<dim>>>();
      for (const std::string &c : components)
        formulas->emplace_back(c, "Mesh/Map");
      return [formulas](const Point<dim> &x) {
        Point<dim> y;
        for (unsigned int i = 0; i < dim; ++i)
          y[i] = (*formulas)[i].value(x, 0.);
        return y;
      };
    }

    /// 'Rotation angle' and 'Move' as a function.
    template <int dim>
    std::function<Point<dim>(const Point<dim> &)>
    placement_of(const MeshParameters &m)
    {
      const double   angle = numbers::PI / 180. * m.rotation_angle;
      Tensor<1, dim> move;
      if (!m.move.empty())
        move = point_of<dim>(m.move, "Move");
      Tensor<2, dim> turn = unit_symmetric_tensor<dim>();
      if constexpr (dim == 2)
        turn = Physics::Transformations::Rotations::rotation_matrix_2d(angle);
      else if (angle != 0.)
        {
          const Point<3> axis = point_of<dim>(m.rotation_axis, "Rotation axis");
          AssertThrow(axis.norm() > 0.,
                      ExcMessage("'Mesh/Rotation axis' is 0, 0, 0; expected a "
                                 "direction."));
          turn = Physics::Transformations::Rotations::rotation_matrix_3d(
            axis / axis.norm(), angle);
        }
      return [turn, move](const Point<dim> &x) {
        return Point<dim>(turn * Tensor<1, dim>(x) + move);
      };
    }

    /// Map the mesh and put it in its place; points that refinement adds on its
    /// boundary, and the middle nodes of elements there, are mapped, too.
    template <int dim>
    void
    map_into_place(const MeshParameters &m, Triangulation<dim> &mesh)
    {
      const auto map = map_of<dim>(m), placement = placement_of<dim>(m);
      const auto whole = [map, placement](const Point<dim> &x) {
        return placement(map(x));
      };
      const std::vector<Point<dim>> before = mesh.get_vertices();
      mesh.reset_all_manifolds();
      GridTools::transform(whole, mesh);
      // triangulations do not look at the sign themselves
      for (const auto &cell : mesh.active_cell_iterators())
        AssertThrow(MortarContact::cell_volume(cell) > 0.,
                    ExcMessage("'Mesh/Map' turns a cell inside out."));
      MapManifold<dim> manifold(whole);
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            for (const unsigned int v : face->vertex_indices())
              manifold.add(face->vertex(v), before[face->vertex_index(v)]);
      mesh.set_manifold(map_manifold, manifold);
      mesh.set_all_manifold_ids_on_boundary(map_manifold);
    }

    template <int dim, int spacedim>
    void
    refine_locally(const MeshParameters &m, Triangulation<dim, spacedim> &mesh)
    {
      if (m.local_refinements == 0)
        return;
      const Point<spacedim> centre =
        point_of<spacedim>(m.refine_near, "Refine near");
      double r = m.refine_radius;
      for (unsigned int i = 0; i < m.local_refinements; ++i, r *= 0.5)
        {
          for (const auto &cell : mesh.active_cell_iterators())
            for (const unsigned int v : cell->vertex_indices())
              if (cell->vertex(v).distance(centre) < r)
                cell->set_refine_flag();
          mesh.execute_coarsening_and_refinement();
        }
    }

    /// The mesh with its own boundary ids, refined, turned and moved.
    template <int dim>
    MeshParts
    make_in_place(const MeshParameters &m, Triangulation<dim> &mesh)
    {
      MeshParts parts;
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
          parts = read_file(m, mesh);
          GridTools::scale(m.scale, mesh);
        }

      // Step 2: finer.
      if (m.refinements > 0)
        mesh.refine_global(m.refinements);
      refine_locally(m, mesh);
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
        {
          map_into_place(m, mesh);
          return parts;
        }

      // Step 4: in its place, manifolds too: elements of degree 2 get their
      // middle nodes from them.
      if (m.rotation_angle == 0. && m.move.empty())
        return parts;
      mesh.reset_all_manifolds();
      const auto place = placement_of<dim>(m);
      GridTools::transform(place, mesh);
      const Point<dim> origin = place(Point<dim>());
      if (m.type == "ball" || m.type == "ball sector")
        mesh.set_manifold(0, SphericalManifold<dim>(origin));
      if constexpr (dim == 2)
        {
          if (m.type == "revolution")
            mesh.set_manifold(1, PolarManifold<2>(origin));
        }
      else
        {
          // the axis of rings and cylinders, turned
          const Tensor<1, dim> z =
            place(Point<dim>::unit_vector(dim - 1)) - origin;
          if (m.type == "revolution")
            mesh.set_manifold(1, CylindricalManifold<3>(z, origin));
          if (m.type == "cylinder")
            mesh.set_manifold(0, CylindricalManifold<3>(z, origin));
        }
      return parts;
    }

    /// Boundary ids by place, after everything else.
    template <int dim, int spacedim>
    void
    set_boundary_ids(const MeshParameters         &m,
                     Triangulation<dim, spacedim> &mesh)
    {
      Expression<spacedim> formula(m.boundary_ids, "Mesh/Boundary id formula");
      bool                 any = false;
      for (const auto &cell : mesh.active_cell_iterators())
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              const double id = formula.value(face->center(), 0.);
              AssertThrow(id == std::floor(id) && id < 4294967295.,
                          ExcMessage("'Mesh/Boundary id formula' gives " +
                                     std::to_string(id) +
                                     "; expected whole numbers."));
              if (id >= 0.)
                face->set_boundary_id(static_cast<types::boundary_id>(id));
              any = any || id >= 0.;
            }
      AssertThrow(any,
                  ExcMessage("'Mesh/Boundary id formula' is '" +
                             m.boundary_ids +
                             "'; it is negative on all faces of the "
                             "boundary, so that it changes none."));
    }
  } // namespace


  template <int dim>
  MeshParts
  make_mesh(const MeshParameters &m, Triangulation<dim> &mesh)
  {
    if constexpr (dim == 3)
      if (m.make_solid)
        {
          m.make_solid(mesh);
          return {};
        }
    const MeshParts parts = make_in_place(m, mesh);
    if (!m.boundary_ids.empty())
      set_boundary_ids(m, mesh);
    return parts;
  }



  MeshParts
  make_shell_mesh(const MeshParameters &m, Triangulation<2, 3> &mesh)
  {
    MeshParts parts;
    if (m.make_shell)
      {
        m.make_shell(mesh);
        return parts;
      }
    AssertThrow(m.type == "box" || m.type == "file",
                ExcMessage("'Mesh/Type' is '" + m.type +
                           "'; expected box (with Map) or file for a shell."));
    AssertThrow(m.type == "box" || (m.map.empty() && !m.simplices &&
                                    m.distortion == 0. && !m.merges),
                ExcMessage(
                  "'Mesh/Type' is 'file': 'Map', 'Simplices', "
                  "'Distortion' and 'Merge vertices' do not act on the "
                  "file of a shell; remove them."));
    if (m.type == "file")
      {
        const std::string ending = m.file.substr(m.file.find_last_of('.') + 1);
        if (ending == "inp")
          parts = read_abaqus_shell(m.file, mesh);
        else
          read_file(m, mesh);
        if (ending == "msh")
          parts = gmsh_parts(m.file, 2);
        GridTools::scale(m.scale, mesh);
        for (auto &thickness : parts.thickness)
          thickness.second *= m.scale;
        if (m.refinements > 0)
          mesh.refine_global(m.refinements);
      }
    else
      {
        // Step 1: the plane mesh, and where its vertices go.
        MeshParameters plane = m;
        plane.map.clear();
        plane.move.clear();
        plane.boundary_ids.clear();
        plane.local_refinements = 0;
        plane.rotation_angle    = 0.;
        Triangulation<2> flat;
        make_mesh(plane, flat);
        std::vector<std::string> components =
          Utilities::split_string_list(m.map.empty() ? "x; y; 0" : m.map, ';');
        AssertThrow(components.size() == 3,
                    ExcMessage("'Mesh/Map' has " +
                               std::to_string(components.size()) +
                               " components; expected 3, formulas in x and y, "
                               "separated by semicolons."));
        std::vector<Expression<2>> formulas;
        for (const std::string &c : components)
          formulas.emplace_back(c, "Mesh/Map");
        std::vector<Point<3>> vertices;
        for (const Point<2> &x : flat.get_vertices())
          vertices.emplace_back(formulas[0].value(x, 0.),
                                formulas[1].value(x, 0.),
                                formulas[2].value(x, 0.));
        std::vector<CellData<2>> cells;
        SubCellData              edges;
        for (const auto &cell : flat.active_cell_iterators())
          {
            CellData<2> data(cell->n_vertices());
            for (const unsigned int v : cell->vertex_indices())
              data.vertices[v] = cell->vertex_index(v);
            cells.push_back(data);
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                {
                  CellData<1> edge;
                  edge.vertices    = {face->vertex_index(0),
                                      face->vertex_index(1)};
                  edge.boundary_id = face->boundary_id();
                  edges.boundary_lines.push_back(edge);
                }
          }

        // Step 2: closed, if wanted: edges that meet are not on the boundary.
        if (m.merges)
          {
            double size = 0.;
            for (const Point<3> &x : vertices)
              size = std::max(size, x.distance(vertices[0]));
            std::vector<unsigned int> considered;
            GridTools::delete_duplicated_vertices(
              vertices, cells, edges, considered, 1e-9 * size);
            std::map<std::pair<unsigned int, unsigned int>, unsigned int> count;
            const auto key = [](const unsigned int a, const unsigned int b) {
              return std::make_pair(std::min(a, b), std::max(a, b));
            };
            for (const CellData<2> &cell : cells)
              {
                std::vector<unsigned int> v = cell.vertices;
                if (v.size() == 4)
                  std::swap(v[2], v[3]);
                for (unsigned int k = 0; k < v.size(); ++k)
                  ++count[key(v[k], v[(k + 1) % v.size()])];
              }
            auto &lines = edges.boundary_lines;
            lines.erase(std::remove_if(lines.begin(),
                                       lines.end(),
                                       [&](const CellData<1> &line) {
                                         return count[key(line.vertices[0],
                                                          line.vertices[1])] >
                                                1;
                                       }),
                        lines.end());
          }
        mesh.create_triangulation(vertices, cells, edges);
      }

    // cells near a point of space; new vertices lie on straight edges
    AssertThrow(m.local_refinements == 0 ||
                  mesh.all_reference_cells_are_hyper_cube(),
                ExcMessage("'Mesh/Local refinements' is " +
                           std::to_string(m.local_refinements) +
                           "; expected 0 for a shell with triangles."));
    refine_locally(m, mesh);

    // Step 3: in its place.
    if (m.rotation_angle != 0.)
      {
        const Tensor<1, 3> axis = point_of<3>(m.rotation_axis, "Rotation axis");
        AssertThrow(axis.norm() > 0.,
                    ExcMessage("'Mesh/Rotation axis' is 0, 0, 0; expected a "
                               "direction."));
        GridTools::rotate(axis / axis.norm(),
                          numbers::PI / 180. * m.rotation_angle,
                          mesh);
      }
    if (!m.move.empty())
      GridTools::shift(Tensor<1, 3>(point_of<3>(m.move, "Move")), mesh);
    if (!m.boundary_ids.empty())
      set_boundary_ids(m, mesh);
    return parts;
  }


  template MeshParts
  make_mesh(const MeshParameters &, Triangulation<2> &);
  template MeshParts
  make_mesh(const MeshParameters &, Triangulation<3> &);
} // namespace Structure

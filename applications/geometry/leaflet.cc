// SPDX-License-Identifier: LGPL-2.1-or-later
#include "leaflet.h"

#include "../structure/numbers_of.h"

#include <deal.II/base/patterns.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <algorithm>
#include <cmath>

namespace Structure
{
  namespace
  {
    /// Half the angle of a leaflet's third of the tube.
    constexpr double half_angle = numbers::PI / 3.;

    Point<3>
    turned(const Point<3> &x, const double angle)
    {
      const double c = std::cos(angle), s = std::sin(angle);
      return {c * x[0] - s * x[1], s * x[0] + c * x[1], x[2]};
    }
  } // namespace


  void
  Leaflet::declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300), not_negative(0.);
    prm.declare_entry("Radius", "1.1", positive, "Of the tube [length].");
    prm.declare_entry("Commissure height",
                      "0.75",
                      positive,
                      "Above the lowest place of the attachment [length].");
    prm.declare_entry("Dip",
                      "0.08",
                      Patterns::Double(),
                      "Of the free edge's middle below the commissures "
                      "[length].");
    prm.declare_entry("Centre rounding",
                      "0.05",
                      positive,
                      "Of the free edge near the axis [length].");
    prm.declare_entry("Gap",
                      "0.55",
                      Patterns::Double(0.5),
                      "Between the middle surface's free edge and the planes "
                      "where neighbours meet, over the thickness; less than "
                      "half would be an overlap [-].");
    prm.declare_entry("Belly",
                      "0",
                      Patterns::Double(),
                      "Largest bulge towards the ventricle [length].");
    prm.declare_entry("Thickness", "0.0386", positive, "[length]");
    prm.declare_entry("Refinements",
                      "3",
                      Patterns::Integer(0, 7),
                      "A leaflet has 4 x 4^n quadrilaterals [-].");
  }


  void
  Leaflet::read(ParameterHandler &prm)
  {
    radius      = prm.get_double("Radius");
    height      = prm.get_double("Commissure height");
    dip         = prm.get_double("Dip");
    rounding    = prm.get_double("Centre rounding");
    thickness   = prm.get_double("Thickness");
    gap         = prm.get_double("Gap") * thickness;
    belly       = prm.get_double("Belly");
    refinements = prm.get_integer("Refinements");

    // where the free edge meets the tube, by bisection
    double low = 0., high = radius;
    AssertThrow(edge(0.) < radius,
                ExcMessage("'Leaflets/Radius' is " + std::to_string(radius) +
                           "; expected more than the distance of the free edge "
                           "from the axis, " +
                           std::to_string(edge(0.)) +
                           " with this thickness, gap and rounding."));
    for (unsigned int i = 0; i < 100; ++i)
      {
        commissure = 0.5 * (low + high);
        (std::hypot(edge(commissure), commissure) < radius ? low : high) =
          commissure;
      }
  }


  double
  Leaflet::edge(const double y) const
  {
    return gap / std::sin(half_angle) +
           std::hypot(y / std::tan(half_angle), rounding);
  }


  Point<3>
  Leaflet::place(const double x, const double y) const
  {
    // v runs from the free edge (0) to the attachment (1) at constant y
    const double c = std::sqrt(std::max(0., 1. - y * y));
    const double v = (c > 1e-12) ? std::min(1., x / c) : 0.;
    const double angle =
      std::atan2(commissure, edge(commissure)) * std::clamp(y, -1., 1.);
    const Point<3> attached(radius * std::cos(angle),
                            radius * std::sin(angle),
                            height * (1. - c));
    const Point<3> free(edge(commissure * y),
                        commissure * y,
                        height - dip * c * c);
    Point<3>       result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = (1. - v) * free[i] + v * attached[i];
    // across the line from the free edge to the attachment, in the plane of x
    // and z, downward
    Tensor<1, 3> along = attached - free;
    along[1]           = 0.;
    if (belly != 0. && along.norm() > 0.)
      {
        along /= along.norm();
        const double by = 4. * v * (1. - v) * c * c * belly;
        result[0] += by * along[2];
        result[2] -= by * along[0];
      }
    return result;
  }


  void
  Leaflet::make(const unsigned int n_leaflets, Triangulation<2, 3> &mesh) const
  {
    Triangulation<2> disc;
    GridGenerator::half_hyper_ball(disc);
    disc.refine_global(refinements);
    Triangulation<2> flat;
    GridGenerator::flatten_triangulation(disc, flat);
    const auto [points, cells_of_one, lines_of_one] =
      GridTools::get_coarse_mesh_description(flat);

    std::vector<Point<3>>    vertices;
    std::vector<CellData<2>> cells;
    SubCellData              lines;
    for (unsigned int n = 0; n < n_leaflets; ++n)
      {
        const unsigned int offset = vertices.size();
        for (const Point<2> &p : points)
          vertices.push_back(turned(place(p[0], p[1]), 2. * half_angle * n));
        for (CellData<2> cell : cells_of_one)
          {
            for (unsigned int &v : cell.vertices)
              v += offset;
            cell.material_id = n + 1;
            cells.push_back(cell);
          }
        for (CellData<1> line : lines_of_one.boundary_lines)
          {
            for (unsigned int &v : line.vertices)
              v += offset;
            line.manifold_id = numbers::flat_manifold_id;
            lines.boundary_lines.push_back(line);
          }
      }
    mesh.create_triangulation(vertices, cells, lines);
  }


  void
  SinusWall::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Wall",
                      "rigid",
                      Patterns::Selection("none|rigid"),
                      "Of the tube with the sinuses, for the leaflets to touch "
                      "when they open.");
    prm.declare_entry("Depth",
                      "0.5",
                      Patterns::Double(0.),
                      "Of a sinus beyond the tube [length].");
    prm.declare_entry("Height",
                      "1",
                      Patterns::Double(1e-300),
                      "Of a sinus above z = 0 [length].");
    prm.declare_entry("Range",
                      "-0.3, 1.3",
                      Patterns::List(Patterns::Double(), 2, 2),
                      "Of the wall along z [length].");
    prm.declare_entry("Cells",
                      "48, 24",
                      Patterns::List(Patterns::Integer(3), 2, 2),
                      "Around and along the wall [-].");
  }


  void
  SinusWall::read(ParameterHandler &prm)
  {
    depth  = prm.get_double("Depth");
    height = prm.get_double("Height");
    range  = numbers_of(prm.get("Range"));
    for (const double n : numbers_of(prm.get("Cells")))
      cells.push_back(static_cast<unsigned int>(n));
    AssertThrow(range[0] < range[1],
                ExcMessage("'Sinuses/Range' is '" + prm.get("Range") +
                           "'; expected the lower end first."));
  }


  void
  SinusWall::make(const double                            radius,
                  std::vector<Tensor<1, 3>>              &vertices,
                  std::vector<std::vector<unsigned int>> &facets) const
  {
    for (unsigned int k = 0; k <= cells[1]; ++k)
      for (unsigned int i = 0; i < cells[0]; ++i)
        {
          const double angle = 2. * numbers::PI * i / cells[0];
          const double z     = range[0] + (range[1] - range[0]) * k / cells[1];
          // from the middle of the sector
          const double off  = std::remainder(angle, 2. * half_angle);
          const double over = std::clamp(z / height, 0., 1.);
          const double r =
            radius +
            depth *
              std::pow(std::cos(0.5 * numbers::PI * off / half_angle), 2) *
              std::pow(std::sin(numbers::PI * over), 2);
          Tensor<1, 3> x;
          x[0] = r * std::cos(angle);
          x[1] = r * std::sin(angle);
          x[2] = z;
          vertices.push_back(x);
        }
    for (unsigned int k = 0; k < cells[1]; ++k)
      for (unsigned int i = 0; i < cells[0]; ++i)
        {
          const unsigned int a = k * cells[0] + i;
          const unsigned int b = k * cells[0] + (i + 1) % cells[0];
          facets.push_back({a, a + cells[0], b + cells[0], b});
        }
  }
} // namespace Structure

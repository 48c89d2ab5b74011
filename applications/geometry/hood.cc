// SPDX-License-Identifier: LGPL-2.1-or-later
#include "hood.h"

#include "../structure/numbers_of.h"

#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace Structure
{
  namespace
  {
    /// A grid over the hood's outline at some height, without the cells that
    /// @p is_hole picks by their middle.
    void
    make_sheet(const Hood                                            &hood,
               const std::array<unsigned int, 2>                     &cells,
               const std::function<double(double, double)>           &height,
               const std::function<bool(const double, const double)> &is_hole,
               Triangulation<2, 3>                                   &mesh)
    {
      Triangulation<2> plane;
      GridGenerator::subdivided_hyper_rectangle(plane,
                                                {cells[0], cells[1]},
                                                Point<2>(0., -0.5 * hood.width),
                                                Point<2>(hood.length,
                                                         0.5 * hood.width));
      std::vector<unsigned int> number(plane.n_vertices(),
                                       numbers::invalid_unsigned_int);
      std::vector<Point<3>>     vertices;
      std::vector<CellData<2>>  quads;
      for (const auto &cell : plane.active_cell_iterators())
        {
          if (is_hole(cell->center()[0], cell->center()[1]))
            continue;
          CellData<2> quad;
          for (const unsigned int v : cell->vertex_indices())
            {
              unsigned int &n = number[cell->vertex_index(v)];
              if (n == numbers::invalid_unsigned_int)
                {
                  const Point<2> x = cell->vertex(v);
                  n                = vertices.size();
                  vertices.emplace_back(x[0], x[1], height(x[0], x[1]));
                }
              quad.vertices[v] = n;
            }
          quads.push_back(quad);
        }
      mesh.create_triangulation(vertices, quads, SubCellData());
    }

    /// Height over one direction of a bowl between flanges: 0 on flanges, 1 in
    /// the middle between two of them.
    double
    hat(const double       x, ///< From one end
        const double       length,
        const unsigned int n_inner_flanges,
        const double       flange_width)
    {
      // flanges along both ends, and inner ones at equal distances
      const unsigned int n = n_inner_flanges + 1;
      const double bay   = (length - flange_width * (n_inner_flanges + 2)) / n;
      const double along = std::fmod(x, bay + flange_width) - flange_width;
      if (along <= 0. || x >= length - flange_width)
        return 0.;
      const double s = std::sin(numbers::PI * along / bay);
      return s * s;
    }
  } // namespace


  void
  Hood::declare(ParameterHandler &prm)
  {
    const Patterns::Double positive(1e-300), not_negative(0.);
    const Patterns::List   two(Patterns::Integer(0), 2, 2);
    prm.declare_entry("Length",
                      "1200",
                      positive,
                      "From the nose (x = 0) to the windscreen [length].");
    prm.declare_entry("Width", "1500", positive, "Along y [length].");
    prm.declare_entry("Crown",
                      "80",
                      Patterns::Double(),
                      "Drop from the middle to the sides [length].");
    prm.declare_entry("Nose drop",
                      "110",
                      Patterns::Double(),
                      "From the highest place, a quarter of the length before "
                      "the windscreen, to the nose [length].");
    prm.declare_entry("Character lines",
                      "12",
                      Patterns::Double(),
                      "Height of the two ridges [length].");
    prm.declare_entry("Panel thickness",
                      "0.7",
                      positive,
                      "Of the outer sheet [length].");
    prm.declare_entry("Frame thickness",
                      "0.65",
                      positive,
                      "Of the inner sheet [length].");
    prm.declare_entry("Panel cells",
                      "24, 30",
                      two,
                      "Of the outer sheet along x and y [-].");
    prm.declare_entry("Frame cells",
                      "20, 24",
                      two,
                      "Of the inner sheet along x and y [-].");
    prm.declare_entry("Frame depth",
                      "22",
                      not_negative,
                      "Of the bowls of the inner sheet [length].");
    prm.declare_entry("Flange width",
                      "60",
                      positive,
                      "Of the strips along the edges and between bowls on "
                      "which the frame touches the panel [length].");
    prm.declare_entry(
      "Flanges",
      "2, 1",
      two,
      "Strips between the edges: across and along the car [-].");
    prm.declare_entry("Hole size",
                      "0.5",
                      Patterns::Double(0., 1.),
                      "Share of each bowl's depth at which the frame is cut "
                      "open; 1: no holes [-].");
  }


  void
  Hood::read(ParameterHandler &prm)
  {
    const auto two = [&](const std::string &entry) {
      const std::vector<double> n = numbers_of(prm.get(entry));
      return std::array<unsigned int, 2>{
        {static_cast<unsigned int>(n[0]), static_cast<unsigned int>(n[1])}};
    };
    length          = prm.get_double("Length");
    width           = prm.get_double("Width");
    crown           = prm.get_double("Crown");
    nose_drop       = prm.get_double("Nose drop");
    line_height     = prm.get_double("Character lines");
    panel_thickness = prm.get_double("Panel thickness");
    frame_thickness = prm.get_double("Frame thickness");
    frame_depth     = prm.get_double("Frame depth");
    flange_width    = prm.get_double("Flange width");
    hole_size       = prm.get_double("Hole size");
    panel_cells     = two("Panel cells");
    frame_cells     = two("Frame cells");
    flanges         = two("Flanges");
    for (unsigned int i = 0; i < 2; ++i)
      {
        AssertThrow(panel_cells[i] > 0 && frame_cells[i] > 0,
                    ExcMessage("'Panel cells' or 'Frame cells' has a 0; "
                               "expected positive numbers."));
        const double side = (i == 0) ? length : width;
        AssertThrow(flange_width * (flanges[i] + 2) < side,
                    ExcMessage("'Flanges' of 'Flange width' " +
                               std::to_string(flange_width) +
                               " leave no space for bowls on " +
                               std::to_string(side) + "."));
      }
  }


  double
  Hood::height(const double x, const double y) const
  {
    const double across = 2. * y / width;
    // highest a quarter of the length before the windscreen
    const double along = (0.75 * length - x) / (0.75 * length);
    const double ridge = (std::abs(y) - 0.28 * width - 0.08 * (length - x)) /
                         (width * 70. / 1500.);
    return -crown * across * across -
           nose_drop * along * along * (along < 0. ? 0.3 : 1.) +
           line_height * std::exp(-ridge * ridge);
  }


  double
  Hood::bowl(const double x, const double y) const
  {
    return hat(x, length, flanges[0], flange_width) *
           hat(y + 0.5 * width, width, flanges[1], flange_width);
  }


  void
  Hood::make_panel(Triangulation<2, 3> &mesh) const
  {
    make_sheet(
      *this,
      panel_cells,
      [this](const double x, const double y) { return height(x, y); },
      [](const double, const double) { return false; },
      mesh);
  }


  void
  Hood::make_frame(Triangulation<2, 3> &mesh) const
  {
    make_sheet(
      *this,
      frame_cells,
      [this](const double x, const double y) {
        return height(x, y) - 0.5 * (panel_thickness + frame_thickness) -
               frame_depth * bowl(x, y);
      },
      [this](const double x, const double y) {
        return hole_size < 1. && bowl(x, y) > hole_size;
      },
      mesh);
  }
} // namespace Structure

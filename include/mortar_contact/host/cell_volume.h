// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_cell_volume_h
#define mortar_contact_host_cell_volume_h

#include <deal.II/base/array_view.h>

#include <deal.II/grid/grid_tools.h>

#include <vector>

namespace MortarContact
{
  using namespace dealii;

  /// Volume of a cell between its vertices [m^3], negative inside out, to
  /// round-off wherever it lies: cell->measure() multiplies coordinates, and
  /// has no digits left a million cells away from the origin.
  template <class Cell>
  double
  cell_volume(const Cell &cell)
  {
    constexpr int             dim = Cell::AccessorType::dimension;
    std::vector<Point<dim>>   vertices;
    std::vector<unsigned int> numbers;
    for (const unsigned int v : cell->vertex_indices())
      {
        vertices.emplace_back(cell->vertex(v) - cell->vertex(0));
        numbers.push_back(v);
      }
    return GridTools::cell_measure<dim>(vertices, make_array_view(numbers));
  }
} // namespace MortarContact

#endif

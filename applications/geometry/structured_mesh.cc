// SPDX-License-Identifier: LGPL-2.1-or-later
#include "structured_mesh.h"

#include <deal.II/base/geometry_info.h>

#include <deal.II/grid/tria_description.h>

#include <vector>

namespace Structure
{
  template <int dim>
  void
  make_structured_mesh(
    const std::array<unsigned int, dim>                 &n,
    const bool                                           closed,
    const std::function<Point<dim>(const Point<dim> &)> &place,
    Triangulation<dim>                                  &mesh)
  {
    // vertices in each direction
    std::array<unsigned int, dim> m;
    for (unsigned int d = 0; d < dim; ++d)
      m[d] = n[d] + ((d == 0 && closed) ? 0 : 1);

    const auto vertex_number = [&](std::array<unsigned int, dim> index) {
      if (closed)
        index[0] %= n[0];
      unsigned int number = 0;
      for (unsigned int d = dim; d-- > 0;)
        number = number * m[d] + index[d];
      return number;
    };

    unsigned int n_vertices = 1, n_cells = 1;
    for (unsigned int d = 0; d < dim; ++d)
      {
        n_vertices *= m[d];
        n_cells *= n[d];
      }

    std::vector<Point<dim>> vertices(n_vertices);
    for (unsigned int v = 0; v < n_vertices; ++v)
      {
        Point<dim>   s;
        unsigned int rest = v;
        for (unsigned int d = 0; d < dim; ++d)
          {
            s[d] = static_cast<double>(rest % m[d]) / n[d];
            rest /= m[d];
          }
        vertices[v] = place(s);
      }

    std::vector<CellData<dim>> cells(n_cells);
    for (unsigned int c = 0; c < n_cells; ++c)
      {
        std::array<unsigned int, dim> index;
        unsigned int                  rest = c;
        for (unsigned int d = 0; d < dim; ++d)
          {
            index[d] = rest % n[d];
            rest /= n[d];
          }
        for (unsigned int k = 0; k < GeometryInfo<dim>::vertices_per_cell; ++k)
          {
            std::array<unsigned int, dim> corner = index;
            for (unsigned int d = 0; d < dim; ++d)
              corner[d] += (k >> d) & 1;
            cells[c].vertices[k] = vertex_number(corner);
          }
      }
    mesh.create_triangulation(vertices, cells, SubCellData());

    // the cells keep their order: cell c lies at the index above
    for (const auto &cell : mesh.active_cell_iterators())
      {
        unsigned int rest = cell->active_cell_index();
        for (unsigned int d = 0; d < dim; ++d)
          {
            const unsigned int index = rest % n[d];
            rest /= n[d];
            if (d == 0 && closed)
              continue;
            if (index == 0)
              cell->face(2 * d)->set_boundary_id(2 * d);
            if (index + 1 == n[d])
              cell->face(2 * d + 1)->set_boundary_id(2 * d + 1);
          }
      }
  }


  template void
  make_structured_mesh<2>(const std::array<unsigned int, 2> &,
                          const bool,
                          const std::function<Point<2>(const Point<2> &)> &,
                          Triangulation<2> &);
  template void
  make_structured_mesh<3>(const std::array<unsigned int, 3> &,
                          const bool,
                          const std::function<Point<3>(const Point<3> &)> &,
                          Triangulation<3> &);
} // namespace Structure

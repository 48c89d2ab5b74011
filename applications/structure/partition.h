// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_partition_h
#define mortar_contact_structure_partition_h

#include <deal.II/grid/tria.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace Structure
{
  /// Deal the active cells to the ranks: equal slices along the direction in
  /// which the mesh is longest.
  template <int dim, int spacedim>
  void
  partition_in_slices(dealii::Triangulation<dim, spacedim> &mesh,
                      const unsigned int                    n_ranks)
  {
    using namespace dealii;
    Point<spacedim> low, high;
    bool            first = true;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        const Point<spacedim> c = cell->center();
        for (unsigned int i = 0; i < spacedim; ++i)
          {
            low[i]  = first ? c[i] : std::min(low[i], c[i]);
            high[i] = first ? c[i] : std::max(high[i], c[i]);
          }
        first = false;
      }
    unsigned int axis = 0;
    for (unsigned int i = 1; i < spacedim; ++i)
      if (high[i] - low[i] > high[axis] - low[axis])
        axis = i;

    std::vector<
      std::pair<double,
                typename Triangulation<dim, spacedim>::active_cell_iterator>>
      cells;
    for (const auto &cell : mesh.active_cell_iterators())
      cells.emplace_back(cell->center()[axis], cell);
    std::stable_sort(cells.begin(),
                     cells.end(),
                     [](const auto &a, const auto &b) {
                       return a.first < b.first;
                     });
    for (std::size_t i = 0; i < cells.size(); ++i)
      cells[i].second->set_subdomain_id(i * n_ranks / cells.size());
  }
} // namespace Structure

#endif

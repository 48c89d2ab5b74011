// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_structured_mesh_h
#define mortar_contact_applications_structured_mesh_h

#include <deal.II/grid/tria.h>

#include <array>
#include <functional>

namespace Structure
{
  using namespace dealii;

  /**
   * A block of n_1 x n_2 (x n_3) cells, mapped: vertex (i, j, k) goes to
   * @p place of its coordinates (i/n_1, j/n_2, k/n_3). Boundary ids are 0 and 1
   * for the two ends of the first direction, 2 and 3, 4 and 5.
   *
   * @param closed The first direction closes upon itself: no ids 0 and 1.
   */
  template <int dim>
  void
  make_structured_mesh(
    const std::array<unsigned int, dim>                 &n,
    const bool                                           closed,
    const std::function<Point<dim>(const Point<dim> &)> &place,
    Triangulation<dim>                                  &mesh);
} // namespace Structure

#endif

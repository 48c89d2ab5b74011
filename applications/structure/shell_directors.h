// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_shell_directors_h
#define mortar_contact_structure_shell_directors_h

#include <deal.II/base/tensor.h>

#include <deal.II/grid/tria.h>

#include <set>
#include <utility>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// A plane of symmetry: ids of the edges in it, and its normal.
  using SymmetryPlane = std::pair<std::set<types::boundary_id>, Tensor<1, 3>>;

  /**
   * Which way the cells of a shell mesh face: +1 if the top is where
   * x_,r x x_,s points, else -1; by active cell index. Neighbours across an
   * edge of two cells agree; across edges of three and more (junctions of
   * sheets) nothing is passed on. The first cell of each sheet is +1.
   *
   * @throw ExcMessage for one-sided surfaces (a Moebius strip).
   */
  std::vector<int>
  orient(const Triangulation<2, 3> &mesh);

  /**
   * Directors at the vertices: the mean of the normals of the cells around,
   * each weighted by its angle. Where these differ by more than 20 degrees
   * (kinks, junctions) the vector with D . n = 1 for all of them, so that
   * sheets keep their thickness. In planes of symmetry they lie in the plane.
   */
  std::vector<Tensor<1, 3>>
  directors_of(const Triangulation<2, 3>        &mesh,
               const std::vector<int>           &orientation,
               const std::vector<SymmetryPlane> &planes);

  /// The vertices of a cell in cyclic order.
  std::vector<unsigned int>
  cyclic_vertices(const Triangulation<2, 3>::cell_iterator &cell);
} // namespace Structure

#endif

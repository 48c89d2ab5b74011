// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_distributed_mesh_h
#define mortar_contact_structure_distributed_mesh_h

#include <deal.II/distributed/tria_base.h>

#include <deal.II/grid/tria.h>

#include <memory>

namespace Structure
{
  using namespace dealii;

  /**
   * A copy of a mesh, which all ranks have, with its cells dealt to the ranks:
   * equal slices along the direction in which it is longest.
   *
   * A rank keeps its own cells and those that share a vertex with them, all on
   * one level. Coarse cell ids (CellId) are the numbers of the active cells of
   * @p mesh. Faces between a neighbour's cell and one that the rank does not
   * know look like those of the boundary: ask own cells only.
   *
   * @param is_whole Whether each rank keeps the whole mesh instead, with its
   * levels: what is to be refined. So it does where there is one rank, where
   * ranks would have no cells, and where the mesh has hanging nodes.
   */
  template <int dim, int spacedim>
  std::unique_ptr<parallel::TriangulationBase<dim, spacedim>>
  distribute(const Triangulation<dim, spacedim> &mesh,
             const bool                          is_whole,
             const MPI_Comm                      communicator);
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_body.h"

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace Structure
{
  namespace
  {
    /// Deal the active cells to the ranks: equal slices along the direction in
    /// which the mesh is longest.
    template <int dim, int spacedim>
    void
    partition_in_slices(Triangulation<dim, spacedim> &mesh,
                        const unsigned int            n_ranks)
    {
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
  } // namespace


  template <int dim, int spacedim>
  MeshBody<dim, spacedim>::MeshBody(const std::string                  &name,
                                    const Triangulation<dim, spacedim> &mesh,
                                    const MPI_Comm communicator)
    : Body<spacedim>(name)
    , triangulation(
        communicator,
        Triangulation<dim, spacedim>::none,
        false,
        parallel::shared::Triangulation<dim, spacedim>::partition_custom_signal)
    , dof_handler(triangulation)
  {
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (auto *signal : {&triangulation.signals.create,
                         &triangulation.signals.post_refinement})
      signal->connect(
        [this, n_ranks]() { partition_in_slices(triangulation, n_ranks); });
    triangulation.copy_triangulation(mesh);
    AssertThrow(triangulation.all_reference_cells_are_simplex() ||
                  triangulation.all_reference_cells_are_hyper_cube(),
                ExcMessage("Body '" + name +
                           "': the mesh mixes cell types; expected " +
                           (dim == 3 ? "hexahedra only or tetrahedra only." :
                                       "quadrilaterals only or triangles "
                                       "only.")));
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::distribute_dofs(
    std::unique_ptr<FESystem<dim, spacedim>> element)
  {
    fe = std::move(element);
    dof_handler.distribute_dofs(*fe);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        local_cells.push_back(cell);
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::add_constraints(
    AffineConstraints<double> &constraints) const
  {
    DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::dofs_of(
    const unsigned int                    cell,
    std::vector<types::global_dof_index> &dofs) const
  {
    dofs.resize(fe->n_dofs_per_cell());
    local_cells[cell]->get_dof_indices(dofs);
    for (auto &d : dofs)
      d = this->numbering(d);
  }


  template <int dim, int spacedim>
  std::string
  MeshBody<dim, spacedim>::name_of(const unsigned int cell) const
  {
    std::ostringstream text;
    text.precision(4);
    text << "cell " << local_cells[cell]->global_active_cell_index() << " of '"
         << this->name << "' at (" << local_cells[cell]->center() << ")";
    return text.str();
  }


  template class MeshBody<2, 2>;
  template class MeshBody<3, 3>;
  template class MeshBody<2, 3>;
} // namespace Structure

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_body.h"

#include <deal.II/base/mpi.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/numerics/solution_transfer.h>

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
    first_level = triangulation.n_levels() - 1;
    AssertThrow(dim < spacedim ||
                  triangulation.all_reference_cells_are_simplex() ||
                  triangulation.all_reference_cells_are_hyper_cube(),
                ExcMessage("Body '" + name +
                           "': the mesh mixes cell types; expected " +
                           (dim == 3 ? "hexahedra only or tetrahedra only." :
                                       "quadrilaterals only or triangles "
                                       "only.")));
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::distribute_dofs()
  {
    if (elements.size() > 1)
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned())
          for (unsigned int i = 0; i < elements.size(); ++i)
            if (elements[i].reference_cell() == cell->reference_cell())
              cell->set_active_fe_index(i);
    dof_handler.distribute_dofs(elements);
    local_cells.clear();
    levels.clear();
    active_numbers.resize(triangulation.n_active_cells());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (cell->is_locally_owned())
          local_cells.push_back(cell);
        active_numbers[cell->global_active_cell_index()] =
          cell->active_cell_index();
        levels.push_back(std::max(0, cell->level() - first_level));
      }
  }


  template <int dim, int spacedim>
  std::vector<types::global_dof_index>
  MeshBody<dim, spacedim>::dofs_in_order() const
  {
    std::vector<types::global_dof_index> result, of_cell;
    std::vector<char>                    seen(dof_handler.n_dofs(), false);
    result.reserve(dof_handler.n_dofs());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        of_cell.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(of_cell);
        for (const auto dof : of_cell)
          if (!seen[dof])
            {
              seen[dof] = true;
              result.push_back(this->numbering(dof));
            }
      }
    return result;
  }


  template <int dim, int spacedim>
  std::vector<double>
  MeshBody<dim, spacedim>::of_all_cells(
    const std::vector<double> &of_local_cells) const
  {
    std::vector<unsigned int> cells;
    for (const Cell &cell : local_cells)
      cells.push_back(cell->active_cell_index());
    const MPI_Comm communicator = triangulation.get_communicator();
    const auto     all_cells = Utilities::MPI::all_gather(communicator, cells);
    const auto     values =
      Utilities::MPI::all_gather(communicator, of_local_cells);
    std::size_t n = 0;
    for (const auto &v : values)
      n += v.size();
    std::vector<double> result(n);
    n /= triangulation.n_active_cells();
    for (std::size_t rank = 0; rank < values.size(); ++rank)
      for (std::size_t i = 0; i < all_cells[rank].size(); ++i)
        std::copy_n(values[rank].begin() + i * n,
                    n,
                    result.begin() + all_cells[rank][i] * n);
    return result;
  }


  template <int dim, int spacedim>
  std::vector<double>
  MeshBody<dim, spacedim>::of_local_cells(
    const std::vector<double> &of_all_cells) const
  {
    const std::size_t n = of_all_cells.size() / triangulation.n_active_cells();
    std::vector<double> result;
    for (const Cell &cell : local_cells)
      result.insert(result.end(),
                    of_all_cells.begin() + cell->active_cell_index() * n,
                    of_all_cells.begin() + (cell->active_cell_index() + 1) * n);
    return result;
  }


  template <int dim, int spacedim>
  std::vector<Vector<double>>
  MeshBody<dim, spacedim>::refine(const std::string                 &flags,
                                  const std::vector<Vector<double>> &fields)
  {
    AssertThrow(flags.size() == triangulation.n_active_cells(),
                ExcMessage("The refinement belongs to another mesh than that "
                           "of '" +
                           this->name + "'."));
    for (const auto &cell : triangulation.active_cell_iterators())
      if (flags[cell->active_cell_index()] == 'r')
        cell->set_refine_flag();
      else if (flags[cell->active_cell_index()] == 'c')
        cell->set_coarsen_flag();
    triangulation.prepare_coarsening_and_refinement();
    SolutionTransfer<dim, Vector<double>, spacedim> transfer(dof_handler);
    if (!fields.empty())
      transfer.prepare_for_coarsening_and_refinement(fields);
    triangulation.execute_coarsening_and_refinement();
    distribute_dofs();
    std::vector<Vector<double>> result(fields.size(),
                                       Vector<double>(dof_handler.n_dofs()));
    if (!fields.empty())
      transfer.interpolate(fields, result);
    return result;
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::add_constraints(
    AffineConstraints<double> &constraints) const
  {
    if (triangulation.has_hanging_nodes())
      DoFTools::make_hanging_node_constraints(dof_handler, constraints);
  }


  template <int dim, int spacedim>
  void
  MeshBody<dim, spacedim>::dofs_of(
    const unsigned int                    cell,
    std::vector<types::global_dof_index> &dofs) const
  {
    dofs.resize(n_dofs_per_cell(cell));
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

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_body.h"

#include "distributed_mesh.h"

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/numerics/solution_transfer.h>

#include <algorithm>
#include <sstream>
#include <tuple>

namespace Structure
{
  template <int dim, int spacedim>
  MeshBody<dim, spacedim>::MeshBody(const std::string                  &name,
                                    const Triangulation<dim, spacedim> &mesh,
                                    const bool     is_whole,
                                    const MPI_Comm communicator)
    : Body<spacedim>(name, communicator)
    , mesh(distribute(mesh, is_whole, communicator))
    , whole(dynamic_cast<
              const parallel::DistributedTriangulationBase<dim, spacedim> *>(
              this->mesh.get()) == nullptr)
    , triangulation(*this->mesh)
    , has_simplices_only(mesh.all_reference_cells_are_simplex())
    , has_hypercubes_only(mesh.all_reference_cells_are_hyper_cube())
    , dof_handler(triangulation)
    , first_level(mesh.n_levels() - 1)
  {
    AssertThrow(dim < spacedim || has_simplices_only || has_hypercubes_only,
                ExcMessage("Body '" + name +
                           "': the mesh mixes cell types; expected " +
                           (dim == 3 ? "hexahedra only or tetrahedra only." :
                                       "quadrilaterals only or triangles "
                                       "only.")));
    for (const auto id : mesh.get_boundary_ids())
      ids_of_boundaries.insert(id);
    for (const auto &cell : mesh.active_cell_iterators())
      ids_of_materials.insert(cell->material_id());
    const auto &vertices = mesh.get_vertices();
    corners              = {vertices.front(), vertices.front()};
    for (const Point<spacedim> &v : vertices)
      for (unsigned int i = 0; i < spacedim; ++i)
        {
          corners.first[i]  = std::min(corners.first[i], v[i]);
          corners.second[i] = std::max(corners.second[i], v[i]);
        }
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
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (cell->is_locally_owned())
        local_cells.push_back(cell);
    if (!whole)
      return;
    active_numbers.resize(triangulation.n_active_cells());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        active_numbers[cell->global_active_cell_index()] =
          cell->active_cell_index();
        levels.push_back(std::max(0, cell->level() - first_level));
      }
  }


  template <int dim, int spacedim>
  std::vector<types::global_dof_index>
  MeshBody<dim, spacedim>::dofs_in_order() const
  {
    // In the order in which they come on the cells of the whole mesh: all cells
    // of an owned dof are known, so its owner knows the first of them.
    using Place =
      std::tuple<unsigned int, unsigned int, types::global_dof_index>;
    std::vector<Place>                   all;
    std::vector<types::global_dof_index> of_cell;
    const IndexSet    known = whole ? complete_index_set(dof_handler.n_dofs()) :
                                      dof_handler.locally_owned_dofs();
    std::vector<bool> seen(known.n_elements(), false);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        of_cell.resize(cell->get_fe().n_dofs_per_cell());
        cell->get_dof_indices(of_cell);
        for (unsigned int a = 0; a < of_cell.size(); ++a)
          if (known.is_element(of_cell[a]))
            {
              const auto i = known.index_within_set(of_cell[a]);
              if (!seen[i])
                all.emplace_back(number_of(cell),
                                 a,
                                 this->numbering(of_cell[a]));
              seen[i] = true;
            }
      }
    if (!whole)
      {
        const auto of_ranks =
          Utilities::MPI::all_gather(this->communicator, all);
        all.clear();
        for (const auto &of_rank : of_ranks)
          all.insert(all.end(), of_rank.begin(), of_rank.end());
        std::sort(all.begin(), all.end());
      }
    std::vector<types::global_dof_index> result;
    result.reserve(all.size());
    for (const auto &[cell, of_cell, dof] : all)
      result.push_back(dof);
    return result;
  }


  template <int dim, int spacedim>
  std::vector<Vector<double>>
  MeshBody<dim, spacedim>::refine(const std::string                 &flags,
                                  const std::vector<Vector<double>> &fields)
  {
    Assert(whole, ExcInternalError());
    AssertThrow(flags.size() == triangulation.n_active_cells(),
                ExcMessage("The refinement belongs to another mesh than that "
                           "of '" +
                           this->name + "'."));
    for (const auto &cell : mesh->active_cell_iterators())
      if (flags[cell->active_cell_index()] == 'r')
        cell->set_refine_flag();
      else if (flags[cell->active_cell_index()] == 'c')
        cell->set_coarsen_flag();
    mesh->prepare_coarsening_and_refinement();
    SolutionTransfer<dim, Vector<double>, spacedim> transfer(dof_handler);
    if (!fields.empty())
      transfer.prepare_for_coarsening_and_refinement(fields);
    mesh->execute_coarsening_and_refinement();
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

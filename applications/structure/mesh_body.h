// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_mesh_body_h
#define mortar_contact_structure_mesh_body_h

#include "body.h"

#include <deal.II/base/mpi.h>

#include <deal.II/distributed/tria_base.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/hp/fe_collection.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  /// What solids and shells share: a mesh with cells dealt to the ranks, see
  /// distribute(), and a finite element for each of their types.
  template <int dim, int spacedim>
  class MeshBody : public Body<spacedim>
  {
  public:
    /// @param mesh The same on all ranks; not needed afterwards.
    MeshBody(const std::string                  &name,
             const Triangulation<dim, spacedim> &mesh,
             const bool                          is_whole,
             const MPI_Comm                      communicator);

    types::global_dof_index
    n_dofs() const override
    {
      return dof_handler.n_dofs();
    }

    types::global_dof_index
    n_owned_dofs() const override
    {
      return dof_handler.n_locally_owned_dofs();
    }

    unsigned int
    n_dofs_per_cell(const unsigned int cell) const override
    {
      return local_cells[cell]->get_fe().n_dofs_per_cell();
    }

    types::global_dof_index
    n_cells() const override
    {
      return triangulation.n_global_active_cells();
    }

    const std::set<types::boundary_id> &
    boundary_ids() const override
    {
      return ids_of_boundaries;
    }

    const std::set<types::material_id> &
    material_ids() const override
    {
      return ids_of_materials;
    }

    types::material_id
    material_of(const unsigned int cell) const override
    {
      return local_cells[cell]->material_id();
    }

    const std::pair<Point<spacedim>, Point<spacedim>> &
    box() const override
    {
      return corners;
    }

    bool
    is_whole() const override
    {
      return whole;
    }

    unsigned int
    n_local_cells() const override
    {
      return local_cells.size();
    }

    void
    add_constraints(AffineConstraints<double> &constraints) const override;

    void
    dofs_of(const unsigned int                    cell,
            std::vector<types::global_dof_index> &dofs) const override;

    std::string
    name_of(const unsigned int cell) const override;

    std::vector<types::global_dof_index>
    dofs_in_order() const override;

    unsigned int
    level_of(const unsigned int active_cell) const override
    {
      Assert(whole, ExcInternalError());
      return levels[active_cell];
    }

    unsigned int
    active_number(const types::global_cell_index label) const override
    {
      Assert(whole, ExcInternalError());
      return active_numbers[label];
    }

    std::vector<Vector<double>>
    refine(const std::string                 &flags,
           const std::vector<Vector<double>> &fields) override;

  private:
    const std::unique_ptr<parallel::TriangulationBase<dim, spacedim>> mesh;
    const bool                                                        whole;

  public:
    const Triangulation<dim, spacedim> &triangulation;
    const bool                          has_simplices_only, has_hypercubes_only;
    hp::FECollection<dim, spacedim>     elements; ///< Solids: one.
    DoFHandler<dim, spacedim>           dof_handler;

  protected:
    using Cell = typename DoFHandler<dim, spacedim>::active_cell_iterator;

    /// Number the dofs of the mesh as it is. The derived class fills
    /// `elements` before.
    void
    distribute_dofs();

    /// The number of a cell among the active cells of the whole mesh.
    unsigned int
    number_of(const Cell &cell) const
    {
      return whole ? cell->active_cell_index() :
                     cell->id().get_coarse_cell_id();
    }

    /// Join what each rank has of its cells, in the order of the whole mesh.
    /// Collective.
    template <class T>
    std::vector<T>
    of_all_cells(const std::vector<std::vector<T>> &of_local_cells) const;

    std::vector<Cell> local_cells;

  private:
    std::set<types::boundary_id>                ids_of_boundaries;
    std::set<types::material_id>                ids_of_materials;
    std::pair<Point<spacedim>, Point<spacedim>> corners;

    int first_level = 0; ///< Finest of the mesh that was given.
    /// By active cell; empty if the mesh is not whole.
    std::vector<unsigned int> levels;
    /// By global active cell index, which counts rank by rank.
    std::vector<unsigned int> active_numbers;
  };


  template <int dim, int spacedim>
  template <class T>
  std::vector<T>
  MeshBody<dim, spacedim>::of_all_cells(
    const std::vector<std::vector<T>> &of_local_cells) const
  {
    AssertDimension(of_local_cells.size(), local_cells.size());
    std::vector<std::pair<unsigned int, std::vector<T>>> own, all;
    for (std::size_t c = 0; c < local_cells.size(); ++c)
      own.emplace_back(number_of(local_cells[c]), of_local_cells[c]);
    for (auto &of_rank : Utilities::MPI::all_gather(this->communicator, own))
      std::move(of_rank.begin(), of_rank.end(), std::back_inserter(all));
    std::sort(all.begin(), all.end(), [](const auto &a, const auto &b) {
      return a.first < b.first;
    });
    std::vector<T> result;
    for (const auto &of_cell : all)
      result.insert(result.end(), of_cell.second.begin(), of_cell.second.end());
    return result;
  }
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_mesh_body_h
#define mortar_contact_structure_mesh_body_h

#include "body.h"

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/hp/fe_collection.h>

#include <string>
#include <vector>

namespace Structure
{
  /// What solids and shells share: a mesh with cells dealt to the ranks, in
  /// slices along the longest direction, and a finite element for each of
  /// their types.
  template <int dim, int spacedim>
  class MeshBody : public Body<spacedim>
  {
  public:
    MeshBody(const std::string                  &name,
             const Triangulation<dim, spacedim> &mesh,
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

    std::vector<types::boundary_id>
    boundary_ids() const override
    {
      return triangulation.get_boundary_ids();
    }

    std::set<types::material_id>
    material_ids() const override
    {
      std::set<types::material_id> ids;
      for (const auto &cell : triangulation.active_cell_iterators())
        ids.insert(cell->material_id());
      return ids;
    }

    types::material_id
    material_of(const unsigned int cell) const override
    {
      return local_cells[cell]->material_id();
    }

    const std::vector<Point<spacedim>> &
    vertices() const override
    {
      return triangulation.get_vertices();
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
      return levels[active_cell];
    }

    unsigned int
    active_number(const types::global_cell_index label) const override
    {
      return active_numbers[label];
    }

    std::vector<Vector<double>>
    refine(const std::string                 &flags,
           const std::vector<Vector<double>> &fields) override;

    parallel::shared::Triangulation<dim, spacedim> triangulation;
    hp::FECollection<dim, spacedim>                elements; ///< Solids: one.
    DoFHandler<dim, spacedim>                      dof_handler;

  protected:
    /// Number the dofs of the mesh as it is. The derived class fills
    /// `elements` before.
    void
    distribute_dofs();

    /// Join the values that each rank has of its cells, equally many each, in
    /// the order of active cells.
    std::vector<double>
    of_all_cells(const std::vector<double> &of_local_cells) const;

    /// The values of local cells among those of all.
    std::vector<double>
    of_local_cells(const std::vector<double> &of_all_cells) const;

    using Cell = typename DoFHandler<dim, spacedim>::active_cell_iterator;
    std::vector<Cell> local_cells;

  private:
    int first_level = 0; ///< Finest of the mesh that was given.
    /// By active cell.
    std::vector<unsigned int> levels;
    /// By global active cell index, which counts rank by rank.
    std::vector<unsigned int> active_numbers;
  };
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_body_h
#define mortar_contact_structure_body_h

#include "material.h"

#include <mortar_contact/host/dof_numbering.h>

#include <deal.II/base/quadrature.h>

#include <deal.II/distributed/shared_tria.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <memory>
#include <string>

namespace Structure
{
  /**
   * A deformable solid: its mesh (hexahedra or tetrahedra; quadrilaterals or
   * triangles in plane strain), its finite element and its material. Each body
   * has a DoFHandler of its own; numbering() gives the numbers of its dofs in
   * the model.
   */
  template <int dim>
  class Body
  {
  public:
    /**
     * @param mesh   The coarse mesh, with ids and manifolds set. Cells are
     *               dealt to the ranks in slices along the longest direction.
     * @param degree Of the displacements, 1 or 2.
     * @param mean_dilatation Replace J by the cell's mean in the volumetric
     *               energy (Q1P0): no locking for nearly incompressible solids.
     */
    Body(const std::string        &name,
         const Triangulation<dim> &mesh,
         std::unique_ptr<Material> material,
         const unsigned int        degree,
         const bool                mean_dilatation,
         const MPI_Comm            communicator);

    const std::string                    name;
    const std::unique_ptr<Material>      material;
    const bool                           mean_dilatation;
    parallel::shared::Triangulation<dim> triangulation;
    std::unique_ptr<Mapping<dim>>        mapping;
    std::unique_ptr<FESystem<dim>>       fe;
    std::unique_ptr<Quadrature<dim>>     quadrature;
    std::unique_ptr<Quadrature<dim - 1>> face_quadrature;
    DoFHandler<dim>                      dof_handler;
    MortarContact::DoFNumbering          numbering; ///< Set by the model.

    /// Dead load per undeformed volume, expressions of x, y, z, t; empty: none.
    std::string body_force;

    /// Velocity at the start, expressions of x, y, z; empty: at rest.
    std::string initial_velocity;
  };
} // namespace Structure

#endif

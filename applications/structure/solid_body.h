// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_solid_body_h
#define mortar_contact_structure_solid_body_h

#include "element.h"
#include "material.h"
#include "mesh_body.h"

#include <deal.II/base/quadrature.h>

#include <deal.II/fe/mapping.h>

#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace Structure
{
  /**
   * A deformable solid: its mesh (hexahedra or tetrahedra; quadrilaterals or
   * triangles in plane strain), its finite element and its material.
   */
  template <int dim>
  class SolidBody : public MeshBody<dim, dim>
  {
  public:
    using ValuesOfCell = typename Body<dim>::ValuesOfCell;
    using Visitor      = typename Body<dim>::Visitor;
    using MeshBody<dim, dim>::triangulation;
    using MeshBody<dim, dim>::elements;
    using MeshBody<dim, dim>::dof_handler;

    /**
     * @param mesh   With ids and manifolds set, the same on all ranks.
     * @param degree Of the displacements, 1 or 2.
     * @param mean_dilatation Replace J by the cell's mean in the volumetric
     *               energy (Q1P0): no locking for nearly incompressible solids.
     * @param is_whole Each rank keeps the whole mesh, see distribute().
     */
    SolidBody(const std::string        &name,
              const Triangulation<dim> &mesh,
              std::unique_ptr<Material> material,
              const unsigned int        degree,
              const bool                mean_dilatation,
              const bool                is_whole,
              const MPI_Comm            communicator);

    std::string
    description() const override
    {
      return mean_dilatation ? ", mean dilatation" : "";
    }

    double
    force_scale(const double size) const override
    {
      return material->shear_modulus * std::pow(size, dim - 1.);
    }

    bool
    is_linear() const override
    {
      return material->is_linear;
    }

    bool
    evaluate(const unsigned int    cell,
             const Vector<double> &u,
             const Vector<double> *previous,
             const bool            with_tangent,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) override;

    std::unique_ptr<CellBatches<dim>>
    make_batches(const IndexSet &owned,
                 const IndexSet &relevant) const override;

    double
    energy(const unsigned int cell, const Vector<double> &u) override;

    void
    mass(const unsigned int cell, FullMatrix<double> &matrix) override;

    void
    add_load(const unsigned int    cell,
             Load<dim>            &load,
             const Vector<double> &u,
             const double          time,
             Vector<double>       &forces,
             FullMatrix<double>   &tangent) override;

    bool
    can_be_refined() const override
    {
      return this->has_hypercubes_only;
    }

    std::vector<double>
    gradient_jumps(const Vector<double> &u) const override;

    unsigned int
    component_of(const unsigned int dof) const override
    {
      return component[dof];
    }

    DoFPlace<dim>
    place_of(const unsigned int cell, const unsigned int dof) const override;

    void
    visit_boundary_nodes(const std::set<types::boundary_id> &ids,
                         const Visitor &visit) const override;

    void
    visit_nodes(const Visitor &visit) const override;

    void
    add_to(MortarContact::ContactInterface<dim> &interface,
           const bool                            secondary,
           const MortarContact::FaceSelection   &faces) const override;

    void
    write(const ValuesOfCell &values_of_cell,
          const std::string  &file,
          const MPI_Comm      communicator) override;

    /// Means over a cell at the last evaluate() or energy().
    const CellState &
    state() const
    {
      return element->state();
    }

    Point<dim>
    centre_of(const unsigned int cell) const
    {
      return local_cells[cell]->center();
    }

    /// Undeformed vertex of a local cell.
    Point<dim>
    vertex_of(const unsigned int cell, const unsigned int vertex) const
    {
      return local_cells[cell]->vertex(vertex);
    }

    const std::unique_ptr<Material>      material;
    const bool                           mean_dilatation;
    std::unique_ptr<Mapping<dim>>        mapping;
    std::unique_ptr<Quadrature<dim>>     quadrature;
    std::unique_ptr<Quadrature<dim - 1>> face_quadrature;

  private:
    using MeshBody<dim, dim>::local_cells;

    void
    add_pressure(const FEFaceValues<dim> &face,
                 Load<dim>               &load,
                 const Vector<double>    &u,
                 const double             time,
                 Vector<double>          &forces,
                 FullMatrix<double>      &tangent) const;

    std::unique_ptr<Element<dim>>      element;
    std::unique_ptr<FEValues<dim>>     load_values;
    std::unique_ptr<FEFaceValues<dim>> face_values;
    std::vector<unsigned int>          component; ///< By dof of a cell.
  };
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_leaflets_h
#define mortar_contact_immersed_leaflets_h

#include "beam.h"

#include <mortar_contact/host/contact_interface.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>

#include <deal.II/grid/tria.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>

#include <string>
#include <utility>
#include <vector>

namespace Immersed
{
  /// Straight when undeformed, from the root, which is clamped, to the tip.
  struct Leaflet
  {
    Point<2>     root, tip; ///< [m]
    unsigned int n_cells  = 1;
    bool         is_rigid = false; ///< Does not move at all.
  };

  /**
   * Leaflets of BeamElement in the plane: the dofs of a node are the
   * displacement v of its place and the change q of its director over the
   * length s, d = D + q/s, so that all forces have the same unit.
   */
  class Leaflets
  {
  public:
    Leaflets(const std::vector<Leaflet> &leaflets,
             const BeamMaterial         &material);

    /// At the end of a step: dofs, and their rates.
    struct State
    {
      Vector<double> u, rate; ///< [m, m/s]
    };

    /// Hold the roots, and all of rigid leaflets.
    void
    constrain(AffineConstraints<double> &constraints) const;

    /// Couplings within the leaflets.
    void
    add_couplings(DynamicSparsityPattern          &sparsity,
                  const AffineConstraints<double> &constraints) const;

    /// Add matrix and negative residual of internal forces and of inertia
    /// (implicit Euler; @p time_step 0: none) at @p u, where the last Newton
    /// iteration brought it by @p update (see BeamElement).
    void
    assemble(const Vector<double>            &u,
             const Vector<double>            &update,
             const State                     &old,
             const double                     time_step,
             const AffineConstraints<double> &constraints,
             SparseMatrix<double>            &matrix,
             Vector<double>                  &rhs) const;

    /// Strain energy [J/m].
    double
    strain_energy(const Vector<double> &u) const;

    /// Let all leaflets take part in contact, with their tips.
    void
    add_to(MortarContact::ContactInterface<2> &contact) const;

    /// Place of a vertex of the mesh.
    Point<2>
    place(const unsigned int vertex, const Vector<double> &u) const;

    /// Whether a leaflet lies between two corners of a box.
    bool
    is_within(const Point<2>       &low,
              const Point<2>       &high,
              const unsigned int    leaflet,
              const Vector<double> &u) const;

    /// Vertex at the tip of a leaflet.
    unsigned int
    tip(const unsigned int leaflet) const
    {
      return tips[leaflet];
    }

    void
    write(const std::string &file, const Vector<double> &u) const;

    const double scale; ///< s [m]

    Triangulation<1, 2> triangulation;
    FESystem<1, 2>      fe; ///< v, q
    DoFHandler<1, 2>    dof_handler;

  private:
    /// Local dofs in the order of BeamElement: component 2 i + c.
    std::vector<types::global_dof_index>
    dofs_of(const DoFHandler<1, 2>::active_cell_iterator &cell) const;

    /// Their changes by @p u.
    BeamElement::Nodes
    changes_of(const std::vector<types::global_dof_index> &dofs,
               const Vector<double>                       &u) const;

    BeamElement::Nodes
    nodes_of(const std::vector<types::global_dof_index> &dofs,
             const unsigned int                          cell,
             const Vector<double>                       &u) const;

    const std::vector<Leaflet>      leaflets;
    const BeamMaterial              material;
    std::vector<BeamElement>        elements;
    std::vector<BeamElement::Nodes> reference; ///< By active cell.
    std::vector<Tensor<1, 2>>       directors; ///< D by vertex.
    std::vector<unsigned int>       tips;
  };
} // namespace Immersed

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_coupling_h
#define mortar_contact_immersed_coupling_h

#include "leaflets.h"
#include "navier_stokes.h"

#include <deal.II/grid/grid_tools_cache.h>

#include <vector>

namespace Immersed
{
  /**
   * The fluid sticks to the leaflets: beta (u - dr/dt) pulls at both, per unit
   * of length of the undeformed leaflets (D. Kamensky et al., Comput. Methods
   * Appl. Mech. Eng. 284 (2015) 1005, the multiplier dropped). The force on
   * one is minus that on the other, so that momentum is kept; what flows
   * through a leaflet is the pressure jump over beta. The leaflets are where
   * they were at the start of the step.
   */
  class Coupling
  {
  public:
    /// @param beta [Pa s/m]
    Coupling(const DoFHandler<2> &fluid_dofs,
             const NavierStokes  &fluid,
             const Leaflets      &leaflets,
             const double         beta);

    /// Find the cells of the fluid that the leaflets lie in at @p leaflet_u.
    /// @throw ExcMessage if a leaflet is not within the fluid.
    void
    locate(const Vector<double> &leaflet_u);

    /// Couplings between fluid and leaflets; dofs of the fluid count from
    /// @p first.
    void
    add_couplings(DynamicSparsityPattern          &sparsity,
                  const AffineConstraints<double> &constraints,
                  const types::global_dof_index    first) const;

    /// Add matrix and negative residual at the flow @p flow and the leaflets'
    /// displacements @p u, @p old at the start of the step.
    void
    assemble(const Vector<double>            &flow,
             const Vector<double>            &u,
             const Vector<double>            &old,
             const double                     time_step,
             const AffineConstraints<double> &constraints,
             const types::global_dof_index    first,
             SparseMatrix<double>            &matrix,
             Vector<double>                  &rhs) const;

    /// Which cell of the fluid couples to which of the leaflets: the pattern of
    /// the matrix depends on these pairs, level, index and cell.
    std::vector<std::array<int, 3>>
    pairs() const;

    /// Of the points at the last locate().
    std::vector<Point<2>>
    places() const;

    const double beta;

  private:
    struct CoupledPoint
    {
      double             weight; ///< [m]
      Point<2>           place;
      std::array<int, 3> pair; ///< See pairs().
      /// Of the velocities, then of the leaflet's places: component k % 2.
      std::vector<types::global_dof_index> dofs;
      std::vector<double>                  shapes; ///< Minus for leaflets.
    };

    /// u - dr/dt at a point.
    Tensor<1, 2>
    slip(const CoupledPoint   &point,
         const Vector<double> &flow,
         const Vector<double> &u,
         const Vector<double> &old,
         const double          time_step) const;

    std::vector<types::global_dof_index>
    system_dofs(const CoupledPoint           &point,
                const types::global_dof_index first) const;

    const DoFHandler<2>      &fluid_dofs;
    const NavierStokes       &fluid;
    const Leaflets           &leaflets;
    std::vector<CoupledPoint> points;
    unsigned int              n_fluid = 0; ///< Entries of the fluid per point.
  };
} // namespace Immersed

#endif

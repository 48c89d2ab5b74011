// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_navier_stokes_h
#define mortar_contact_immersed_navier_stokes_h

#include <deal.II/base/function.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/mapping.h>

#include <deal.II/lac/affine_constraints.h>
#include <deal.II/lac/sparse_matrix.h>
#include <deal.II/lac/vector.h>

#include <map>

namespace Immersed
{
  using namespace dealii;

  /// An incompressible Newtonian fluid.
  struct FluidParameters
  {
    double density   = 1.; ///< [kg/m^3]
    double viscosity = 1.; ///< Dynamic [Pa s].
    /// Of the term that keeps volume where the pressure jumps [Pa s].
    double grad_div = 0.;
  };

  /**
   * Incompressible Navier-Stokes in the plane: continuous quadratic velocities,
   * discontinuous linear pressures, implicit Euler:
   *   (rho (u - u_n)/dt + rho u.grad u, w) + 2 mu (eps u, eps w)
   *     + gamma (div u, div w) - (p, div w) - (div u, q) + (p_b n, w)_b = 0.
   * Volume is kept cell by cell, and by gamma within cells, where a thin body
   * cuts them: a continuous pressure cannot jump across it, and such elements
   * leak (SHELL_AND_FLUID 4.3).
   */
  class NavierStokes
  {
  public:
    explicit NavierStokes(const FluidParameters &parameters);

    /// Boundary pressures p_b [Pa], by boundary id.
    using Pressures = std::map<types::boundary_id, double>;

    /**
     * Add the matrix of Newton's method and the negative residual at @p u;
     * dofs count from @p first in them.
     * @param old At the start of the step. @param time_step [s]; 0: steady.
     */
    void
    assemble(const DoFHandler<2>             &dof_handler,
             const Mapping<2>                &mapping,
             const Vector<double>            &u,
             const Vector<double>            &old,
             const double                     time_step,
             const Pressures                 &pressures,
             const AffineConstraints<double> &constraints,
             const types::global_dof_index    first,
             SparseMatrix<double>            &matrix,
             Vector<double>                  &rhs) const;

    /// Volume that leaves through a boundary per unit of time [m^2/s].
    double
    flux(const DoFHandler<2>     &dof_handler,
         const Mapping<2>        &mapping,
         const Vector<double>    &u,
         const types::boundary_id boundary) const;

    /// Mean pressure over a boundary [Pa].
    double
    mean_pressure(const DoFHandler<2>     &dof_handler,
                  const Mapping<2>        &mapping,
                  const Vector<double>    &u,
                  const types::boundary_id boundary) const;

    const FluidParameters parameters;
    const FESystem<2>     fe; ///< Two velocities, pressure.
  };
} // namespace Immersed

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_mixed_solver_h
#define mortar_contact_structure_mixed_solver_h

#include "cell_batches.h"
#include "multigrid.h"

namespace Structure
{
  /// What solve_mixed() took.
  struct MixedSolve
  {
    bool         converged  = false;
    unsigned int iterations = 0;
  };

  /**
   * Solve the system of PressureUnknowns by FGMRES with the preconditioner
   *   [ P   B^T ]
   *   [ 0   -S  ],   S = V/(K - k) + V/(mu + k) cell by cell,
   * which needs about three times as many iterations at nu = 0.4999 as at 0.45:
   * pressures that alternate from cell to cell hardly move trilinear cells.
   *
   * @param matrix A.
   * @param multigrid Whose V-cycle is the inverse of P.
   * @param residual r.
   * @param pressures Takes the update of the pressures.
   * @param x Takes du; the start is zero.
   * @param tolerance Residual over right-hand side, both in the norm of the
   *                  diagonal's inverse [-].
   */
  MixedSolve
  solve_mixed(const Matrix_t    &matrix,
              const Multigrid   &multigrid,
              const Vector_t    &residual,
              PressureUnknowns  &pressures,
              Vector_t          &x,
              const double       tolerance,
              const unsigned int max_iterations);
} // namespace Structure

#endif

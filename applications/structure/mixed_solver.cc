// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mixed_solver.h"

#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_parallel_block_vector.h>

#include <Epetra_CrsMatrix.h>
#include <Epetra_FEVector.h>

#include <cmath>

namespace Structure
{
  namespace
  {
    using Block = TrilinosWrappers::MPI::BlockVector;

    /// The matrix, with rows multiplied by `weights`.
    struct MixedMatrix
    {
      const Matrix_t         &A;
      const PressureUnknowns &pressures;
      const Block            &weights;
      mutable Vector_t        compressed;

      void
      vmult(Block &dst, const Block &src) const
      {
        A.vmult(dst.block(0), src.block(0));
        pressures.derivative.Tvmult_add(dst.block(0), src.block(1));
        pressures.derivative.vmult(dst.block(1), src.block(0));
        compressed = src.block(1);
        compressed.scale(pressures.compliance);
        dst.block(1) -= compressed;
        dst.scale(weights);
      }
    };


    struct MixedPreconditioner
    {
      const Multigrid        &of_A;
      const PressureUnknowns &pressures;
      const Block            &inverse_weights;
      const Vector_t         &inverse_schur; ///< -1/S
      mutable Vector_t        negative, rest;

      void
      vmult(Block &dst, const Block &src) const
      {
        dst.block(1) = src.block(1);
        dst.block(1).scale(inverse_weights.block(1));
        dst.block(1).scale(inverse_schur);
        rest = src.block(0);
        rest.scale(inverse_weights.block(0));
        negative = dst.block(1);
        negative *= -1.;
        pressures.derivative.Tvmult_add(rest, negative);
        of_A.vmult(dst.block(0), rest);
      }
    };
  } // namespace


  MixedSolve
  solve_mixed(const Matrix_t    &matrix,
              const Multigrid   &multigrid,
              const Vector_t    &residual,
              PressureUnknowns  &pressures,
              Vector_t          &x,
              const double       tolerance,
              const unsigned int max_iterations)
  {
    // Step 1: weights 1/sqrt(A_ii), 1/sqrt(S): residuals in the norm of the
    // energy. In forces, the stiffest body would hide the others.
    Block rhs(2), solution(2), weights(2), inverse_weights(2);
    for (Block *v : {&rhs, &weights, &inverse_weights})
      {
        v->block(0).reinit(residual, true);
        v->block(1).reinit(pressures.residual, true);
        v->collect_sizes();
      }
    matrix.trilinos_matrix().ExtractDiagonalCopy(
      *weights.block(0).trilinos_vector()(0));
    weights.block(1)       = pressures.schur;
    Vector_t inverse_schur = pressures.schur;
    for (double &s : inverse_schur)
      s = -1. / s;
    for (unsigned int b = 0; b < 2; ++b)
      for (auto w = weights.block(b).begin(),
                i = inverse_weights.block(b).begin();
           w != weights.block(b).end();
           ++w, ++i)
        {
          *i = (*w != 0.) ? std::sqrt(std::abs(*w)) : 1.;
          *w = 1. / *i;
        }

    // Step 2: right-hand side r - B^T k/V R, -(R + B du_0).
    rhs.block(0)    = residual;
    Vector_t volume = pressures.residual;
    volume.scale(pressures.in_matrix);
    volume *= -1.;
    pressures.derivative.Tvmult_add(rhs.block(0), volume);
    rhs.block(1) = pressures.residual;
    rhs.block(1) += pressures.prescribed;
    rhs.block(1) *= -1.;
    rhs.scale(weights);
    solution.reinit(rhs);

    // Step 3: solve.
    const MixedMatrix         A{matrix, pressures, weights, volume};
    const MixedPreconditioner P{
      multigrid, pressures, inverse_weights, inverse_schur, volume, residual};
    MixedSolve    result;
    SolverControl control(max_iterations, tolerance * rhs.l2_norm());
    try
      {
        SolverFGMRES<Block>(control, SolverFGMRES<Block>::AdditionalData(40))
          .solve(A, solution, rhs, P);
        result.converged = std::isfinite(solution.l2_norm());
      }
    catch (const SolverControl::NoConvergence &)
      {}
    result.iterations = control.last_step();

    // Step 4: dp = dq + k/V (B (du + du_0) + R).
    x                = solution.block(0);
    pressures.update = pressures.residual;
    pressures.update += pressures.prescribed;
    pressures.derivative.vmult_add(pressures.update, x);
    pressures.update.scale(pressures.in_matrix);
    pressures.update += solution.block(1);
    return result;
  }
} // namespace Structure

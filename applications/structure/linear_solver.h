// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_linear_solver_h
#define mortar_contact_structure_linear_solver_h

#include "direct_solver.h"
#include "model.h"

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Structure
{
  /// Settings of the linear solver.
  struct LinearSolverParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    std::string  type           = "automatic";
    unsigned int direct_limit   = 60000; ///< dofs, for automatic in 3d
    double       tolerance      = 1e-10; ///< Relative residual.
    unsigned int max_iterations = 2000;
  };

  /// What a solve took.
  struct LinearSolve
  {
    bool         converged  = false;
    unsigned int iterations = 0; ///< 0: direct.
    std::string  method;
  };

  /**
   * Solves matrix x = rhs: directly by MUMPS, or by CG (symmetric models) or
   * GMRES with algebraic multigrid that knows the rigid body motions. When an
   * iterative method fails, the direct one takes over.
   */
  template <int dim>
  class LinearSolver
  {
  public:
    LinearSolver(const LinearSolverParameters &parameters,
                 const MPI_Comm                communicator)
      : parameters(parameters)
      , direct(communicator)
    {}

    LinearSolve
    solve(const Model<dim> &model, Vector_t &x);

  private:
    const LinearSolverParameters parameters;
    DirectSolver                 direct;
  };
} // namespace Structure

#endif

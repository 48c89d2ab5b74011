// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_linear_solver_h
#define mortar_contact_structure_linear_solver_h

#include "direct_solver.h"
#include "model.h"
#include "multigrid.h"

#include <deal.II/base/parameter_handler.h>

#include <memory>
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

    std::string  type            = "automatic";
    unsigned int direct_limit    = 60000; ///< dofs, for automatic in 3d
    double       tolerance       = 1e-10; ///< Relative residual.
    double       mixed_tolerance = 1e-2;  ///< With pressures as unknowns.
    unsigned int max_iterations  = 2000;

    /// Whether a model of that many dofs is solved iteratively. Multigrid
    /// fails for shells.
    bool
    is_iterative(const unsigned int dim,
                 const double       n_dofs,
                 const bool         has_shells) const
    {
      return type == "iterative" ||
             (type == "automatic" && !has_shells &&
              n_dofs > direct_limit * (dim == 2 ? 10. : 1.));
    }
  };

  /// What a solve took.
  struct LinearSolve
  {
    bool         converged   = false;
    bool         is_singular = false; ///< So the direct solver says.
    unsigned int iterations  = 0;     ///< Of iterative methods.
    std::string  method;
  };

  /**
   * Solves matrix x = rhs: directly by MUMPS (large models: by GMRES with
   * factors of an earlier iteration of the step, where that is faster), or by
   * CG (symmetric models) or GMRES with algebraic multigrid that knows the
   * rigid body motions (when they fail, the direct one takes over), or with
   * pressures as unknowns by solve_mixed().
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

    /// @param share_left Of the residual, is enough, where pressures are
    ///                   unknowns [-].
    LinearSolve
    solve(Model<dim> &model, Vector_t &x, const double share_left);

    /// Forget factors: results do not depend on the tries before.
    void
    start_step()
    {
      has_factors = false;
    }

    /// Hierarchies of multigrid that were made.
    unsigned int
    n_setups() const
    {
      return n_multigrids;
    }

    LinearSolver(const LinearSolver &) = delete; // models may refer to it

  private:
    /// Multigrid for the matrix of the model.
    void
    make_multigrid(Model<dim> &model);

    /// By the direct solver, with its old factors if they serve.
    LinearSolve
    solve_directly(Model<dim> &model, Vector_t &x);

    /// From the solution x of K x = r to that of (K - sum c_i r_i^T) x = r
    /// (Sherman, Morrison and Woodbury), K the last matrix of the direct
    /// solver.
    void
    add_low_rank(const std::vector<Vector_t> &columns,
                 const std::vector<Vector_t> &rows,
                 Vector_t                    &x);

    const LinearSolverParameters parameters;
    DirectSolver                 direct;
    bool                         has_factors = false; ///< Of this step.
    double last_norm = 0.; ///< Of its last right-hand side.

    std::unique_ptr<Multigrid> multigrid;
    unsigned int multigrid_iterations = 0; ///< Of its first solve; 0: none yet.
    unsigned int multigrid_excess     = 0; ///< Beyond these, since then.
    unsigned int multigrid_numbering  = 0; ///< Model::n_numberings.
    unsigned int n_multigrids         = 0;
  };
} // namespace Structure

#endif

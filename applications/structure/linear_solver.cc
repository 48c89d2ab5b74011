// SPDX-License-Identifier: LGPL-2.1-or-later
#include "linear_solver.h"

#include "mixed_solver.h"

#include <deal.II/base/patterns.h>

#include <deal.II/lac/solver_cg.h>
#include <deal.II/lac/solver_gmres.h>
#include <deal.II/lac/trilinos_solver.h>

#include <algorithm>

namespace Structure
{
  namespace
  {
    /// Unknowns from which old factors are tried, where the right-hand side
    /// has fallen to this share of the last: then the matrix has hardly
    /// changed. So many iterations of GMRES with them take half the time of
    /// new factors (15 000 shells).
    constexpr unsigned int old_factors_from = 20000, most_with_old_factors = 16;
    constexpr double       falls = 0.1;

    /// Iterations of FGMRES that an old multigrid may take more than at first,
    /// all in all (about what a new one takes), and in one solution.
    constexpr unsigned int setup_cost = 15, most_in_vain = 60;

    /// Residual over right-hand side that is as good as a direct solution.
    constexpr double exact = 1e-10;
  } // namespace


  void
  LinearSolverParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Type",
                      "automatic",
                      Patterns::Selection("automatic|direct|iterative"),
                      "direct: MUMPS. iterative: CG or GMRES with algebraic "
                      "multigrid; with nearly incompressible cells (mean "
                      "dilatation, neo-Hookean) FGMRES with their pressures as "
                      "unknowns. automatic: direct up to the limit below and "
                      "for shells.");
    prm.declare_entry(
      "Direct up to",
      "60000",
      Patterns::Integer(0),
      "Unknowns up to which automatic means direct in 3d; in 2d "
      "ten times as many [-].");
    prm.declare_entry("Tolerance",
                      "1e-10",
                      Patterns::Double(1e-15, 1e-1),
                      "Residual over right-hand side, iterative [-].");
    prm.declare_entry("Mixed tolerance",
                      "1e-2",
                      Patterns::Double(1e-15, 1e-1),
                      "The smallest where the pressures of nearly "
                      "incompressible cells are unknowns: up to 0.1 while "
                      "Newton's method gains no more [-].");
    prm.declare_entry("Maximum iterations",
                      "2000",
                      Patterns::Integer(1),
                      "Then the direct solver takes over, or with pressures "
                      "as unknowns the step is cut back [-].");
  }


  void
  LinearSolverParameters::read(ParameterHandler &prm)
  {
    type            = prm.get("Type");
    direct_limit    = prm.get_integer("Direct up to");
    tolerance       = prm.get_double("Tolerance");
    mixed_tolerance = prm.get_double("Mixed tolerance");
    max_iterations  = prm.get_integer("Maximum iterations");
  }


  template <int dim>
  void
  LinearSolver<dim>::make_multigrid(Model<dim> &model)
  {
    model.before_new_matrix = [this]() {
      if (multigrid && multigrid->has_levels())
        multigrid->forget_matrix();
      else
        multigrid.reset();
    };
    multigrid.reset(); // never two of them at once
    multigrid =
      std::make_unique<Multigrid>(model.matrix, model.rigid_body_modes());
    ++n_multigrids;
    multigrid_numbering  = model.n_numberings;
    multigrid_iterations = 0;
    multigrid_excess     = 0;
  }


  template <int dim>
  LinearSolve
  LinearSolver<dim>::solve(Model<dim>  &model,
                           Vector_t    &x,
                           const double share_left)
  {
    LinearSolve result;
    if (model.pressures.are_on)
      {
        result.method = "FGMRES";
        // an old hierarchy serves until what it has cost would have paid a
        // new one
        if (multigrid && multigrid_numbering == model.n_numberings &&
            multigrid_excess < setup_cost)
          multigrid->update(model.matrix);
        else
          make_multigrid(model);
        for (bool again = true; again;)
          {
            const bool         is_new = multigrid_iterations == 0;
            const unsigned int most =
              is_new ? parameters.max_iterations :
                       std::min(parameters.max_iterations,
                                multigrid_iterations + most_in_vain);
            const MixedSolve solved =
              solve_mixed(model.matrix,
                          *multigrid,
                          model.rhs,
                          model.pressures,
                          x,
                          std::max(parameters.mixed_tolerance, share_left),
                          most);
            result.iterations += solved.iterations;
            result.converged = solved.converged;
            again            = !solved.converged && !is_new;
            if (again)
              make_multigrid(model);
            else if (!solved.converged)
              multigrid.reset();
            else if (is_new)
              multigrid_iterations = std::max(1u, solved.iterations);
            else if (solved.iterations > multigrid_iterations)
              multigrid_excess += solved.iterations - multigrid_iterations;
          }
        return result;
      }
    // the fluid's part of the tangent needs the factors
    const bool iterative =
      !model.fluid &&
      parameters.is_iterative(dim, model.n_dofs(), model.has_shells());
    if (iterative)
      {
        make_multigrid(model);
        const auto   &amg = *multigrid;
        SolverControl control(parameters.max_iterations,
                              parameters.tolerance * model.rhs.l2_norm());
        result.method = model.is_symmetric ? "CG" : "GMRES";
        try
          {
            x = 0.;
            if (model.is_symmetric)
              SolverCG<Vector_t>(control).solve(model.matrix,
                                                x,
                                                model.rhs,
                                                amg);
            else
              SolverGMRES<Vector_t>(control,
                                    SolverGMRES<Vector_t>::AdditionalData(100))
                .solve(model.matrix, x, model.rhs, amg);
            result.converged  = std::isfinite(x.l2_norm());
            result.iterations = control.last_step();
          }
        catch (const SolverControl::NoConvergence &e)
          {
            result.iterations = e.last_step;
          }
        multigrid.reset();
        if (result.converged)
          return result;
      }
    const unsigned int in_vain = result.iterations;
    const std::string  tried   = result.method;
    result                     = solve_directly(model, x);
    result.iterations += in_vain;
    if (iterative)
      result.method = tried + " failed, " + result.method;
    return result;
  }


  template <int dim>
  LinearSolve
  LinearSolver<dim>::solve_directly(Model<dim> &model, Vector_t &x)
  {
    LinearSolve result;
    result.method     = "MUMPS";
    const double norm = model.rhs.l2_norm();
    // the fluid's part of the tangent needs the factors
    const bool tries_old =
      has_factors && !model.fluid && norm <= falls * last_norm;
    last_norm = norm;
    if (tries_old)
      {
        SolverControl control(most_with_old_factors, exact * norm);
        const SolverGMRES<Vector_t>::AdditionalData right_preconditioned(
          most_with_old_factors + 2, true);
        x = 0.;
        try
          {
            SolverGMRES<Vector_t>(control, right_preconditioned)
              .solve(model.matrix, x, model.rhs, direct);
            result.converged = std::isfinite(x.l2_norm());
          }
        catch (const SolverControl::NoConvergence &)
          {}
        result.iterations = control.last_step();
        if (result.converged)
          return result;
      }
    result.converged = direct.factorise(model.matrix, model.n_patterns);
    if (result.converged)
      {
        direct.vmult(x, model.rhs);
        result.converged = std::isfinite(x.l2_norm());
      }
    result.is_singular = !result.converged;
    has_factors        = result.converged && model.n_dofs() >= old_factors_from;
    if (model.fluid && result.converged)
      add_low_rank(model.fluid->columns, model.fluid->rows, x);
    return result;
  }


  template <int dim>
  void
  LinearSolver<dim>::add_low_rank(const std::vector<Vector_t> &columns,
                                  const std::vector<Vector_t> &rows,
                                  Vector_t                    &x)
  {
    const unsigned int n = columns.size();
    if (n == 0)
      return;
    FullMatrix<double>    small(n, n);
    Vector<double>        right(n), factors(n);
    std::vector<Vector_t> y(n, x);
    for (unsigned int i = 0; i < n; ++i)
      direct.vmult(y[i], columns[i]);
    for (unsigned int i = 0; i < n; ++i)
      {
        right(i) = rows[i] * x;
        for (unsigned int j = 0; j < n; ++j)
          small(i, j) = (i == j ? 1. : 0.) - rows[i] * y[j];
      }
    small.gauss_jordan();
    small.vmult(factors, right);
    for (unsigned int i = 0; i < n; ++i)
      x.add(factors(i), y[i]);
  }


  template class LinearSolver<2>;
  template class LinearSolver<3>;
} // namespace Structure

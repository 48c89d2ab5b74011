// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_newton_h
#define mortar_contact_structure_newton_h

#include "linear_solver.h"

#include <functional>
#include <string>

namespace Structure
{
  /// Settings of Newton's method.
  struct NewtonParameters
  {
    static void
    declare(ParameterHandler &prm);

    void
    read(ParameterHandler &prm);

    double       force_tolerance        = 1e-8;
    double       displacement_tolerance = 1e-6;
    unsigned int max_iterations         = 25;
    std::string  line_search            = "energy";
    bool         predicts = false; ///< Start from extrapolated motion.
  };

  /// One Newton iterate, for those who watch.
  struct NewtonIterate
  {
    unsigned int iteration = 0;
    double       residual  = 0.; ///< Over the force scale.
    double       update    = 0.; ///< Largest motion over that of the step.
    double       step      = 1.; ///< Share of the Newton update taken.
    LinearSolve  linear;
  };

  struct NewtonResult
  {
    bool         converged         = false;
    unsigned int iterations        = 0; ///< Linear solves.
    unsigned int linear_iterations = 0;
    double       residual          = 0.; ///< Over the force scale.
    std::string  failure;
  };

  /**
   * Newton's method for one step to @p time, from @p u on; @p u_start is the
   * last accepted state. Converged when the residual is below the force
   * tolerance times the largest of the norms of internal, external and contact
   * forces, and the last update is below the displacement tolerance times the
   * motion of the step. Scenes without forces have a floor that scales with the
   * materials and the size: it makes sense in any units.
   * @param mixed_points For shells, see ShellElement::evaluate(): fewer
   *                     iterations, but it may fail where plain Newton does
   * not.
   */
  template <int dim>
  NewtonResult
  solve_step(Model<dim>                                       &model,
             const NewtonParameters                           &parameters,
             LinearSolver<dim>                                &linear,
             const double                                      time,
             const Vector_t                                   &u_start,
             Vector_t                                         &u,
             const bool                                        mixed_points,
             const std::function<void(const NewtonIterate &)> &watch);
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "newton.h"

#include <deal.II/base/patterns.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Structure
{
  namespace
  {
    /// Forces below this times Body::force_scale(), the largest of all bodies,
    /// are none.
    constexpr double force_floor = 1e-12;

    /// Motions below this times the size of the scene are none.
    constexpr double motion_floor = 1e-12;

    /// Motions of a step below this times the displacements are none: nothing
    /// happens in the step, and updates are round-off.
    constexpr double still = 1e-3;

    /// Shells: work of an update over the largest of the step below which only
    /// round-off of their stiff directions is left (with residual_round_off).
    /// So it is where the residual has stopped falling and updates are
    /// small: on fine meshes round-off is above a force tolerance of 1e-8.
    constexpr double work_round_off = 1e-16, small_update = 1e-9;

    /// Updates below this are round-off: no better solution can be written
    /// down. Then the residual's floor is reached too, if it is at least below
    /// the second number.
    constexpr double update_round_off   = 1e-11;
    constexpr double residual_round_off = 1e-6;

    /// So it is where forces are below this times that force scale: stresses of
    /// bodies that move without strain, or are at rest again.
    constexpr double stress_round_off = 1e-13;

    /// Forces below this times that force scale are round-off,
    /// where they have stopped falling: those of ties and of stiff bodies that
    /// only begin to be touched by something soft.
    constexpr double force_round_off = 2.2e-16, stagnating = 0.5;

    /// A residual this much below the tolerance needs no second witness.
    constexpr double surely_converged = 1e-3;

    /// The line search accepts an update when the residual's work along it
    /// falls below this share.
    constexpr double enough = 0.9;

    /// Beyond the most iterations it goes on while the residual falls to this
    /// share in each.
    constexpr double nearly_there = 0.1;

    /// Updates this many times the size of the scene come of a tangent that is
    /// singular but for round-off. Cut short they may lead to contact, which
    /// holds what nothing held; so many are given up.
    constexpr double       no_update      = 1e6;
    constexpr unsigned int most_no_update = 5;

    /// Iterations after which updates of shells are shortened, too, where a
    /// first try (with extrapolated stresses) has failed: contact of edges may
    /// come and go for ever.
    constexpr unsigned int chatter_after = 8;

    /// Inexact solutions: the share of the residual that may be left is never
    /// more than the first, follows the last fall of the residual by factor and
    /// power, and leaves the third share of the force tolerance.
    constexpr double most_left = 0.1, left_factor = 0.9, left_power = 1.618,
                     left_at_end = 0.2;

    /// Trials of the line search.
    constexpr unsigned int max_trials = 4;

    /// How much of the residual a linear solution may leave: no less than
    /// Newton's method can use (S. Eisenstat, H. Walker, Choosing the forcing
    /// terms in an inexact Newton method, doi:10.1137/0917003, choice 2), no
    /// less than the step needs. All in the same unit.
    double
    share_left(const double residual,
               const double last_residual,
               const double tolerance)
    {
      // An update too rough to start with costs an iteration more.
      if (last_residual == std::numeric_limits<double>::max())
        return 0.;
      const double share =
        left_factor * std::pow(residual / last_residual, left_power);
      return std::min(most_left,
                      std::max(share, left_at_end * tolerance / residual));
    }
  } // namespace


  void
  NewtonParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Force tolerance",
                      "1e-8",
                      Patterns::Double(1e-15, 1e-1),
                      "Residual over the largest of internal, external and "
                      "contact forces [-].");
    prm.declare_entry("Displacement tolerance",
                      "1e-6",
                      Patterns::Double(1e-15, 1e6),
                      "Last update over the motion of the step [-].");
    prm.declare_entry("Maximum iterations",
                      "25",
                      Patterns::Integer(1, 1000),
                      "Then the step is cut back, unless the residual still "
                      "falls tenfold in each [-].");
    prm.declare_entry("Line search",
                      "energy",
                      Patterns::Selection("none|residual|energy"),
                      "Shorten updates until the residual, or its work along "
                      "the update, falls.");
    prm.declare_entry("Predictor",
                      "none",
                      Patterns::Selection("none|linear"),
                      "Where a step starts: from the last state, or from the "
                      "motion of the last step continued. Saves "
                      "iterations where a tool moves steadily over something "
                      "soft; a step that fails is tried again without.");
  }


  void
  NewtonParameters::read(ParameterHandler &prm)
  {
    force_tolerance        = prm.get_double("Force tolerance");
    displacement_tolerance = prm.get_double("Displacement tolerance");
    max_iterations         = prm.get_integer("Maximum iterations");
    line_search            = prm.get("Line search");
    predicts               = prm.get("Predictor") == "linear";
  }


  template <int dim>
  NewtonResult
  solve_step(Model<dim>                                       &model,
             const NewtonParameters                           &parameters,
             LinearSolver<dim>                                &linear,
             const double                                      time,
             const Vector_t                                   &u_start,
             Vector_t                                         &u,
             const bool                                        mixed_points,
             const std::function<void(const NewtonIterate &)> &watch)
  {
    linear.start_step();
    NewtonResult result;
    Vector_t     du    = model.make_vector();
    double       floor = 0.;
    for (const auto &b : model.bodies)
      floor = std::max(floor, force_floor * b->force_scale(model.size));
    // bending to a large angle first stretches: no line search then, which
    // would allow small steps only
    const bool has_shells = model.has_shells();
    double     work = 0., largest_work = 0.; ///< Of the updates.
    double     last_residual = std::numeric_limits<double>::max();
    double     last_motion   = std::numeric_limits<double>::max();

    unsigned int  n_no_updates = 0;
    NewtonIterate iterate;
    iterate.update = std::numeric_limits<double>::max();
    result.failure = model.assemble(u, time, true);
    if (!result.failure.empty())
      return result;

    while (true)
      {
        // Step 1: converged?
        const ForceNorms &n = model.norms;
        const double      scale =
          std::max({n.internal, n.external, n.contact, n.inertia, floor});
        iterate.residual     = n.residual / scale;
        const bool at_target = n.to_prescribe <= motion_floor * model.size;
        watch(iterate);
        result.residual = iterate.residual;
        if (!std::isfinite(n.residual))
          {
            result.failure = "the residual is not a number";
            return result;
          }
        if (at_target &&
            ((iterate.residual <= parameters.force_tolerance &&
              iterate.update <= parameters.displacement_tolerance) ||
             iterate.residual <=
               surely_converged * parameters.force_tolerance ||
             (has_shells && result.iterations > 0 &&
              iterate.residual <= residual_round_off &&
              work <= work_round_off * largest_work) ||
             (has_shells && iterate.residual <= residual_round_off &&
              n.residual >= stagnating * last_residual && iterate.step == 1. &&
              iterate.update <= small_update) ||
             (n.residual <= force_round_off / force_floor * floor &&
              n.residual >= stagnating * last_residual &&
              iterate.update <= parameters.displacement_tolerance) ||
             ((iterate.update <= update_round_off ||
               last_motion <= motion_floor * model.size) &&
              (iterate.residual <= residual_round_off ||
               n.residual <= stress_round_off / force_floor * floor))))
          {
            result.converged = true;
            return result;
          }
        if (result.iterations >= parameters.max_iterations &&
            (!at_target ||
             iterate.residual > nearly_there * last_residual / scale))
          {
            result.failure = "no convergence in " +
                             std::to_string(result.iterations) + " iterations";
            return result;
          }

        // Step 2: the update.
        {
          TimerOutput::Scope scope(model.timer, "linear solver");
          iterate.linear =
            linear.solve(model,
                         du,
                         share_left(n.residual,
                                    last_residual,
                                    parameters.force_tolerance * scale));
        }
        ++result.iterations;
        ++iterate.iteration;
        result.linear_iterations += iterate.linear.iterations;
        if (!iterate.linear.converged)
          {
            result.failure =
              iterate.linear.is_singular ?
                "the tangent matrix is singular (a body that nothing holds?)" :
                "the linear solver did not converge in " +
                  std::to_string(iterate.linear.iterations) +
                  " iterations ('Solver/Linear/Type = direct' may)";
            return result;
          }
        model.constraints.distribute(du);
        if (du.linfty_norm() > no_update * model.size &&
            ++n_no_updates > most_no_update)
          {
            result.failure = "the tangent matrix is nearly singular (a body "
                             "that nothing holds?)";
            return result;
          }
        iterate.step = 1.;
        for (const auto &interface : model.interfaces)
          iterate.step =
            std::min(iterate.step, interface->largest_safe_step(u, du));

        // Step 3: go there; shorten while it does not help.
        const double work_before     = du * model.rhs;
        work                         = std::abs(work_before);
        largest_work                 = std::max(largest_work, work);
        const double residual_before = n.residual;
        last_residual                = n.residual;
        const Vector_t u_before      = u;
        const Vector_t p_before      = model.pressures.value;
        // nor with pressures as unknowns: a saddle point has no descent
        const bool search =
          parameters.line_search != "none" && at_target &&
          (!has_shells ||
           (!mixed_points && iterate.iteration > chatter_after)) &&
          !model.pressures.are_on;
        for (unsigned int trial = 0;; ++trial)
          {
            u = u_before;
            u.add(iterate.step, du);
            if (model.pressures.are_on)
              {
                model.pressures.value = p_before;
                model.pressures.value.add(iterate.step, model.pressures.update);
              }
            result.failure = model.assemble(
              u, time, true, mixed_points ? &u_before : nullptr, false);
            const bool better = model.norms.residual < residual_before;
            const bool less_work =
              std::abs(du * model.rhs) <= enough * std::abs(work_before);
            const bool good = parameters.line_search == "energy" ?
                                (better || less_work) :
                                better;
            if (result.failure.empty() && (!search || good))
              break;
            if (trial == max_trials)
              {
                if (result.failure.empty())
                  break; // go on from here: contact may need to get worse first
                return result;
              }
            iterate.step *= 0.5;
          }

        Vector_t motion = u;
        motion -= u_start;
        last_motion    = iterate.step * du.linfty_norm();
        iterate.update = last_motion / std::max({motion.linfty_norm(),
                                                 still * u.linfty_norm(),
                                                 motion_floor * model.size});
      }
  }


  template NewtonResult
  solve_step(Model<2> &,
             const NewtonParameters &,
             LinearSolver<2> &,
             const double,
             const Vector_t &,
             Vector_t &,
             const bool,
             const std::function<void(const NewtonIterate &)> &);
  template NewtonResult
  solve_step(Model<3> &,
             const NewtonParameters &,
             LinearSolver<3> &,
             const double,
             const Vector_t &,
             Vector_t &,
             const bool,
             const std::function<void(const NewtonIterate &)> &);
} // namespace Structure

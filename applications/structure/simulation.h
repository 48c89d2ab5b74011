// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_simulation_h
#define mortar_contact_structure_simulation_h

#include "model.h"
#include "output.h"
#include "scene.h"

#include <functional>
#include <memory>
#include <string>

namespace Structure
{
  /// Exit codes of the drivers.
  enum ExitCode
  {
    finished       = 0,
    wrong_input    = 1,
    no_convergence = 2,
    internal_error = 3,
    stopped        = 4 ///< By a signal; can be continued.
  };

  /**
   * A static or dynamic run of a scene: builds the model, steps through time
   * with automatic step size, writes what is asked for.
   */
  template <int dim>
  class Simulation
  {
  public:
    /**
     * @param used_parameters Text for parameters.prm.
     * @param log Where progress goes; nothing is printed elsewhere.
     */
    Simulation(const Scene       &scene,
               const std::string &used_parameters,
               const MPI_Comm     communicator,
               Log               &log);

    /// Build the model.
    void
    setup();

    /// Log what was built: bodies, dofs, interfaces, initial penetrations.
    void
    report_setup();

    /// Continue from a checkpoint in @p directory. After setup().
    void
    restart(const std::string &directory);

    /// All steps. @return finished, no_convergence or stopped.
    ExitCode
    run();

    /// Called after each accepted step, for tests and for drivers.
    std::function<void(Simulation<dim> &)> after_step;

    const Scene       scene;
    const MPI_Comm    communicator;
    TimerOutput       timer;
    Model<dim>        model;
    LinearSolver<dim> linear_solver;
    Vector_t          u;    ///< Displacements of the last accepted state.
    Vector_t          rate; ///< Of the last step, for the predictor.
    double            time              = 0.;
    unsigned int      step              = 0; ///< Accepted steps.
    unsigned int      cut_backs         = 0;
    unsigned int      newton_iterations = 0; ///< Also of rejected steps.
    unsigned int      linear_iterations = 0;
    NewtonResult      last_newton; ///< Of the last accepted step.

    /// Contact force on a rigid body, and its moment about the body's centre of
    /// rotation [N, N m].
    std::pair<Tensor<1, 3>, Tensor<1, 3>>
    resultant(const MortarContact::RigidBody<dim> &body) const;

    /// Displacement of a probe.
    Tensor<1, dim>
    probe(const unsigned int p) const;

  private:
    /// What a checkpoint holds besides u.
    std::vector<Vector_t *>
    more_state();

    std::unique_ptr<Body<dim>>
    make_solid(const BodyParameters &parameters) const;

    std::unique_ptr<Body<dim>>
    make_shell(const BodyParameters &parameters) const;

    /// Where a step to @p new_time starts: the motion from u on.
    Vector_t
    predicted_motion(const double new_time);

    /// The end of the next step: the tools go at most so far.
    double
    safe_target(const double target);

    /// One try; empty: accepted.
    std::string
    try_step(const double new_time);

    /// Contact and reactions, after a rejected try, are those of the last
    /// accepted state again.
    void
    show_last_state();

    /// Save the last accepted state, since a signal asks to stop.
    ExitCode
    stop_run();

    void
    write_step(const double step_size, const bool is_last);

    void
    write_checkpoint();

    void
    write_summary(const std::string &status);

    std::string  used_parameters;
    Log         &log;
    Output<dim>  output;
    double       next_step         = 0.; ///< Size of the next step.
    unsigned int cut_backs_of_step = 0;
    Timer        wall;
    std::vector<std::shared_ptr<MortarContact::RigidBody<dim>>> rigid_bodies;
    std::vector<std::array<types::global_dof_index, dim>>       probe_dofs;
  };
} // namespace Structure

#endif

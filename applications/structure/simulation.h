// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_simulation_h
#define mortar_contact_structure_simulation_h

#include "contact_resolution.h"
#include "model.h"
#include "output.h"
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
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

    /// Continue from a checkpoint in @p directory, written on any number of
    /// ranks. After setup().
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
    Vector_t          rate; ///< Of the last try that converged.
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
    /// What a run keeps: u, and what the next step starts from.
    std::vector<Vector_t *>
    kept_vectors();

    /// What a checkpoint holds.
    std::vector<Vector_t *>
    saved_vectors();

    /// Dofs, interfaces, conditions and vectors for the meshes as they are.
    void
    connect();

    void
    check_refinement() const;

    /**
     * Refine the meshes where the state after a successful try of the step to
     * @p new_time says so, and go back to the start of this step on them.
     * @param start kept_vectors() there.
     * @return False: nothing is to be refined, nothing was done.
     */
    bool
    refine_and_go_back(const double                 new_time,
                       const std::vector<Vector_t> &start);

    /// Values of all dofs by body, in the bodies' numberings; then of those of
    /// rigid bodies.
    std::vector<Vector<double>>
    values_by_body(const Vector_t &v) const;
    void
    set_values_by_body(const std::vector<Vector<double>> &values, Vector_t &v);

    /// The bodies of the scene, undeformed; solids with whole meshes on each
    /// rank can be refined. connect() must follow.
    void
    make_bodies(const bool whole_meshes);

    std::unique_ptr<Body<dim>>
    make_solid(const BodyParameters &parameters, const bool whole_meshes) const;

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

    /**
     * Compare the energy at the end of a step with the work done from outside,
     * by the trapezoidal rule. Statics: the difference is what the steps are
     * too long for the path. Dynamics: steps too long for an impact create
     * energy; what damping and the time integration take only makes it less.
     * @param energy Kinetic and strain energy of the bodies [J].
     */
    void
    audit_energy(const double energy);

    /// In the springs of all interfaces, and dissipated by them [J].
    double
    contact_energy() const;

    /// Begin it.
    void
    begin_audit();

    void
    save_checkpoint();

    /// All dofs, in an order that does not depend on the ranks.
    std::vector<types::global_dof_index>
    dofs_in_order() const;

    void
    write_summary(const std::string &status);

    std::string used_parameters;
    Log        &log;
    Output<dim> output;
    /// What was done to the meshes: [refinement][body].
    std::vector<std::vector<std::string>> refinements;
    double       next_step         = 0.; ///< Size of the next step.
    unsigned int cut_backs_of_step = 0;
    /// The step was solved on coarser meshes: rate leads to its end.
    bool goes_again = false;
    /// See audit_energy().
    struct EnergyAudit
    {
      /// Nothing does work that is not known: no tool is moved, no fluid
      /// pushes, no treatment takes overlaps away, nothing flows.
      bool     is_possible = false;
      double   start = 0., work = 0.; ///< Energy then, work since [J].
      double   largest = 0.;          ///< Energy so far [J].
      double   growth  = 0.;          ///< Over it, largest so far [-].
      double   error   = 0.;          ///< Largest difference so far [J].
      Vector_t forces, u;             ///< At the end of the step before.

      /// What differences are measured by [J].
      double
      scale() const
      {
        return std::max(
          {largest, std::abs(work), std::numeric_limits<double>::min()});
      }
    } audit;
    std::vector<char> has_touched; ///< By interface: in some step so far.
    /// Null: not asked for.
    std::unique_ptr<ContactResolution<dim>>                     resolution;
    Timer                                                       wall;
    std::vector<std::shared_ptr<MortarContact::RigidBody<dim>>> rigid_bodies;
    std::vector<std::array<types::global_dof_index, dim>>       probe_dofs;
  };
} // namespace Structure

#endif

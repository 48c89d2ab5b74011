// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_model_h
#define mortar_contact_structure_model_h

#include "body.h"
#include "dynamics.h"
#include "loads.h"
#include "rigid_dofs.h"
#include "valve_fluid.h"

#include <mortar_contact/mortar_contact.h>

#include <deal.II/base/timer.h>

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace Structure
{
  /// Norms of the force vectors of the last assembly [N].
  struct ForceNorms
  {
    double residual = 0.; ///< Of the free dofs.
    double internal = 0., external = 0., contact = 0., inertia = 0.;
    /// Largest prescribed motion still to be done [m].
    double to_prescribe = 0.;
  };

  /**
   * All bodies, what holds and loads them, and the contact between them, with
   * one numbering of all dofs: each rank owns one contiguous range.
   *
   * Residual: internal forces - external forces - contact forces; in dynamics
   * the residual of TimeIntegration over 1 - alpha_f.
   */
  template <int dim>
  class Model
  {
  public:
    explicit Model(const MPI_Comm communicator, TimerOutput &timer);

    std::vector<std::unique_ptr<Body<dim>>> bodies;
    std::vector<BoundaryCondition>          conditions;
    std::vector<std::unique_ptr<MortarContact::ContactInterface<dim>>>
      interfaces;

    /// Rigid bodies with free motions; before number_dofs().
    std::vector<RigidDofs<dim>> rigid_dofs;

    /**
     * Forces from another program, say a fluid solver: adds to the forces on
     * owned dofs [N], with the displacements at the end of the step and its
     * time. It is asked in each Newton iteration and gives no tangent. Nodes
     * of the rank's cells and their dofs: Body::visit_nodes(). Empty: none.
     */
    std::function<
      void(const Vector_t &ghosted_u, const double time, Vector_t &forces)>
      outside_forces;

    /// A fluid, in dynamic runs; before setup(). Null: none.
    std::unique_ptr<ValveFluid<dim>> fluid;

    /// Diagonal of the box around all bodies [m].
    double
    box_diagonal() const;

    /// Number the dofs; after the bodies are there, before the interfaces.
    void
    number_dofs();

    /// Set up conditions and vectors; after everything else is there.
    /// @param with_pressures Pressures of nearly incompressible cells may be
    ///                       unknowns.
    void
    setup(const bool with_pressures);

    types::global_dof_index
    n_dofs() const
    {
      return total_dofs;
    }

    /// Whether there are shells: bodies that look at the iterate before.
    bool
    has_shells() const
    {
      return std::any_of(bodies.begin(), bodies.end(), [](const auto &b) {
        return b->uses_iterates();
      });
    }

    const IndexSet &
    owned_dofs() const
    {
      return owned;
    }

    /// A zero vector of the owned dofs.
    Vector_t
    make_vector() const;

    /**
     * Assemble residual (and tangent) at @p u, @p time.
     * @param previous Null, or the Newton iterate before, for shells: see
     *                 ShellElement::evaluate().
     * @param reset_pressures Pressures that are unknowns follow from u; else
     *                 they are what Newton's method made of them.
     * @return Why this is impossible (a cell turned inside out), or nothing.
     */
    std::string
    assemble(const Vector_t &u,
             const double    time,
             const bool      with_tangent,
             const Vector_t *previous        = nullptr,
             const bool      reset_pressures = true);

    /// Go on in dynamics from @p u and from the velocities and accelerations
    /// that the time integration has.
    void
    resume_motion(const Vector_t &u, const double time);

    /// Give hanging nodes of a field the values of what they hang on.
    void
    make_conforming(Vector_t &v) const
    {
      hanging.distribute(v);
    }

    /// Accept the state of the last assembly, at @p u, as the end of a step.
    void
    commit(const Vector_t &u);

    bool
    is_dynamic() const
    {
      return integration.parameters.is_on;
    }

    /// The energy-momentum method, see TimeIntegration.
    bool
    keeps_energy() const
    {
      return integration.parameters.keeps_energy;
    }

    /// Of the bodies at the start of the next step [J].
    double
    kinetic_energy() const;
    double
    strain_energy(const Vector_t &u) const;

    /// Sum of mass times velocity, at the start of the next step [kg m/s].
    Tensor<1, 3>
    momentum() const;

    /// Reaction of the boundary condition number @p c at the last assembly:
    /// force that it exerts on the body [N].
    Tensor<1, 3>
    reaction(const unsigned int c) const;

    /// Loads and reactions of the last assembly: what does work from outside.
    Vector_t
    outer_forces() const;

    /// Rigid body motions on the owned dofs: [mode][owned dof].
    std::vector<std::vector<double>>
    rigid_body_modes() const;

    const Body<dim> &
    body(const std::string &name) const;

    /// Values at the dofs of a local cell of @p body.
    void
    cell_values(const Body<dim>                      &body,
                const unsigned int                    cell,
                const Vector_t                       &ghosted,
                Vector<double>                       &values,
                std::vector<types::global_dof_index> &dofs) const;

    /// @p u with the values that this rank's cells need.
    Vector_t
    ghosted(const Vector_t &u) const;

    const MPI_Comm            communicator;
    TimerOutput              &timer;
    AffineConstraints<double> constraints; ///< For the next update.
    PressureUnknowns          pressures;
    Matrix_t                  matrix;
    std::function<void()>     before_new_matrix; ///< If set.
    Vector_t                  rhs; ///< Minus the residual, condensed.
    ForceNorms                norms;
    double                    size = 0.; ///< Diagonal of the scene's box [m]
    TimeIntegration           integration;
    bool                      is_symmetric = true;
    std::size_t               n_nonzero    = 0;
    unsigned int              n_patterns   = 0; ///< Of the matrix so far.
    unsigned int              n_numberings = 0; ///< Of the dofs so far.

  private:
    void
    make_constraints(const Vector_t &ghosted_u, const double time);

    void
    make_matrix();

    /// Cells in batches, and the pressures.
    void
    make_batches(const bool with_pressures);

    /// Velocities as the bodies say; accelerations from a lumped mass matrix.
    void
    start_motion();

    void
    make_loads();

    /// F of TimeIntegration at the last assembly.
    Vector_t
    static_forces() const;

    /// Forces on single nodes and on rigid bodies.
    void
    add_concentrated_loads(const double time, const bool with_tangent);

    types::global_dof_index              total_dofs = 0;
    IndexSet                             owned, relevant;
    AffineConstraints<double>            hanging, none;
    std::unique_ptr<NodeConditions<dim>> node_conditions;
    Vector_t                             internal, external, contact, inertia,
      momenta; ///< Mass times velocity.
    bool pattern_is_current = false;

    std::vector<std::unique_ptr<CellBatches<dim>>> batches; ///< By body.
    std::vector<unsigned int> first_pressure; ///< By body, of this rank's.

    std::vector<std::vector<Load<dim>>> loads; ///< By body.

    /// A force on a node.
    struct NodeLoad
    {
      std::array<types::global_dof_index, dim> dofs;
      Point<dim>                               x;
      std::vector<Expression<dim>>             formulas;
      std::array<int, dim>                     of_component; ///< -1: none.
    };
    std::vector<NodeLoad> node_loads;
  };
} // namespace Structure

#endif

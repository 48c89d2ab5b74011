// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_immersed_immersed_flow_h
#define mortar_contact_immersed_immersed_flow_h

#include "../structure/expression.h"
#include "../structure/output.h"
#include "../structure/simulation.h"
#include "coupling.h"
#include "parameters.h"

#include <deal.II/base/timer.h>

#include <deal.II/fe/mapping_q1.h>

#include <map>
#include <memory>
#include <string>

namespace Immersed
{
  /**
   * Leaflets in a channel, strongly coupled: velocities, pressures and
   * leaflets are the unknowns of one Newton method, contact of the leaflets
   * included. The leaflets' dofs come first in the matrix.
   */
  class ImmersedFlow
  {
  public:
    ImmersedFlow(const Parameters  &parameters,
                 const std::string &used_parameters,
                 Structure::Log    &log);

    void
    report_setup();

    /// Go on from the checkpoint in @p directory.
    void
    restart(const std::string &directory);

    /// All steps.
    Structure::ExitCode
    run();

    /// One step of this length from where the leaflets were located; if it
    /// fails nothing changes but what contact looked at last, see rollback().
    /// @return Why it failed; empty if not.
    std::string
    try_step(const double time_step);

    /// Place of the tip of leaflet @p l [m].
    Point<2>
    tip(const unsigned int l) const
    {
      return leaflets.place(leaflets.tip(l), leaflet.u);
    }

    /// Volume that enters at the left [m^2/s].
    double
    inflow() const;

    const Parameters                                    parameters;
    std::unique_ptr<MortarContact::ContactInterface<2>> contact;   ///< Or null.
    double                                              time = 0.; ///< [s]
    unsigned int step = 0, newton_iterations = 0, cut_backs = 0;

  private:
    /// Boundary ids of the channel.
    enum Side : types::boundary_id
    {
      left   = 0,
      right  = 1,
      bottom = 2,
      top    = 3
    };

    /// Dofs and constraints of the present mesh.
    void
    distribute();

    /// Let the mesh follow the leaflets, as located.
    void
    refine();

    /// Velocities that are given: at the inlet, on the walls, across the ends.
    std::map<types::global_dof_index, double>
    boundary_velocities(const double t);

    void
    make_pattern();

    /// Values for the history.
    std::vector<std::pair<std::string, double>>
    record(const double time_step, const unsigned int iterations) const;

    /// Save the last good state and say why there is no next one.
    Structure::ExitCode
    give_up(const std::string &reason);

    void
    write_fields();

    void
    write_summary(const std::string &status);

    void
    save() const;

    double
    coupling_penalty() const;

    const std::string         used_parameters;
    Structure::Log           &log;
    Structure::Output<2>      output;
    Structure::Expression<2>  inlet, outlet;
    const MappingQ1<2>        mapping;
    const NavierStokes        fluid;
    Triangulation<2>          mesh;
    DoFHandler<2>             dof_handler;
    Leaflets                  leaflets;
    std::unique_ptr<Coupling> coupling;

    AffineConstraints<double> hanging_nodes; ///< Of the fluid alone.
    AffineConstraints<double> constraints;   ///< Of all.
    SparsityPattern           sparsity;
    SparseMatrix<double>      matrix;
    std::vector<bool>         is_pressure; ///< By dof of the fluid.
    /// For which the pattern was made.
    std::vector<std::array<int, 3>> pattern_pairs;

    Vector<double>  flow;    ///< Velocities and pressures [m/s, Pa].
    Leaflets::State leaflet; ///< At the last step's end.
    double          last_step       = 0.; ///< [s]
    double          cell_length     = 0.; ///< Of the smallest [m].
    double          largest_force   = 0.; ///< First residual of a step.
    unsigned int    last_iterations = 0;
    double          solver_seconds = 0., assembly_seconds = 0.;
    Timer           wall;
  };
} // namespace Immersed

#endif

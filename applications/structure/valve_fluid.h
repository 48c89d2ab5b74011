// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_valve_fluid_h
#define mortar_contact_structure_valve_fluid_h

#include "body.h"
#include "lumped_fluid.h"

#include <deal.II/lac/trilinos_sparse_matrix.h>
#include <deal.II/lac/trilinos_vector.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace Structure
{
  /// A fluid around the leaflets of a scene.
  struct ValveParameters
  {
    bool               is_on = false;
    std::string        body; ///< Leaflets: cells by material id.
    types::boundary_id free_edge = 1;
    double             tube_area = 0.;
    /// How many leaflets each of the body stands for.
    double          multiplicity = 1.;
    FluidParameters fluid;
  };

  /**
   * Leaflets and the lumped fluid around them, solved together. Leaflet i has
   * its sinus on its top and the lumen below. With g_i the forces of a unit
   * pressure on its top, the fluid adds the forces (p_Si - p_L) g_i and the
   * leaflet sweeps Q_Si = (g_i(u at the middle of the step) + g_i(places that
   * are the motion d)/12) . d/dt, d = u - u_n: exactly the volume between both
   * ends of a step on straight ways, since g_i is quadratic in the places. The
   * pressures follow from the motion alone (LumpedFluid::step()), so that
   * Newton's method sees them as forces; their derivative is the sparse one of
   * g_i plus products columns[i] rows[i]^T, which couple all of a leaflet.
   */
  template <int dim>
  class ValveFluid
  {
  public:
    using Vector_t = TrilinosWrappers::MPI::Vector;

    ValveFluid(const ValveParameters &parameters, Body<dim> &body);

    /**
     * Add the fluid's forces at the end of a step to external and rhs, their
     * sparse derivative to the matrix, if there is one.
     * @param u,u_n Ghosted.
     * @param dt    Zero: pressures are those of the last accepted state.
     * @param free  No constraints.
     */
    void
    assemble(const Vector_t                  &u,
             const Vector_t                  &u_n,
             const double                     time,
             const double                     dt,
             const AffineConstraints<double> &constraints,
             const AffineConstraints<double> &free,
             TrilinosWrappers::SparseMatrix  *matrix,
             Vector_t                        &rhs,
             Vector_t                        &external);

    /// The tangent of the last assemble() is the matrix less the sum of
    /// columns[i] rows[i]^T.
    std::vector<Vector_t> columns, rows;

    /// Accept the last assemble().
    void
    commit();

    /// Names and values for the history.
    std::vector<std::pair<std::string, double>>
    record() const;

    /// Everything accepted, for checkpoints.
    std::vector<double>
    history() const;
    void
    restore(const std::vector<double> &values);

    const LumpedFluid::State &
    state() const
    {
      return now;
    }

  private:
    /// Area of the polygon of the free edges, seen along the axis, and its
    /// derivatives by the dofs of their nodes.
    double
    polygon(const Vector_t                       &u,
            std::vector<types::global_dof_index> &dofs,
            std::vector<double>                  &derivatives) const;

    /// Forces of a unit pressure on a cell, and minus their derivative.
    void
    unit_forces(const unsigned int    cell,
                const Vector<double> &u,
                const bool            with_tangent,
                Vector<double>       &forces,
                FullMatrix<double>   &tangent);

    const ValveParameters           parameters;
    Body<dim>                      &body;
    Expression<dim>                 ventricle;
    Load<dim>                       unit_pressure;
    std::vector<types::material_id> leaflets;
    std::unique_ptr<LumpedFluid>    fluid;
    /// Nodes of the free edges, in their order around the axis.
    std::vector<BoundaryNode<dim>> edge;

    LumpedFluid::State  before, now;
    LumpedFluid::Loads  loads;
    double              last_dt = 0., area = 0., orifice = 0., p_ventricle = 0.;
    std::vector<double> volumes; ///< Swept so far [m^3]
  };
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "valve_fluid.h"

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace Structure
{
  template <int dim>
  ValveFluid<dim>::ValveFluid(const ValveParameters &parameters,
                              Body<dim>             &body)
    : parameters(parameters)
    , body(body)
    , ventricle(parameters.fluid.ventricle, "Fluid/Ventricle pressure")
  {
    unit_pressure.type       = Load<dim>::Type::pressure;
    unit_pressure.on_surface = true;
    unit_pressure.formulas.emplace_back("1", "");
    unit_pressure.of_component.fill(-1);
    unit_pressure.of_component[0] = 0;

    const auto ids = body.material_ids();
    leaflets.assign(ids.begin(), ids.end());
    fluid       = std::make_unique<LumpedFluid>(parameters.fluid,
                                          parameters.tube_area,
                                          leaflets.size(),
                                          parameters.multiplicity);
    p_ventricle = ventricle.value(Point<dim>(), 0.);
    before = now = fluid->at_rest(p_ventricle);
    volumes.assign(leaflets.size(), 0.);

    // the free edges, around the axis; nodes of two edges once
    std::set<types::global_dof_index> seen;
    for (const auto &node : body.boundary_nodes({parameters.free_edge}))
      if (seen.insert(node.dofs[0]).second)
        edge.push_back(node);
    AssertThrow(edge.size() > 2,
                ExcMessage("'" + body.name +
                           "' has no free edges: boundary id " +
                           std::to_string(parameters.free_edge) +
                           "; the fluid needs them."));
    std::sort(edge.begin(), edge.end(), [](const auto &a, const auto &b) {
      const double of_a = std::atan2(a.x[1], a.x[0]),
                   of_b = std::atan2(b.x[1], b.x[0]);
      return std::tie(of_a, a.cell) < std::tie(of_b, b.cell);
    });
  }


  template <int dim>
  double
  ValveFluid<dim>::polygon(const Vector_t                       &u,
                           std::vector<types::global_dof_index> &dofs,
                           std::vector<double> &derivatives) const
  {
    // values of nodes may live on any rank: few, all ranks get all
    const IndexSet     &owned = u.locally_owned_elements();
    const std::size_t   n     = edge.size();
    std::vector<double> values(2 * n, 0.);
    for (std::size_t k = 0; k < n; ++k)
      for (unsigned int i = 0; i < 2; ++i)
        if (owned.is_element(edge[k].dofs[i]))
          values[2 * k + i] = edge[k].x[i] + u(edge[k].dofs[i]);
    Utilities::MPI::sum(values, u.get_mpi_communicator(), values);

    // one leaflet of several: its share is closed by the axis
    const bool is_open = parameters.multiplicity > 1.;
    const auto at      = [&](const std::size_t k, const unsigned int i) {
      if (k >= n && is_open)
        return 0.;
      return values[2 * (k % n) + i];
    };
    double result = 0.;
    dofs.clear();
    derivatives.clear();
    for (std::size_t k = 0; k < n; ++k)
      {
        const std::size_t next = k + 1;
        const std::size_t last = (k > 0) ? k - 1 : (is_open ? n : n - 1);
        result += 0.5 * parameters.multiplicity *
                  (at(k, 0) * at(next, 1) - at(next, 0) * at(k, 1));
        for (unsigned int i = 0; i < 2; ++i)
          {
            dofs.push_back(edge[k].dofs[i]);
            derivatives.push_back(
              0.5 * parameters.multiplicity *
              (i == 0 ? at(next, 1) - at(last, 1) : at(last, 0) - at(next, 0)));
          }
      }
    return result;
  }


  template <int dim>
  void
  ValveFluid<dim>::unit_forces(const unsigned int    cell,
                               const Vector<double> &u,
                               const bool            with_tangent,
                               Vector<double>       &forces,
                               FullMatrix<double>   &tangent)
  {
    forces.reinit(u.size());
    if (with_tangent)
      tangent.reinit(u.size(), u.size());
    body.add_load(cell, unit_pressure, u, 0., forces, tangent);
  }


  template <int dim>
  void
  ValveFluid<dim>::assemble(const Vector_t                  &u,
                            const Vector_t                  &u_n,
                            const double                     time,
                            const double                     dt,
                            const AffineConstraints<double> &constraints,
                            const AffineConstraints<double> &free,
                            TrilinosWrappers::SparseMatrix  *matrix,
                            Vector_t                        &rhs,
                            Vector_t                        &external)
  {
    const unsigned int                   n = leaflets.size();
    std::vector<types::global_dof_index> dofs;
    Vector<double>     values, motion, at, forces, row, change;
    FullMatrix<double> tangent;
    const auto         get = [&](const unsigned int cell) {
      body.dofs_of(cell, dofs);
      values.reinit(dofs.size());
      for (unsigned int a = 0; a < dofs.size(); ++a)
        values(a) = u(dofs[a]);
      return std::lower_bound(leaflets.begin(),
                              leaflets.end(),
                              body.material_of(cell)) -
             leaflets.begin();
    };

    columns.clear();
    rows.clear();
    last_dt = dt;
    if (matrix != nullptr)
      columns.assign(n,
                     Vector_t(rhs.locally_owned_elements(),
                              rhs.get_mpi_communicator()));
    // Step 1: the orifice, and what the leaflets sweep.
    std::vector<types::global_dof_index> edge_dofs;
    std::vector<double>                  by_dof;
    double                               slope = 0.;
    area                                       = polygon(u, edge_dofs, by_dof);
    orifice                                    = fluid->orifice(area, slope);
    p_ventricle = ventricle.value(Point<dim>(), time);
    if (dt > 0.)
      {
        std::vector<Vector_t> by_motion(n,
                                        Vector_t(rhs.locally_owned_elements(),
                                                 rhs.get_mpi_communicator()));
        std::vector<double>   swept(n, 0.);
        for (unsigned int cell = 0; cell < body.n_local_cells(); ++cell)
          {
            const auto i = get(cell);
            motion       = values;
            for (unsigned int a = 0; a < dofs.size(); ++a)
              motion(a) -= u_n(dofs[a]);
            row.reinit(dofs.size());
            // g at a state, which moves with u by a share of it
            const auto sweep = [&](const double share, const double weight) {
              unit_forces(cell, at, matrix != nullptr, forces, tangent);
              swept[i] += weight / dt * (forces * motion);
              if (matrix == nullptr)
                return;
              tangent.Tvmult(change, motion);
              row.add(weight / dt, forces, -share * weight / dt, change);
            };
            change.reinit(dofs.size());
            at = values;
            at.add(-0.5, motion);
            sweep(0.5, 1.);
            // what the middle misses: g of places that are the motion
            at = motion;
            for (unsigned int a = 0; a < dofs.size(); ++a)
              if (const auto place = body.place_of(cell, a);
                  place.component < dim)
                at(a) -= place.x[place.component];
            sweep(1., 1. / 12.);
            if (matrix != nullptr)
              constraints.distribute_local_to_global(row, dofs, by_motion[i]);
          }
        Utilities::MPI::sum(swept, rhs.get_mpi_communicator(), swept);
        now = fluid->step(before, dt, p_ventricle, swept, orifice, loads);
        if (matrix != nullptr)
          {
            Vector_t by_edge(rhs.locally_owned_elements(),
                             rhs.get_mpi_communicator());
            dofs.clear();
            std::vector<double> mine;
            for (std::size_t k = 0; k < edge_dofs.size(); ++k)
              if (rhs.locally_owned_elements().is_element(edge_dofs[k]))
                {
                  dofs.push_back(edge_dofs[k]);
                  mine.push_back(slope * by_dof[k]);
                }
            row.reinit(mine.size());
            std::copy(mine.begin(), mine.end(), row.begin());
            constraints.distribute_local_to_global(row, dofs, by_edge);
            by_edge.compress(VectorOperation::add);
            for (Vector_t &v : by_motion)
              v.compress(VectorOperation::add);
            for (unsigned int i = 0; i < n; ++i)
              {
                rows.push_back(by_edge);
                rows[i] *= loads.by_area[i];
                for (unsigned int j = 0; j < n; ++j)
                  rows[i].add(loads.by_swept(i, j), by_motion[j]);
              }
          }
      }
    else
      {
        now = before;
        loads.values.resize(n);
        for (unsigned int i = 0; i < n; ++i)
          loads.values[i] = now.sinuses[i] - now.lumen;
      }

    // Step 2: the pressures on the leaflets.
    for (unsigned int cell = 0; cell < body.n_local_cells(); ++cell)
      {
        const auto i = get(cell);
        unit_forces(cell, values, matrix != nullptr, forces, tangent);
        if (matrix != nullptr)
          {
            constraints.distribute_local_to_global(forces, dofs, columns[i]);
            forces *= loads.values[i];
            tangent *= loads.values[i];
            constraints.distribute_local_to_global(
              tangent, forces, dofs, *matrix, rhs);
          }
        else
          {
            forces *= loads.values[i];
            constraints.distribute_local_to_global(forces, dofs, rhs);
          }
        free.distribute_local_to_global(forces, dofs, external);
      }
    for (Vector_t &v : columns)
      v.compress(VectorOperation::add);
    if (dt == 0.)
      columns.clear();
  }


  template <int dim>
  void
  ValveFluid<dim>::commit()
  {
    for (std::size_t i = 0; i < volumes.size(); ++i)
      volumes[i] += last_dt * now.swept[i];
    before = now;
  }


  template <int dim>
  std::vector<std::pair<std::string, double>>
  ValveFluid<dim>::record() const
  {
    std::vector<std::pair<std::string, double>> row = {
      {"fluid:ventricle_pressure", p_ventricle},
      {"fluid:lumen_pressure", now.lumen},
      {"fluid:aortic_pressure", now.aorta},
      {"fluid:jet", now.jet},
      {"fluid:aortic_flow", now.inlet},
      {"fluid:edge_area", area},
      {"fluid:orifice_area", orifice}};
    double lumen = 0.;
    for (std::size_t i = 0; i < volumes.size(); ++i)
      {
        const std::string name = "fluid:sinus_" + std::to_string(i + 1) + "_";
        row.emplace_back(name + "pressure", now.sinuses[i]);
        row.emplace_back(name + "volume_change", volumes[i]);
        lumen -= parameters.multiplicity * volumes[i];
      }
    row.emplace_back("fluid:lumen_volume_change", lumen);
    return row;
  }


  template <int dim>
  std::vector<double>
  ValveFluid<dim>::history() const
  {
    std::vector<double> values = {
      before.jet, before.inlet, before.lumen, before.aorta, before.compliance};
    for (const auto *v : {&before.swept, &before.sinuses, &volumes})
      values.insert(values.end(), v->begin(), v->end());
    return values;
  }


  template <int dim>
  void
  ValveFluid<dim>::restore(const std::vector<double> &values)
  {
    const std::size_t n = leaflets.size();
    AssertThrow(values.size() == 5 + 3 * n,
                ExcMessage("The saved state has another fluid."));
    before.jet        = values[0];
    before.inlet      = values[1];
    before.lumen      = values[2];
    before.aorta      = values[3];
    before.compliance = values[4];
    const auto begin  = values.begin() + 5;
    before.swept.assign(begin, begin + n);
    before.sinuses.assign(begin + n, begin + 2 * n);
    volumes.assign(begin + 2 * n, begin + 3 * n);
    now = before;
  }


  template class ValveFluid<2>;
  template class ValveFluid<3>;
} // namespace Structure

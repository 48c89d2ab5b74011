// SPDX-License-Identifier: LGPL-2.1-or-later
#include "model.h"

#include "return_memory.h"

#include <deal.II/base/mpi.h>

#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparsity_tools.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace Structure
{
  template <int dim>
  Model<dim>::Model(const MPI_Comm communicator, TimerOutput &timer)
    : communicator(communicator)
    , timer(timer)
  {}


  template <int dim>
  const Body<dim> &
  Model<dim>::body(const std::string &name) const
  {
    for (const auto &b : bodies)
      if (b->name == name)
        return *b;
    AssertThrow(false, ExcMessage("There is no body called '" + name + "'."));
    return *bodies.front();
  }


  template <int dim>
  void
  Model<dim>::number_dofs()
  {
    ++n_numberings;
    // Rank after rank, body after body: contiguous ranges for each rank.
    const unsigned int rank    = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    std::vector<std::vector<types::global_dof_index>> counts; // [body][rank]
    total_dofs = 0;
    for (const auto &b : bodies)
      {
        counts.push_back(
          Utilities::MPI::all_gather(communicator, b->n_owned_dofs()));
        total_dofs += b->n_dofs();
      }

    owned.clear();
    owned.set_size(total_dofs + rigid_dofs.size() * RigidDofs<dim>::n);
    std::vector<std::vector<types::global_dof_index>> firsts(bodies.size()),
      targets(bodies.size());
    std::vector<types::global_dof_index> next(bodies.size(), 0);
    types::global_dof_index              target = 0;
    for (unsigned int r = 0; r < n_ranks; ++r)
      {
        const types::global_dof_index begin = target;
        for (unsigned int b = 0; b < bodies.size(); ++b)
          {
            firsts[b].push_back(next[b]);
            targets[b].push_back(target);
            next[b] += counts[b][r];
            target += counts[b][r];
          }
        // the last rank keeps the rigid bodies
        if (r + 1 == n_ranks)
          for (RigidDofs<dim> &rigid : rigid_dofs)
            {
              rigid.set_first(target);
              target += RigidDofs<dim>::n;
              total_dofs += RigidDofs<dim>::n;
            }
        if (r == rank)
          owned.add_range(begin, target);
      }
    owned.compress();

    relevant = owned;
    std::vector<types::global_dof_index> dofs;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        bodies[b]->numbering =
          MortarContact::DoFNumbering(firsts[b], targets[b]);
        for (unsigned int c = 0; c < bodies[b]->n_local_cells(); ++c)
          {
            bodies[b]->dofs_of(c, dofs);
            relevant.add_indices(dofs.begin(), dofs.end());
          }
      }
    relevant.compress();
  }


  template <int dim>
  void
  Model<dim>::setup(const bool with_pressures)
  {
    // Step 1: hanging nodes, in the model's numbering. Every rank knows the
    // whole mesh where there are any, so it knows all lines.
    IndexSet all(total_dofs);
    all.add_range(0, total_dofs);
    hanging = MortarContact::Compat::make_constraints(owned, all);
    none    = MortarContact::Compat::make_constraints(owned, all);
    none.close();
    for (const auto &b : bodies)
      {
        AffineConstraints<double> local;
        b->add_constraints(local);
        for (const auto &line : local.get_lines())
          {
            const auto dof = b->numbering(line.index);
            hanging.add_line(dof);
            for (const auto &[other, weight] : line.entries)
              hanging.add_entry(dof, b->numbering(other), weight);
          }
      }
    hanging.close();

    // Step 2: conditions and loads.
    node_conditions = std::make_unique<NodeConditions<dim>>(bodies, conditions);
    make_loads();
    for (const auto &interface : interfaces)
      is_symmetric = is_symmetric && interface->parameters.symmetric_tangent;

    // Step 3: vectors, and the size of the scene.
    rhs      = make_vector();
    internal = make_vector();
    external = make_vector();
    contact  = make_vector();
    inertia  = make_vector();
    momenta  = make_vector();
    size     = box_diagonal();
    make_batches(with_pressures);
    pattern_is_current = false;
    if (is_dynamic())
      start_motion();
  }


  template <int dim>
  void
  Model<dim>::make_batches(const bool with_pressures)
  {
    unsigned int n_pressures = 0;
    batches.clear();
    first_pressure.clear();
    for (const auto &b : bodies)
      {
        batches.push_back(is_dynamic() ? nullptr :
                                         b->make_batches(owned, relevant));
        first_pressure.push_back(n_pressures);
        if (batches.back())
          n_pressures += batches.back()->n_pressures();
      }
    const auto of_ranks = Utilities::MPI::all_gather(communicator, n_pressures);
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int begin =
      std::accumulate(of_ranks.begin(), of_ranks.begin() + rank, 0u);
    const unsigned int total =
      std::accumulate(of_ranks.begin(), of_ranks.end(), 0u);
    pressures.are_on = with_pressures && total > 0;
    if (!pressures.are_on)
      return;
    pressures.owned.clear();
    pressures.owned.set_size(total);
    pressures.owned.add_range(begin, begin + n_pressures);
    for (Vector_t *v : {&pressures.value,
                        &pressures.residual,
                        &pressures.prescribed,
                        &pressures.compliance,
                        &pressures.schur,
                        &pressures.in_matrix,
                        &pressures.scale,
                        &pressures.update})
      v->reinit(pressures.owned, communicator);
  }


  template <int dim>
  void
  Model<dim>::make_loads()
  {
    using Type   = typename Load<dim>::Type;
    is_symmetric = !keeps_energy();
    loads.clear();
    loads.resize(bodies.size());
    node_loads.clear();
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        if (bodies[b]->body_force.empty())
          continue;
        const std::string entry = "Bodies/" + bodies[b]->name + "/Body force";
        const std::vector<std::string> components =
          Utilities::split_string_list(bodies[b]->body_force, ";");
        AssertThrow(components.size() == dim,
                    ExcMessage("'" + entry + "' has " +
                               std::to_string(components.size()) +
                               " components; expected " + std::to_string(dim) +
                               ", separated by semicolons."));
        Load<dim> load;
        load.type = Type::body_force;
        for (unsigned int i = 0; i < dim; ++i)
          {
            load.of_component[i] = i;
            load.formulas.emplace_back(components[i], entry);
          }
        loads[b].push_back(std::move(load));
      }
    for (const BoundaryCondition &c : conditions)
      {
        using ConditionType    = BoundaryCondition::Type;
        const bool is_pressure = c.type == ConditionType::pressure;
        const bool is_moment   = c.type == ConditionType::moment;
        if (!is_pressure && !is_moment && c.type != ConditionType::traction)
          continue;
        std::vector<Expression<dim>> formulas;
        std::array<int, dim>         of_component;
        of_component.fill(-1);
        for (unsigned int i = 0; i < (is_pressure ? 1 : dim); ++i)
          if (c.values[i] != "free")
            {
              of_component[i] = formulas.size();
              formulas.emplace_back(c.values[i],
                                    "Boundary conditions/" + c.name);
            }
        const Body<dim> &of = body(c.body);
        if (!c.point.empty())
          {
            const BoundaryNode<dim> node =
              of.nearest_node(point_of<dim>(c.point));
            node_loads.push_back(
              {node.dofs, node.x, std::move(formulas), of_component});
            continue;
          }
        if ((is_pressure && !of.is_linear()) || is_moment)
          is_symmetric = false;
        Load<dim> load;
        load.type         = is_pressure ? Type::pressure :
                            is_moment   ? Type::moment :
                                          Type::traction;
        load.boundaries   = c.boundaries;
        load.on_surface   = c.on_surface;
        load.formulas     = std::move(formulas);
        load.of_component = of_component;
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (bodies[b].get() == &of)
            loads[b].push_back(std::move(load));
      }
  }


  template <int dim>
  double
  Model<dim>::box_diagonal() const
  {
    if (bodies.empty())
      return 0.;
    auto [low, high] = bodies.front()->box();
    for (const auto &b : bodies)
      for (unsigned int i = 0; i < dim; ++i)
        {
          low[i]  = std::min(low[i], b->box().first[i]);
          high[i] = std::max(high[i], b->box().second[i]);
        }
    return low.distance(high);
  }


  template <int dim>
  Vector_t
  Model<dim>::make_vector() const
  {
    return Vector_t(owned, communicator);
  }


  template <int dim>
  Vector_t
  Model<dim>::ghosted(const Vector_t &u) const
  {
    Vector_t result(owned, relevant, communicator);
    result = u;
    return result;
  }


  template <int dim>
  void
  Model<dim>::cell_values(const Body<dim>                      &body,
                          const unsigned int                    cell,
                          const Vector_t                       &ghosted,
                          Vector<double>                       &values,
                          std::vector<types::global_dof_index> &dofs) const
  {
    body.dofs_of(cell, dofs);
    values.reinit(dofs.size());
    for (unsigned int a = 0; a < dofs.size(); ++a)
      values(a) = ghosted(dofs[a]);
  }


  template <int dim>
  void
  Model<dim>::make_constraints(const Vector_t &u, const double time)
  {
    // Prescribed values need the present displacement of their nodes, which may
    // live on any rank: small, so all ranks get all of them.
    constraints =
      MortarContact::Compat::make_constraints(owned,
                                              complete_index_set(total_dofs));
    constraints.merge(hanging, AffineConstraints<double>::left_object_wins);
    std::vector<types::global_dof_index> prescribed;
    node_conditions->add_dofs(prescribed);
    for (const RigidDofs<dim> &rigid : rigid_dofs)
      for (unsigned int i = 0; i < RigidDofs<dim>::n; ++i)
        prescribed.push_back(rigid.first() + i);
    std::sort(prescribed.begin(), prescribed.end());
    prescribed.erase(std::unique(prescribed.begin(), prescribed.end()),
                     prescribed.end());
    std::vector<double> values(prescribed.size(), 0.);
    for (std::size_t i = 0; i < prescribed.size(); ++i)
      if (owned.is_element(prescribed[i]))
        values[i] = u(prescribed[i]);
    Utilities::MPI::sum(values, communicator, values);
    node_conditions->add_lines(
      [&](const types::global_dof_index dof) {
        return values[std::lower_bound(
                        prescribed.begin(), prescribed.end(), dof) -
                      prescribed.begin()];
      },
      time,
      constraints);
    for (RigidDofs<dim> &rigid : rigid_dofs)
      for (unsigned int i = 0; i < RigidDofs<dim>::n; ++i)
        if (!rigid.is_free(i))
          {
            const auto dof = rigid.first() + i;
            constraints.add_line(dof);
            constraints.set_inhomogeneity(
              dof,
              rigid.prescribed(i, time) -
                values[std::lower_bound(
                         prescribed.begin(), prescribed.end(), dof) -
                       prescribed.begin()]);
          }
    norms.to_prescribe = 0.;
    for (const auto &line : constraints.get_lines())
      norms.to_prescribe =
        std::max(norms.to_prescribe, std::abs(line.inhomogeneity));
    constraints.close();
  }


  template <int dim>
  void
  Model<dim>::make_matrix()
  {
    TimerOutput::Scope scope(timer, "matrix pattern");
    // never the old matrix and the new pattern at once
    if (before_new_matrix)
      before_new_matrix();
    matrix.clear();
    pressures.derivative.clear();
    return_memory();
    std::vector<types::global_dof_index> dofs;
    {
      DynamicSparsityPattern dsp(total_dofs, total_dofs);
      for (const auto &b : bodies)
        for (unsigned int c = 0; c < b->n_local_cells(); ++c)
          {
            b->dofs_of(c, dofs);
            constraints.add_entries_local_to_global(dofs, dsp, false);
          }
      for (const RigidDofs<dim> &rigid : rigid_dofs)
        if (owned.is_element(rigid.first()))
          {
            dofs.resize(RigidDofs<dim>::n);
            std::iota(dofs.begin(), dofs.end(), rigid.first());
            constraints.add_entries_local_to_global(dofs, dsp, false);
          }
      for (const auto &interface : interfaces)
        // a new multigrid is dearer than some entries more
        interface->add_couplings(dsp, constraints, pressures.are_on ? 1. : 0.);
      SparsityTools::distribute_sparsity_pattern(
        dsp, owned, communicator, complete_index_set(total_dofs));
      matrix.reinit(owned, owned, dsp, communicator);
    }
    return_memory();
    n_nonzero = matrix.n_nonzero_elements();
    ++n_patterns;
    for (const auto &batch : batches)
      if (batch)
        batch->set_matrix(matrix, constraints);
    if (pressures.are_on)
      {
        DynamicSparsityPattern rows(pressures.owned.size(),
                                    total_dofs,
                                    pressures.owned);
        for (unsigned int b = 0; b < bodies.size(); ++b)
          if (batches[b] && batches[b]->n_pressures() > 0)
            batches[b]->add_couplings(pressures.owned.nth_index_in_set(
                                        first_pressure[b]),
                                      constraints,
                                      rows);
        pressures.derivative.reinit(pressures.owned, owned, rows, communicator);
      }
    pattern_is_current = true;
  }


  template <int dim>
  void
  Model<dim>::add_concentrated_loads(const double time, const bool with_tangent)
  {
    for (NodeLoad &load : node_loads)
      if (owned.is_element(load.dofs[0]))
        {
          Vector<double>                       force(dim);
          std::vector<types::global_dof_index> dofs(load.dofs.begin(),
                                                    load.dofs.end());
          for (unsigned int i = 0; i < dim; ++i)
            if (load.of_component[i] >= 0)
              force(i) =
                load.formulas[load.of_component[i]].value(load.x, time);
          none.distribute_local_to_global(force, dofs, external);
          constraints.distribute_local_to_global(force, dofs, rhs);
        }
    for (RigidDofs<dim> &rigid : rigid_dofs)
      if (owned.is_element(rigid.first()))
        {
          constexpr unsigned int               n = RigidDofs<dim>::n;
          Vector<double>                       load(n);
          std::vector<types::global_dof_index> dofs(n);
          std::iota(dofs.begin(), dofs.end(), rigid.first());
          for (unsigned int i = 0; i < n; ++i)
            load(i) = rigid.load(i, time);
          none.distribute_local_to_global(load, dofs, external);
          if (with_tangent)
            {
              // motions that are not free need entries on the diagonal
              FullMatrix<double> diagonal(n, n);
              for (unsigned int i = 0; i < n; ++i)
                diagonal(i, i) = rigid.is_free(i) ? 0. : 1.;
              constraints.distribute_local_to_global(
                diagonal, load, dofs, matrix, rhs);
            }
          else
            constraints.distribute_local_to_global(load, dofs, rhs);
        }
  }


  template <int dim>
  std::string
  Model<dim>::assemble(const Vector_t &u,
                       const double    time,
                       const bool      with_tangent,
                       const Vector_t *previous,
                       const bool      reset_pressures)
  {
    const Vector_t u_ghosted = ghosted(u);
    const Vector_t previous_ghosted =
      previous ? ghosted(*previous) : Vector_t();
    make_constraints(u, time);

    // accelerations and velocities, and the means over the step
    const bool dynamic   = is_dynamic() && integration.dt > 0.;
    const bool over_step = dynamic && keeps_energy();
    Vector_t   a_end, v_end, a_mean, v_mean, u_n;
    if (over_step)
      u_n = ghosted(integration.u_n);
    if (dynamic)
      {
        Vector_t a = make_vector(), v = make_vector();
        integration.rates(u, a, v);
        a_end = ghosted(a);
        v_end = ghosted(v);
        a.sadd(1. - integration.alpha_m, integration.alpha_m, integration.a_n);
        v.sadd(1. - integration.alpha_f, integration.alpha_f, integration.v_n);
        a_mean = ghosted(a);
        v_mean = ghosted(v);
      }
    const double per_share = 1. / (1. - integration.alpha_f);

    // Step 1: contact first: it may need entries in the matrix.
    bool couplings_changed = false;
    {
      TimerOutput::Scope scope(timer, "contact: search and evaluation");
      for (const auto &interface : interfaces)
        {
          interface->update(u, time, with_tangent);
          couplings_changed =
            couplings_changed || interface->report().couplings_changed;
        }
    }
    if (with_tangent)
      {
        if (couplings_changed || !pattern_is_current)
          make_matrix();
        matrix = 0.;
      }
    rhs      = 0.;
    internal = 0.;
    external = 0.;
    contact  = 0.;
    inertia  = 0.;
    momenta  = 0.;

    // Step 2: cells.
    std::string failure;
    {
      TimerOutput::Scope                   scope(timer, "assembly: cells");
      std::vector<types::global_dof_index> dofs;
      Vector<double> values, before, start, forces, loaded, at_rest, ignored;
      FullMatrix<double> tangent, mass, damping, stiffness;
      for (unsigned int i = 0; i < bodies.size(); ++i)
        {
          Body<dim>   &b = *bodies[i];
          unsigned int n = 0;
          if (batches[i])
            {
              failure = batches[i]->assemble(
                u_ghosted,
                {constraints, with_tangent ? &matrix : nullptr, rhs, internal},
                pressures,
                first_pressure[i],
                reset_pressures);
              if (!failure.empty())
                break;
              if (loads[i].empty())
                continue;
            }
          for (unsigned int cell = 0; cell < b.n_local_cells(); ++cell)
            {
              if (previous != nullptr)
                cell_values(b, cell, previous_ghosted, before, dofs);
              cell_values(b, cell, u_ghosted, values, dofs);
              if (cell == 0 || dofs.size() != n)
                {
                  n = dofs.size();
                  if (dynamic)
                    {
                      mass.reinit(n, n);
                      stiffness.reinit(n, n);
                      at_rest.reinit(n);
                      ignored.reinit(n);
                    }
                  forces.reinit(n);
                  loaded.reinit(n);
                  if (with_tangent)
                    tangent.reinit(n, n);
                }
              // K_0 first: a body remembers the last evaluation of a cell
              if (dynamic && integration.parameters.stiffness_damping > 0.)
                {
                  at_rest = 0.;
                  b.evaluate(cell, at_rest, nullptr, true, ignored, stiffness);
                }
              if (batches[i]) // has them already; loads follow
                {
                  forces = 0.;
                  if (with_tangent)
                    tangent = 0.;
                }
              else if (!b.evaluate(cell,
                                   values,
                                   previous ? &before : nullptr,
                                   with_tangent && !over_step,
                                   forces,
                                   tangent))
                {
                  failure = b.name_of(cell) + " turned inside out";
                  break;
                }
              none.distribute_local_to_global(forces, dofs, internal);
              if (over_step)
                {
                  cell_values(b, cell, u_n, start, dofs);
                  b.evaluate_step(cell,
                                  start,
                                  values,
                                  previous ? &before : nullptr,
                                  with_tangent,
                                  forces,
                                  tangent);
                  forces *= per_share;
                  if (with_tangent)
                    tangent *= per_share;
                }
              if (!loads[i].empty())
                {
                  loaded = 0.;
                  for (Load<dim> &load : loads[i])
                    b.add_load(cell, load, values, time, loaded, tangent);
                  if (batches[i] && loaded.all_zero())
                    continue;
                  none.distribute_local_to_global(loaded, dofs, external);
                  forces -= loaded;
                }
              if (dynamic)
                {
                  // M and C = alpha M + beta K_0
                  const auto &d = integration.parameters;
                  b.mass(cell, mass);
                  damping = mass;
                  damping *= d.mass_damping;
                  if (d.stiffness_damping > 0.)
                    damping.add(d.stiffness_damping, stiffness);
                  const auto add_inertia = [&](const Vector_t &a,
                                               const Vector_t &v,
                                               const double    factor,
                                               Vector<double> &f) {
                    for (unsigned int k = 0; k < n; ++k)
                      for (unsigned int l = 0; l < n; ++l)
                        f(k) += factor * (mass(k, l) * a(dofs[l]) +
                                          damping(k, l) * v(dofs[l]));
                  };
                  add_inertia(a_mean, v_mean, per_share, forces);
                  loaded = 0.;
                  add_inertia(a_end, v_end, 1., loaded);
                  none.distribute_local_to_global(loaded, dofs, inertia);
                  for (unsigned int k = 0; k < n; ++k)
                    {
                      loaded(k) = 0.;
                      for (unsigned int l = 0; l < n; ++l)
                        loaded(k) += mass(k, l) * v_end(dofs[l]);
                    }
                  none.distribute_local_to_global(loaded, dofs, momenta);
                  if (with_tangent)
                    {
                      tangent.add(per_share * (1. - integration.alpha_m) *
                                    integration.a_u,
                                  mass);
                      tangent.add(integration.v_u, damping);
                    }
                }
              forces *= -1.;
              if (with_tangent)
                constraints.distribute_local_to_global(
                  tangent, forces, dofs, matrix, rhs);
              else
                constraints.distribute_local_to_global(forces, dofs, rhs);
            }
        }
    }
    for (const std::string &f :
         Utilities::MPI::all_gather(communicator, failure))
      if (!f.empty())
        failure = f;

    add_concentrated_loads(time, with_tangent);
    if (outside_forces)
      {
        Vector_t forces = make_vector();
        outside_forces(u_ghosted, time, forces);
        forces.compress(VectorOperation::add);
        std::vector<types::global_dof_index> dofs;
        owned.fill_index_vector(dofs);
        Vector<double> values(dofs.size());
        for (std::size_t k = 0; k < dofs.size(); ++k)
          values(k) = forces(dofs[k]);
        none.distribute_local_to_global(values, dofs, external);
        constraints.distribute_local_to_global(values, dofs, rhs);
      }
    if (fluid)
      {
        TimerOutput::Scope scope(timer, "assembly: fluid");
        fluid->assemble(u_ghosted,
                        ghosted(integration.u_n),
                        time,
                        dynamic ? integration.dt : 0.,
                        constraints,
                        none,
                        with_tangent ? &matrix : nullptr,
                        rhs,
                        external);
      }

    // Step 3: contact.
    {
      TimerOutput::Scope scope(timer, "contact: assembly");
      for (const auto &interface : interfaces)
        {
          if (with_tangent)
            interface->assemble(matrix, rhs, constraints);
          else
            interface->assemble(rhs, constraints);
          interface->assemble(contact, none);
        }
    }
    if (dynamic)
      {
        // the static forces at the start of the step
        std::vector<types::global_dof_index> dofs;
        Vector<double>                       before(owned.n_elements());
        for (const auto i : owned)
          {
            before(dofs.size()) =
              -per_share * integration.alpha_f * integration.F_n(i);
            dofs.push_back(i);
          }
        constraints.distribute_local_to_global(before, dofs, rhs);
      }
    if (with_tangent)
      matrix.compress(VectorOperation::add);
    for (Vector_t *v :
         {&rhs, &internal, &external, &contact, &inertia, &momenta})
      v->compress(VectorOperation::add);
    // forces that would stop the bodies within the step: a scale in free flight
    norms.inertia  = dynamic ? std::max(inertia.l2_norm(),
                                       momenta.l2_norm() / integration.dt) :
                               0.;
    norms.residual = rhs.l2_norm();
    if (pressures.are_on)
      {
        if (with_tangent)
          pressures.derivative.compress(VectorOperation::insert);
        Vector_t as_forces = pressures.residual;
        as_forces.scale(pressures.scale);
        norms.residual = std::hypot(norms.residual, as_forces.l2_norm());
      }
    norms.internal = internal.l2_norm();
    norms.external = external.l2_norm();
    norms.contact  = contact.l2_norm();
    return failure;
  }


  template <int dim>
  void
  Model<dim>::start_motion()
  {
    for (Vector_t *v : {&integration.u_n,
                        &integration.v_n,
                        &integration.a_n,
                        &integration.F_n})
      *v = make_vector();

    // Step 1: velocities at the nodes.
    std::vector<types::global_dof_index> dofs;
    Vector_t                             lumped = make_vector();
    for (const auto &b : bodies)
      {
        std::vector<Expression<dim>> formulas;
        const std::string entry = "Bodies/" + b->name + "/Initial velocity";
        if (!b->initial_velocity.empty())
          for (const std::string &text :
               Utilities::split_string_list(b->initial_velocity, ";"))
            formulas.emplace_back(text, entry);
        AssertThrow(formulas.empty() || formulas.size() == dim,
                    ExcMessage("'" + entry + "' has " +
                               std::to_string(formulas.size()) +
                               " components; expected " + std::to_string(dim) +
                               ", separated by semicolons."));
        for (unsigned int cell = 0; cell < b->n_local_cells(); ++cell)
          {
            b->dofs_of(cell, dofs);
            const unsigned int n = dofs.size();
            FullMatrix<double> mass(n, n);
            Vector<double>     diagonal(n);
            b->mass(cell, mass);
            // the masses of displacements and directors, dealt by the diagonal
            double total[2] = {0., 0.}, trace[2] = {0., 0.};
            for (unsigned int k = 0; k < n; ++k)
              {
                const unsigned int kind = b->component_of(k) < dim ? 0 : 1;
                trace[kind] += mass(k, k);
                for (unsigned int l = 0; l < n; ++l)
                  total[kind] += mass(k, l);
                if (!formulas.empty() && kind == 0 && owned.is_element(dofs[k]))
                  integration.v_n(dofs[k]) =
                    formulas[b->component_of(k)].value(b->place_of(cell, k).x,
                                                       0.);
              }
            for (unsigned int k = 0; k < n; ++k)
              {
                const unsigned int kind = b->component_of(k) < dim ? 0 : 1;
                diagonal(k) = mass(k, k) * total[kind] / trace[kind];
              }
            none.distribute_local_to_global(diagonal, dofs, lumped);
          }
      }
    lumped.compress(VectorOperation::add);
    integration.v_n.compress(VectorOperation::insert);

    // Step 2: forces, hence accelerations of what is free to move.
    integration.dt            = 0.;
    const std::string failure = assemble(integration.u_n, 0., false);
    AssertThrow(failure.empty(), ExcMessage(failure));
    integration.F_n = static_forces();
    for (const auto i : owned)
      integration.a_n(i) =
        constraints.is_constrained(i) ? 0. : -integration.F_n(i) / lumped(i);
    integration.a_n.compress(VectorOperation::insert);
  }


  template <int dim>
  Vector_t
  Model<dim>::static_forces() const
  {
    Vector_t F = make_vector();
    if (!keeps_energy())
      F = internal;
    F -= external;
    F -= contact;
    return F;
  }


  template <int dim>
  void
  Model<dim>::resume_motion(const Vector_t &u, const double time)
  {
    integration.u_n           = u;
    integration.dt            = 0.;
    const std::string failure = assemble(u, time, false);
    AssertThrow(failure.empty(), ExcMessage(failure));
    integration.F_n = static_forces();
  }


  template <int dim>
  void
  Model<dim>::commit(const Vector_t &u)
  {
    for (const auto &b : bodies)
      b->commit();
    if (fluid)
      fluid->commit();
    if (is_dynamic())
      integration.commit(u, static_forces());
  }


  template <int dim>
  double
  Model<dim>::kinetic_energy() const
  {
    const Vector_t                       v      = ghosted(integration.v_n);
    double                               energy = 0.;
    std::vector<types::global_dof_index> dofs;
    for (const auto &b : bodies)
      {
        FullMatrix<double> mass;
        Vector<double>     values;
        for (unsigned int cell = 0; cell < b->n_local_cells(); ++cell)
          {
            cell_values(*b, cell, v, values, dofs);
            mass.reinit(dofs.size(), dofs.size());
            b->mass(cell, mass);
            energy += 0.5 * mass.matrix_norm_square(values);
          }
      }
    return Utilities::MPI::sum(energy, communicator);
  }


  template <int dim>
  Tensor<1, 3>
  Model<dim>::momentum() const
  {
    const Vector_t                       v = ghosted(integration.v_n);
    std::vector<double>                  sum(3, 0.);
    std::vector<types::global_dof_index> dofs;
    for (const auto &b : bodies)
      {
        FullMatrix<double> mass;
        Vector<double>     values, of_cell;
        for (unsigned int cell = 0; cell < b->n_local_cells(); ++cell)
          {
            cell_values(*b, cell, v, values, dofs);
            const unsigned int n = dofs.size();
            mass.reinit(n, n);
            of_cell.reinit(n);
            b->mass(cell, mass);
            mass.vmult(of_cell, values);
            for (unsigned int k = 0; k < n; ++k)
              {
                const unsigned int c = b->component_of(k);
                if (c < dim)
                  sum[c] += of_cell(k);
              }
          }
      }
    Utilities::MPI::sum(sum, communicator, sum);
    return Tensor<1, 3>({sum[0], sum[1], sum[2]});
  }


  template <int dim>
  double
  Model<dim>::strain_energy(const Vector_t &u) const
  {
    const Vector_t                       u_ghosted = ghosted(u);
    double                               energy    = 0.;
    std::vector<types::global_dof_index> dofs;
    Vector<double>                       values;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (batches[b])
        energy += batches[b]->energy(u_ghosted);
      else
        for (unsigned int cell = 0; cell < bodies[b]->n_local_cells(); ++cell)
          {
            cell_values(*bodies[b], cell, u_ghosted, values, dofs);
            energy += bodies[b]->energy(cell, values);
          }
    return Utilities::MPI::sum(energy, communicator);
  }


  template <int dim>
  Tensor<1, 3>
  Model<dim>::reaction(const unsigned int c) const
  {
    std::vector<double> sum(3, 0.);
    for (const auto &[dof, component] : node_conditions->dofs_of(c))
      if (owned.is_element(dof))
        sum[component] +=
          internal(dof) - external(dof) - contact(dof) + inertia(dof);
    Utilities::MPI::sum(sum, communicator, sum);
    return Tensor<1, 3>({sum[0], sum[1], sum[2]});
  }


  template <int dim>
  Vector_t
  Model<dim>::outer_forces() const
  {
    Vector_t forces = external;
    for (unsigned int c = 0; c < conditions.size(); ++c)
      for (const auto &entry : node_conditions->dofs_of(c))
        if (owned.is_element(entry.first))
          {
            const auto i = entry.first;
            forces(i)    = internal(i) - contact(i) + inertia(i);
          }
    forces.compress(VectorOperation::insert);
    return forces;
  }


  template <int dim>
  std::vector<std::vector<double>>
  Model<dim>::rigid_body_modes() const
  {
    constexpr unsigned int           n_modes = (dim == 2) ? 3 : 6;
    std::vector<std::vector<double>> modes(
      n_modes, std::vector<double>(owned.n_elements(), 0.));
    std::vector<types::global_dof_index> dofs;
    for (const auto &b : bodies)
      {
        for (unsigned int cell = 0; cell < b->n_local_cells(); ++cell)
          {
            b->dofs_of(cell, dofs);
            for (unsigned int a = 0; a < dofs.size(); ++a)
              {
                if (!owned.is_element(dofs[a]))
                  continue;
                const auto           i     = owned.index_within_set(dofs[a]);
                const DoFPlace<dim>  place = b->place_of(cell, a);
                const unsigned int   c     = place.component % dim;
                const Tensor<1, dim> x     = place.arm;
                if (place.component < dim)
                  modes[c][i] = 1.;
                if constexpr (dim == 2)
                  modes[2][i] = (c == 0) ? -x[1] : x[0];
                else
                  for (unsigned int r = 0; r < 3; ++r)
                    // rotation about axis r: e_r x x
                    if (c == (r + 1) % 3)
                      modes[3 + r][i] = -x[(r + 2) % 3];
                    else if (c == (r + 2) % 3)
                      modes[3 + r][i] = x[(r + 1) % 3];
              }
          }
      }
    return modes;
  }


  template class Model<2>;
  template class Model<3>;
} // namespace Structure

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "refinement.h"

#include "numbers_of.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/patterns.h>
#include <deal.II/base/utilities.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace Structure
{
  void
  RefinementParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Every",
                      "0",
                      Patterns::Integer(0),
                      "Steps after which solids of hexahedra (quadrilaterals) "
                      "are refined where their error is largest, and the step "
                      "is done again; 0: never [-]. Give the contact a "
                      "'Characteristic length': that of the cells would change "
                      "its stiffness from facet to facet.");
    prm.declare_entry("Times",
                      "",
                      Patterns::List(Patterns::Double(0.)),
                      "The same at these times [time].");
    prm.declare_entry("Cycles",
                      "1",
                      Patterns::Integer(1),
                      "Refinements of a step [-].");
    prm.declare_entry("Refine",
                      "0.5",
                      Patterns::Double(0., 1.),
                      "Share of the squared error that the cells to be refined "
                      "hold [-].");
    prm.declare_entry("Coarsen",
                      "0",
                      Patterns::Double(0., 1.),
                      "Share of the squared error that the cells to be "
                      "coarsened may hold [-].");
    prm.declare_entry("Most levels",
                      "3",
                      Patterns::Integer(1),
                      "How often a cell of the mesh may be halved [-].");
    prm.declare_entry("Most cells",
                      "1000000",
                      Patterns::Double(1.),
                      "With more cells in all, nothing is refined [-].");
    prm.declare_entry("Bodies",
                      "",
                      Patterns::List(Patterns::Anything()),
                      "Names; empty: all that can be refined.");
  }


  void
  RefinementParameters::read(ParameterHandler &prm)
  {
    every         = prm.get_integer("Every");
    times         = numbers_of(prm.get("Times"));
    cycles        = prm.get_integer("Cycles");
    refine_share  = prm.get_double("Refine");
    coarsen_share = prm.get_double("Coarsen");
    most_levels   = prm.get_integer("Most levels");
    most_cells    = prm.get_double("Most cells");
    bodies        = Utilities::split_string_list(prm.get("Bodies"));
  }


  bool
  RefinementParameters::is_due(const unsigned int step,
                               const double       time,
                               const double       same_time) const
  {
    return (every > 0 && step % every == 0) ||
           std::any_of(times.begin(), times.end(), [&](const double t) {
             return std::abs(t - time) <= same_time;
           });
  }


  template <int dim>
  std::vector<std::vector<double>>
  error_indicators(const Model<dim> &model, const Vector_t &u)
  {
    const Vector<double>             everywhere(u);
    std::vector<std::vector<double>> errors;
    for (const auto &body : model.bodies)
      {
        errors.emplace_back();
        if (!body->can_be_refined())
          continue;
        Vector<double> of_body(body->n_dofs());
        for (types::global_dof_index i = 0; i < of_body.size(); ++i)
          of_body(i) = everywhere(body->numbering(i));
        errors.back() = body->gradient_jumps(of_body);
      }
    for (const auto &interface : model.interfaces)
      for (const auto &state :
           MortarContact::facet_states(*interface, model.communicator))
        for (unsigned int b = 0; b < errors.size(); ++b)
          {
            if (errors[b].empty() || state.label.part != model.bodies[b]->name)
              continue;
            const auto   p   = state.pressure.begin();
            const auto   end = p + state.current.n_vertices;
            const double jump =
              *std::max_element(p, end) - *std::min_element(p, end);
            errors[b][model.bodies[b]->active_number(state.label.cell)] +=
              MortarContact::diameter(state.reference) *
              MortarContact::area(state.reference) * jump * jump /
              (24. * state.modulus);
          }
    return errors;
  }


  template <int dim>
  std::vector<std::string>
  mark_cells(const Model<dim>           &model,
             const Vector_t             &u,
             const RefinementParameters &parameters)
  {
    struct Cell
    {
      double       error;
      unsigned int body, cell;
    };
    std::vector<Cell>        cells;
    std::vector<std::string> flags;
    const auto               errors = error_indicators(model, u);
    double                   sum = 0., n_cells = 0.;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        const Body<dim> &body = *model.bodies[b];
        n_cells += body.n_cells();
        flags.emplace_back();
        if (errors[b].empty() ||
            (!parameters.bodies.empty() &&
             std::find(parameters.bodies.begin(),
                       parameters.bodies.end(),
                       body.name) == parameters.bodies.end()))
          continue;
        flags.back().assign(errors[b].size(), '.');
        for (unsigned int c = 0; c < errors[b].size(); ++c)
          {
            cells.push_back({errors[b][c], b, c});
            sum += errors[b][c];
          }
      }
    if (n_cells > parameters.most_cells || !(sum > 0.))
      return {};
    // equal ones in the order of cells: no matter which rank asks
    std::stable_sort(cells.begin(),
                     cells.end(),
                     [](const auto &a, const auto &b) {
                       return a.error > b.error;
                     });
    bool   any  = false;
    double held = 0.;
    for (const Cell &c : cells)
      {
        if (held >= parameters.refine_share * sum)
          break;
        held += c.error;
        if (model.bodies[c.body]->level_of(c.cell) < parameters.most_levels)
          {
            flags[c.body][c.cell] = 'r';
            any                   = true;
          }
      }
    held = 0.;
    for (auto c = cells.rbegin(); c != cells.rend(); ++c)
      {
        held += c->error;
        if (parameters.coarsen_share == 0. ||
            held > parameters.coarsen_share * sum)
          break;
        // not beyond the mesh that was given
        if (flags[c->body][c->cell] == '.' &&
            model.bodies[c->body]->level_of(c->cell) > 0)
          flags[c->body][c->cell] = 'c';
      }
    // sums over ranks may differ in their last digit: one decides
    return Utilities::MPI::broadcast(model.communicator,
                                     any ? flags : std::vector<std::string>());
  }


  template std::vector<std::vector<double>>
  error_indicators<2>(const Model<2> &, const Vector_t &);
  template std::vector<std::vector<double>>
  error_indicators<3>(const Model<3> &, const Vector_t &);
  template std::vector<std::string>
  mark_cells<2>(const Model<2> &,
                const Vector_t &,
                const RefinementParameters &);
  template std::vector<std::string>
  mark_cells<3>(const Model<3> &,
                const Vector_t &,
                const RefinementParameters &);
} // namespace Structure

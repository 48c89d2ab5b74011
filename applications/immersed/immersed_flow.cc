// SPDX-License-Identifier: LGPL-2.1-or-later
#include "immersed_flow.h"

#include "../structure/checkpoint.h"
#include "../structure/numbers_of.h"
#include "../structure/stop_signal.h"

#include <mortar_contact/host/contact_output.h>

#include <deal.II/base/function_lib.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>

#include <deal.II/lac/sparse_direct.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/solution_transfer.h>
#include <deal.II/numerics/vector_tools.h>

#include <boost/archive/binary_iarchive.hpp>
#include <boost/archive/binary_oarchive.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

namespace Immersed
{
  using Structure::number;

  namespace
  {
    // of a checkpoint
    const char *const checkpoint_title = "MortarContact immersed 1";

    // what a direct solver must leave of a right hand side
    constexpr double linear_tolerance = 1e-6;
  } // namespace


  ImmersedFlow::ImmersedFlow(const Parameters  &parameters,
                             const std::string &used_parameters,
                             Structure::Log    &log)
    : parameters(parameters)
    , used_parameters(used_parameters)
    , log(log)
    , output(parameters.directory, -1., MPI_COMM_SELF)
    , inlet(parameters.inflow, "Fluid/Inflow value")
    , outlet(parameters.outlet, "Fluid/Outlet pressure")
    , fluid(parameters.fluid)
    , mesh(Triangulation<2>::limit_level_difference_at_vertices)
    , dof_handler(mesh)
    , leaflets(parameters.leaflets, parameters.material)
    , last_step(parameters.first_step)
  {
    GridGenerator::subdivided_hyper_rectangle(mesh,
                                              {parameters.n_x, parameters.n_y},
                                              Point<2>(),
                                              Point<2>(parameters.length,
                                                       parameters.height),
                                              true);
    leaflet.u.reinit(leaflets.dof_handler.n_dofs());
    leaflet.rate.reinit(leaflet.u);
    distribute();
    for (unsigned int i = 0; i < parameters.n_refinements; ++i)
      refine();
    if (parameters.has_contact)
      {
        contact = std::make_unique<MortarContact::ContactInterface<2>>(
          "leaflets", parameters.contact, MPI_COMM_SELF);
        leaflets.add_to(*contact);
        contact->setup();
      }
  }


  double
  ImmersedFlow::coupling_penalty() const
  {
    if (parameters.penalty > 0.)
      return parameters.penalty;
    // SHELL_AND_FLUID 4.3: both terms with the factor that Kamensky et al. use
    return 10. * std::max(fluid.parameters.viscosity / cell_length,
                          fluid.parameters.density * cell_length /
                            parameters.first_step);
  }


  void
  ImmersedFlow::distribute()
  {
    dof_handler.distribute_dofs(fluid.fe);
    const auto n_leaflets = leaflets.dof_handler.n_dofs();
    is_pressure.assign(dof_handler.n_dofs(), false);
    const IndexSet pressures = DoFTools::extract_dofs(
      dof_handler, fluid.fe.component_mask(FEValuesExtractors::Scalar(2)));
    for (const auto dof : pressures)
      is_pressure[dof] = true;

    hanging_nodes.clear();
    DoFTools::make_hanging_node_constraints(dof_handler, hanging_nodes);
    constraints.clear();
    constraints.merge(hanging_nodes);
    hanging_nodes.close();
    for (const auto &value : boundary_velocities(0.))
      constraints.add_line(value.first);
    constraints.shift(n_leaflets);
    leaflets.constrain(constraints);
    constraints.close();
    pattern_pairs.clear();
    cell_length = GridTools::minimal_cell_diameter(mesh) / std::sqrt(2.);
    if (flow.size() == 0)
      flow.reinit(dof_handler.n_dofs());
    coupling = std::make_unique<Coupling>(dof_handler,
                                          fluid,
                                          leaflets,
                                          coupling_penalty());
    coupling->locate(leaflet.u);
  }


  std::map<types::global_dof_index, double>
  ImmersedFlow::boundary_velocities(const double t)
  {
    /// Along the channel, of the formula.
    class Inlet : public Function<2>
    {
    public:
      Inlet(Structure::Expression<2> &value, const double t)
        : Function<2>(3)
        , value_of(value)
        , t(t)
      {}

      double
      value(const Point<2> &x, const unsigned int component) const override
      {
        return component == 0 ? value_of.value(x, t) : 0.;
      }

    private:
      Structure::Expression<2> &value_of;
      const double              t;
    };

    const ComponentMask velocities =
      fluid.fe.component_mask(FEValuesExtractors::Vector(0));
    std::map<types::global_dof_index, double> values;
    if (parameters.has_velocity)
      VectorTools::interpolate_boundary_values(
        mapping, dof_handler, left, Inlet(inlet, t), values, velocities);
    const Functions::ZeroFunction<2> zero(3);
    for (const auto side : {bottom, top})
      VectorTools::interpolate_boundary_values(
        mapping, dof_handler, side, zero, values, velocities);
    // where pressure is given the flow is parallel to the channel
    const ComponentMask across =
      fluid.fe.component_mask(FEValuesExtractors::Scalar(1));
    for (const auto side : {left, right})
      if (side == right || !parameters.has_velocity)
        VectorTools::interpolate_boundary_values(
          mapping, dof_handler, side, zero, values, across);
    return values;
  }


  void
  ImmersedFlow::refine()
  {
    // refine what holds leaflets, with a margin of its own size; coarsen what
    // is farther away than three of them
    const std::vector<Point<2>> places = coupling->places();
    const auto near = [&](const auto &cell, const double margin) {
      BoundingBox<2> box = cell->bounding_box();
      box.extend(margin * cell->minimum_vertex_distance());
      return std::any_of(places.begin(), places.end(), [&](const Point<2> &x) {
        return box.point_inside(x);
      });
    };
    const int most = parameters.n_refinements;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        if (cell->level() < most && near(cell, 1.))
          cell->set_refine_flag();
        else if (cell->level() > 0 && !near(cell, 3.))
          cell->set_coarsen_flag();
      }
    mesh.prepare_coarsening_and_refinement();
    bool changes = false;
    for (const auto &cell : mesh.active_cell_iterators())
      changes = changes || cell->refine_flag_set() || cell->coarsen_flag_set();
    if (!changes)
      return;
    SolutionTransfer<2>  transfer(dof_handler);
    const Vector<double> old = flow;
    transfer.prepare_for_coarsening_and_refinement(old);
    mesh.execute_coarsening_and_refinement();
    dof_handler.distribute_dofs(fluid.fe);
    flow.reinit(dof_handler.n_dofs());
    transfer.interpolate(old, flow);
    distribute();
  }


  void
  ImmersedFlow::make_pattern()
  {
    const auto                           n = leaflet.u.size();
    DynamicSparsityPattern               dsp(n + flow.size());
    std::vector<types::global_dof_index> dofs(fluid.fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (auto &dof : dofs)
          dof += n;
        constraints.add_entries_local_to_global(dofs, dsp, false);
      }
    leaflets.add_couplings(dsp, constraints);
    coupling->add_couplings(dsp, constraints, n);
    if (contact)
      contact->add_couplings(dsp, constraints);
    matrix.clear();
    sparsity.copy_from(dsp);
    matrix.reinit(sparsity);
    pattern_pairs = coupling->pairs();
  }


  std::string
  ImmersedFlow::try_step(const double time_step)
  {
    const double   t   = time + time_step;
    const auto     n   = leaflet.u.size();
    Vector<double> now = flow, u = leaflet.u;
    Vector<double> rhs(n + flow.size()), update(n + flow.size());
    Vector<double> leaflet_update(n);
    for (const auto &[dof, value] : boundary_velocities(t))
      now(dof) = value;
    NavierStokes::Pressures pressures;
    pressures[right] = outlet.value(Point<2>(), t);
    if (!parameters.has_velocity)
      pressures[left] = inlet.value(Point<2>(), t);
    hanging_nodes.distribute(now); // they follow those at the boundary
    if (coupling->pairs() != pattern_pairs)
      make_pattern();

    double first_force = 0.;
    for (unsigned int i = 0;; ++i)
      {
        Timer timer;
        if (contact)
          {
            contact->update(u, t);
            if (contact->report().couplings_changed)
              make_pattern();
          }
        matrix = 0.;
        rhs    = 0.;
        fluid.assemble(dof_handler,
                       mapping,
                       now,
                       flow,
                       time_step,
                       pressures,
                       constraints,
                       n,
                       matrix,
                       rhs);
        leaflets.assemble(
          u, leaflet_update, leaflet, time_step, constraints, matrix, rhs);
        coupling->assemble(
          now, u, leaflet.u, time_step, constraints, n, matrix, rhs);
        if (contact)
          contact->assemble(matrix, rhs, constraints);
        assembly_seconds += timer.wall_time();

        double force = 0., source = 0.;
        for (unsigned int k = 0; k < rhs.size(); ++k)
          (k >= n && is_pressure[k - n] ? source : force) += rhs(k) * rhs(k);
        force  = std::sqrt(force);
        source = std::sqrt(source);
        if (!std::isfinite(force + source))
          return "the residual is not a number";
        if (i == 0)
          {
            first_force   = std::max(force, 1e-2 * largest_force);
            largest_force = std::max(largest_force, force);
          }
        // volume is kept to what flows through a side of a cell
        double fastest = 0.;
        for (unsigned int k = 0; k < now.size(); ++k)
          if (!is_pressure[k])
            fastest = std::max(fastest, std::abs(now(k)));
        if ((i > 0 || force + source == 0.) &&
            force <= parameters.tolerance * first_force &&
            source <= parameters.tolerance * fastest * cell_length)
          {
            last_iterations = i;
            break;
          }
        if (i == parameters.n_iterations)
          return "the residual is " + number(force / first_force, 2) +
                 " of that at the start after " + std::to_string(i) +
                 " iterations";

        timer.restart();
        try
          {
            SparseDirectUMFPACK solver;
            solver.initialize(matrix);
            solver.vmult(update, rhs);
          }
        catch (const ExceptionBase &)
          {
            return "the matrix is singular";
          }
        // saddle points can make it lose all digits in silence
        Vector<double> rest(rhs);
        const double   left_over = matrix.residual(rest, update, rhs);
        solver_seconds += timer.wall_time();
        ++newton_iterations;
        if (!(left_over <= linear_tolerance * rhs.l2_norm()))
          return "the linear solver left " +
                 number(left_over / rhs.l2_norm(), 2) +
                 " of the right hand side";
        constraints.distribute(update);
        for (unsigned int k = 0; k < n; ++k)
          leaflet_update(k) = update(k);
        const double share =
          contact ? contact->largest_safe_step(u, leaflet_update) : 1.;
        leaflet_update *= share;
        u += leaflet_update;
        for (unsigned int k = 0; k < flow.size(); ++k)
          now(k) += share * update(n + k);
      }
    for (unsigned int l = 0; l < parameters.leaflets.size(); ++l)
      if (!leaflets.is_within(
            Point<2>(), Point<2>(parameters.length, parameters.height), l, u))
        return "leaflet " + std::to_string(l) + " leaves the channel";
    if (contact)
      {
        const MortarContact::StepAdvice advice = contact->advice();
        if (!advice.accept)
          return advice.reason;
        contact->commit(t);
      }

    leaflet.rate = u;
    leaflet.rate -= leaflet.u;
    leaflet.rate /= time_step;
    leaflet.u = u;
    flow      = now;
    time      = t;
    ++step;
    last_step = time_step;
    return "";
  }


  double
  ImmersedFlow::inflow() const
  {
    return -fluid.flux(dof_handler, mapping, flow, left);
  }


  std::vector<std::pair<std::string, double>>
  ImmersedFlow::record(const double       time_step,
                       const unsigned int iterations) const
  {
    std::vector<std::pair<std::string, double>> row = {
      {"step", step},
      {"time", time},
      {"step_size", time_step},
      {"iterations", iterations},
      {"cut_backs", cut_backs},
      {"inflow", inflow()},
      {"outflow", fluid.flux(dof_handler, mapping, flow, right)},
      {"inlet_pressure", fluid.mean_pressure(dof_handler, mapping, flow, left)},
      {"outlet_pressure",
       fluid.mean_pressure(dof_handler, mapping, flow, right)},
      {"strain_energy", leaflets.strain_energy(leaflet.u)}};
    for (unsigned int l = 0; l < parameters.leaflets.size(); ++l)
      for (unsigned int c = 0; c < 2; ++c)
        row.push_back(
          {"leaflet_" + std::to_string(l) + ":tip_" + "xy"[c], tip(l)[c]});
    if (contact)
      {
        const auto &r = contact->report();
        row.push_back({"contact:active_pairs", r.active_pairs});
        row.push_back({"contact:force_x", r.force[0]});
        row.push_back({"contact:force_y", r.force[1]});
        row.push_back({"contact:active_length", r.active_area});
        row.push_back({"contact:largest_penetration", r.largest_penetration});
        row.push_back(
          {"contact:penetration_over_release", r.relative_penetration});
      }
    return row;
  }


  void
  ImmersedFlow::report_setup()
  {
    log.line("Channel " + number(parameters.length) + " x " +
             number(parameters.height) + ": " +
             std::to_string(mesh.n_active_cells()) + " cells of degree 2, " +
             std::to_string(flow.size()) + " velocities and pressures");
    log.line(std::to_string(parameters.leaflets.size()) + " leaflets, " +
             std::to_string(leaflet.u.size()) + " displacements, thickness " +
             number(parameters.material.thickness) +
             (contact ? ", contact" : ", no contact"));
    log.line("Coupling penalty " + number(coupling->beta) +
             ": leaflets leak by the pressure jump over it");
    if (contact)
      log.line("  " + contact->report().brief());
  }


  Structure::ExitCode
  ImmersedFlow::give_up(const std::string &reason)
  {
    save();
    write_summary("no convergence");
    log.line("No convergence: " + reason + " Last good state: time " +
             number(time) + ".");
    return Structure::no_convergence;
  }


  Structure::ExitCode
  ImmersedFlow::run()
  {
    if (step == 0)
      {
        output.start(used_parameters);
        log.open(parameters.directory + "/run.log", false);
        output.history(record(0., 0));
        write_fields();
      }
    report_setup();
    const double end = parameters.end_time * (1. - 1e-12);
    double       dt  = last_step;
    while (time < end)
      {
        coupling->locate(leaflet.u);
        if (step > 0 && parameters.refine_every > 0 &&
            step % parameters.refine_every == 0)
          refine();
        const double left_over = parameters.end_time - time;
        double       tried =
          (left_over < dt * (1. + 1e-9)) ? left_over : std::min(dt, left_over);
        std::string reason = try_step(tried);
        while (!reason.empty())
          {
            if (contact)
              contact->rollback();
            ++cut_backs;
            tried *= 0.5;
            log.line("  step rejected: " + reason + "; next " + number(tried));
            if (tried < parameters.smallest_step)
              return give_up("the step fell below 'Smallest step', " +
                             number(parameters.smallest_step) + ".");
            reason = try_step(tried);
          }
        dt = (last_iterations <= parameters.n_iterations / 2) ?
               std::min(parameters.first_step, 2. * tried) :
               tried;
        output.history(record(tried, last_iterations));
        std::string line = "Step " + std::to_string(step) + "  time " +
                           number(time) + "  " +
                           std::to_string(last_iterations) +
                           " iterations  inflow " + number(inflow());
        if (contact && contact->report().active_pairs > 0)
          line += "  " + contact->report().brief();
        log.line(line);
        const bool is_last = !(time < end);
        if (is_last || (parameters.output_every > 0 &&
                        step % parameters.output_every == 0))
          write_fields();
        const bool stops = Structure::stop_is_requested(MPI_COMM_SELF);
        if (stops ||
            (parameters.save_every > 0 && step % parameters.save_every == 0))
          save();
        if (stops)
          {
            write_summary("stopped");
            log.line("Stopped by a signal at time " + number(time) +
                     "; continue with --restart " + parameters.directory + ".");
            return Structure::stopped;
          }
      }
    save();
    write_summary("finished");
    log.line("Finished: " + std::to_string(step) + " steps, " +
             std::to_string(newton_iterations) + " iterations, " +
             std::to_string(cut_backs) + " cut-backs. Results in '" +
             parameters.directory + "'");
    return Structure::finished;
  }


  void
  ImmersedFlow::write_fields()
  {
    using namespace DataComponentInterpretation;
    const std::string number = Utilities::int_to_string(step, 4) + ".vtu";
    DataOut<2>        data_out;
    data_out.add_data_vector(dof_handler,
                             flow,
                             {"velocity", "velocity", "pressure"},
                             {component_is_part_of_vector,
                              component_is_part_of_vector,
                              component_is_scalar});
    data_out.build_patches(mapping, 2);
    std::ofstream out(parameters.directory + "/solution-fluid-" + number);
    data_out.write_vtu(out);
    leaflets.write(parameters.directory + "/solution-leaflets-" + number,
                   leaflet.u);
    AssertThrow(out,
                ExcMessage("Nothing can be written to '" +
                           parameters.directory + "'."));
    output.add_to_solution(time, 0, "solution-fluid-" + number);
    output.add_to_solution(time, 1, "solution-leaflets-" + number);
    if (contact)
      MortarContact::write_contact_vtu(*contact,
                                       parameters.directory +
                                         "/contact-leaflets-" + number,
                                       MPI_COMM_SELF);
  }


  void
  ImmersedFlow::write_summary(const std::string &status)
  {
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    nlohmann::json json;
    json["status"]                       = status;
    json["version"]                      = "0.1.0";
    json["deal.II version"]              = DEAL_II_PACKAGE_VERSION;
    json["ranks"]                        = 1;
    json["steps"]                        = step;
    json["time"]                         = time;
    json["newton_iterations"]            = newton_iterations;
    json["cut_backs"]                    = cut_backs;
    json["cells"]                        = mesh.n_active_cells();
    json["dofs"]                         = flow.size() + leaflet.u.size();
    json["peak_memory_kB"]               = memory.VmHWM;
    json["wall_seconds"]                 = wall.wall_time();
    json["seconds"]["assembly, contact"] = assembly_seconds;
    json["seconds"]["linear solver"]     = solver_seconds;
    if (contact)
      {
        const MortarContact::ContactReport &r = contact->report();
        nlohmann::json                     &j = json["interfaces"]["leaflets"];
        j["force"]                            = {r.force[0], r.force[1]};
        j["largest_penetration"]              = r.largest_penetration;
        j["penetration_over_release"]         = r.relative_penetration;
        j["largest_pressure"]                 = r.largest_pressure;
      }
    for (const auto &[name, value] : record(last_step, last_iterations))
      json["last"][name] = value;
    output.text_file("summary.json", json.dump(2) + "\n");
    log.line("  assembly, contact " + number(assembly_seconds) +
             " s, linear solver " + number(solver_seconds) + " s, all " +
             number(wall.wall_time()) + " s");
  }


  void
  ImmersedFlow::save() const
  {
    std::ostringstream history, out;
    if (contact)
      contact->save(history);
    const std::string text = history.str();
    {
      boost::archive::binary_oarchive archive(out);
      archive << time << step << last_step << newton_iterations << cut_backs
              << largest_force;
      mesh.save(archive, 0);
      archive << flow << leaflet.u << leaflet.rate << text;
    }
    Structure::write_state(checkpoint_title,
                           out.str(),
                           parameters.directory,
                           MPI_COMM_SELF);
  }


  void
  ImmersedFlow::restart(const std::string &directory)
  {
    std::istringstream in(
      Structure::read_state(checkpoint_title, directory, MPI_COMM_SELF));
    std::string text;
    try
      {
        boost::archive::binary_iarchive archive(in);
        archive >> time >> step >> last_step >> newton_iterations >>
          cut_backs >> largest_force;
        mesh.clear();
        mesh.load(archive, 0);
        Vector<double> saved_flow, saved_u, saved_rate;
        archive >> saved_flow >> saved_u >> saved_rate >> text;
        AssertThrow(saved_u.size() == leaflet.u.size(),
                    ExcMessage("other leaflets"));
        leaflet.u    = saved_u;
        leaflet.rate = saved_rate;
        distribute();
        AssertThrow(saved_flow.size() == dof_handler.n_dofs(),
                    ExcMessage("another channel"));
        flow = saved_flow;
      }
    catch (const std::exception &)
      {
        AssertThrow(false,
                    ExcMessage("The checkpoint in '" + directory +
                               "' belongs to other leaflets or another channel "
                               "than this parameter file."));
      }
    if (contact)
      {
        std::istringstream history(text);
        contact->load(history, leaflet.u);
      }
    if (directory == parameters.directory)
      output.resume(time);
    else
      {
        output.start(used_parameters);
        save();
      }
    log.open(parameters.directory + "/run.log",
             directory == parameters.directory);
    log.line("Continued from '" + directory + "' at time " + number(time));
  }
} // namespace Immersed

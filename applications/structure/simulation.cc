// SPDX-License-Identifier: LGPL-2.1-or-later
#include "simulation.h"

#include "../geometry/mesh_maker.h"
#include "advice.h"
#include "numbers_of.h"
#include "shell_body.h"
#include "solid_body.h"
#include "stop_signal.h"

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace Structure
{
  namespace
  {
    std::string
    duration(const double seconds)
    {
      std::ostringstream out;
      const auto         s = static_cast<unsigned long>(std::max(0., seconds));
      if (s >= 3600)
        out << s / 3600 << " h " << (s / 60) % 60 << " min";
      else if (s >= 60)
        out << s / 60 << " min " << s % 60 << " s";
      else
        out << s << " s";
      return out.str();
    }

    template <class Numbers>
    std::string
    list_of(const Numbers &numbers)
    {
      std::string text;
      for (const auto n : numbers)
        text += (text.empty() ? "" : ", ") + std::to_string(n);
      return text;
    }

    /// Names of a mesh file's parts and boundaries, for the log.
    std::string
    names_of(const MeshParts &parts)
    {
      std::string text;
      for (const auto &[name, id] : parts.names)
        text += "; '" + name + "' is material " + std::to_string(id);
      for (const auto &[name, id] : parts.boundaries)
        text += "; '" + name + "' is boundary " + std::to_string(id);
      return text;
    }

    /// Thickness by material id: what the scene says, or the mesh file; empty
    /// where all cells have that of the scene.
    std::map<types::material_id, double>
    thicknesses_of(const BodyParameters      &b,
                   const MeshParts           &parts,
                   const Triangulation<2, 3> &mesh)
    {
      std::map<types::material_id, double> result;
      if (b.thickness == 0.)
        result = parts.thickness;
      std::set<types::material_id> ids;
      for (const auto &cell : mesh.active_cell_iterators())
        ids.insert(cell->material_id());
      std::string known;
      for (const types::material_id id : ids)
        known += (known.empty() ? "" : ", ") + std::to_string(id);
      for (const auto &name : parts.names)
        known += ", " + name.first;
      for (const auto &[name, thickness] : b.part_thickness)
        {
          const auto         named = parts.names.find(name);
          types::material_id id    = numbers::invalid_material_id;
          if (named != parts.names.end())
            id = named->second;
          else if (Patterns::Integer(0).match(name))
            id = std::stoul(name);
          AssertThrow(ids.count(id) > 0,
                      ExcMessage("'Thickness of parts' names '" + name +
                                 "'; the mesh has " + known + "."));
          result[id] = thickness;
        }
      for (const types::material_id id : ids)
        AssertThrow(b.thickness > 0. || result.count(id) > 0,
                    ExcMessage(
                      "'Thickness' is 0 and part " + std::to_string(id) +
                      " has none of its own; the mesh has " + known + "."));
      return result;
    }
  } // namespace


  template <int dim>
  Simulation<dim>::Simulation(const Scene       &scene,
                              const std::string &used_parameters,
                              const MPI_Comm     communicator,
                              Log               &log)
    : scene(scene)
    , communicator(communicator)
    // of this rank: with a communicator it would complain on the terminal when
    // an error in the input ends the run
    , timer(std::cout, TimerOutput::never, TimerOutput::wall_times)
    , model(communicator, timer)
    , linear_solver(scene.linear, communicator)
    , used_parameters(used_parameters)
    , log(log)
    , output(scene.output.directory, scene.output.surface_offset, communicator)
    , next_step(scene.steps.first)
  {}


  template <int dim>
  std::vector<Vector_t *>
  Simulation<dim>::kept_vectors()
  {
    std::vector<Vector_t *> vectors = {&u};
    if (model.is_dynamic())
      for (Vector_t *v : {&model.integration.v_n, &model.integration.a_n})
        vectors.push_back(v);
    vectors.push_back(&rate);
    return vectors;
  }


  template <int dim>
  std::vector<Vector_t *>
  Simulation<dim>::saved_vectors()
  {
    std::vector<Vector_t *> vectors = kept_vectors();
    if (model.is_dynamic()) // computed anew it could differ in round-off
      vectors.push_back(&model.integration.F_n);
    if (audit.is_possible)
      vectors.push_back(&audit.forces);
    return vectors;
  }


  template <int dim>
  std::unique_ptr<Body<dim>>
  Simulation<dim>::make_solid(const BodyParameters &b,
                              const bool            whole_meshes) const
  {
    Triangulation<dim>        mesh;
    const MeshParts           parts    = make_mesh<dim>(b.mesh, mesh);
    std::unique_ptr<Material> material = b.material.make();
    const bool                mean_dilatation =
      b.mean_dilatation == "yes" ||
      (b.mean_dilatation == "automatic" && material->is_split() &&
       b.degree == 1 && mesh.all_reference_cells_are_hyper_cube());
    auto solid           = std::make_unique<SolidBody<dim>>(b.name,
                                                  mesh,
                                                  std::move(material),
                                                  b.degree,
                                                  mean_dilatation,
                                                  whole_meshes,
                                                  communicator);
    solid->names_in_file = names_of(parts);
    return solid;
  }


  template <int dim>
  std::unique_ptr<Body<dim>>
  Simulation<dim>::make_shell(const BodyParameters &b) const
  {
    if constexpr (dim == 3)
      {
        Triangulation<2, 3>             mesh;
        const MeshParts                 parts = make_shell_mesh(b.mesh, mesh);
        const std::unique_ptr<Material> material = b.material.make();
        ShellParameters                 shell;
        shell.section         = {b.material.youngs_modulus,
                                 b.material.poissons_ratio,
                                 b.thickness,
                                 b.material.density,
                                 b.material.law == "neo-Hookean",
                                 b.material.hardening};
        shell.director_scale  = b.director_scale;
        shell.is_turned       = b.is_turned;
        shell.contact_modulus = material->contact_modulus;
        shell.thicknesses     = thicknesses_of(b, parts, mesh);
        std::vector<SymmetryPlane> planes;
        for (const BoundaryCondition &c : scene.conditions)
          if (c.body == b.name && c.type == BoundaryCondition::Type::symmetry)
            planes.emplace_back(c.boundaries, c.plane_normal);
        auto body = std::make_unique<ShellBody>(
          b.name, mesh, shell, planes, communicator);
        body->names_in_file = names_of(parts);
        return body;
      }
    else
      {
        AssertThrow(false,
                    ExcMessage("'Type' is 'shell' but 'Dimension' is 2; "
                               "expected 3."));
        return nullptr;
      }
  }


  template <int dim>
  void
  Simulation<dim>::make_bodies(const bool whole_meshes)
  {
    // what looks at the bodies goes first
    model.interfaces.clear();
    model.fluid.reset();
    model.bodies.clear();
    for (const BodyParameters &b : scene.bodies)
      {
        try
          {
            model.bodies.push_back(b.is_shell ? make_shell(b) :
                                                make_solid(b, whole_meshes));
          }
        catch (const ExceptionBase &e)
          {
            std::ostringstream info;
            e.print_info(info);
            AssertThrow(false,
                        ExcMessage("In section 'Bodies/" + b.name +
                                   "': " + Utilities::trim(info.str())));
          }
        model.bodies.back()->body_force       = b.body_force;
        model.bodies.back()->initial_velocity = b.initial_velocity;
      }
  }


  template <int dim>
  void
  Simulation<dim>::setup()
  {
    TimerOutput::Scope scope(timer, "setup");
    make_bodies(scene.refinement.is_on());
    for (const BoundaryCondition &c : scene.conditions)
      {
        if (!c.point.empty() || !c.where.empty() || c.on_surface)
          continue;
        const auto ids = model.body(c.body).boundary_ids();
        for (const auto id : c.boundaries)
          {
            AssertThrow(ids.count(id) > 0,
                        ExcMessage("'Boundary conditions/" + c.name +
                                   "/Boundary ids' has " + std::to_string(id) +
                                   "; the mesh of '" + c.body + "' has " +
                                   list_of(ids) + "."));
          }
      }
    model.conditions  = scene.conditions;
    model.integration = TimeIntegration(scene.dynamics);
    check_refinement();
    for (const auto &b : model.bodies)
      AssertThrow(!scene.dynamics.keeps_energy || b->keeps_energy(),
                  ExcMessage("'Dynamics/Method' is 'energy-momentum', which is "
                             "for shells of the St. Venant-Kirchhoff law; '" +
                             b->name +
                             "' is another body. Expected "
                             "'generalised-alpha'."));
    connect();
  }


  template <int dim>
  void
  Simulation<dim>::connect()
  {
    rigid_bodies.clear();
    model.rigid_dofs.clear();
    model.interfaces.clear();
    probe_dofs.clear();
    for (const RigidParameters &r : scene.rigid_bodies)
      try
        {
          rigid_bodies.push_back(r.make<dim>(model.box_diagonal()));
          if (!r.free_motions.empty())
            {
              AssertThrow(!scene.dynamics.is_on,
                          ExcMessage("'Free motions' are set but "
                                     "'Dynamics/Type' is 'dynamic'; free rigid "
                                     "bodies have no mass yet."));
              model.rigid_dofs.emplace_back(rigid_bodies.back(),
                                            r,
                                            model.box_diagonal());
            }
        }
      catch (const ExcMessage &e)
        {
          std::ostringstream info;
          e.print_info(info);
          AssertThrow(false,
                      ExcMessage("In section 'Rigid bodies/" + r.name +
                                 "': " + Utilities::trim(info.str())));
        }

    model.number_dofs();

    for (const InterfaceParameters &i : scene.interfaces)
      {
        auto interface =
          std::make_unique<MortarContact::ContactInterface<dim>>(i.name,
                                                                 i.contact,
                                                                 communicator);
        for (const bool secondary : {true, false})
          for (const PartSelection &part : secondary ? i.secondary : i.primary)
            {
              const auto rigid = std::find_if(rigid_bodies.begin(),
                                              rigid_bodies.end(),
                                              [&](const auto &r) {
                                                return r->name == part.body;
                                              });
              if (rigid != rigid_bodies.end())
                {
                  if (secondary)
                    interface->add_secondary(*rigid);
                  else
                    interface->add_primary(*rigid);
                  continue;
                }
              model.body(part.body).add_to(*interface, secondary, part.faces);
            }
        interface->setup();
        model.interfaces.push_back(std::move(interface));
      }
    model.fluid.reset();
    if (scene.valve.is_on)
      for (const auto &b : model.bodies)
        if (b->name == scene.valve.body)
          model.fluid = std::make_unique<ValveFluid<dim>>(scene.valve, *b);
    model.setup(
      scene.linear.is_iterative(dim, model.n_dofs(), model.has_shells()));
    u    = model.make_vector();
    rate = model.make_vector();

    // the nodes nearest to the probes
    for (const ProbeParameters &p : scene.output.probes)
      {
        probe_dofs.push_back(
          model.body(p.body).nearest_node(point_of<dim>(p.point)).dofs);
      }
    has_touched.resize(model.interfaces.size(), 0);
    const std::array<std::string, 3> at_rest = {{"0", "0", "0"}};
    audit.is_possible =
      !model.fluid && !scene.refinement.is_on() && refinements.empty() &&
      model.rigid_dofs.empty() &&
      std::all_of(scene.bodies.begin(),
                  scene.bodies.end(),
                  [](const BodyParameters &b) {
                    return b.material.hardening.yield_stress == 0.;
                  }) &&
      std::all_of(scene.rigid_bodies.begin(),
                  scene.rigid_bodies.end(),
                  [&](const RigidParameters &r) {
                    return r.translation == at_rest &&
                           r.rotation_angle == "0" && r.formula.empty();
                  }) &&
      std::all_of(scene.interfaces.begin(),
                  scene.interfaces.end(),
                  [](const InterfaceParameters &i) {
                    return !i.contact.augmentation.is_on &&
                           i.contact.removal_time == 0.;
                  });
    if (audit.is_possible)
      audit.forces = model.make_vector();
    resolution.reset();
    if (scene.output.has_resolution)
      resolution = std::make_unique<ContactResolution<dim>>(model);
  }


  template <int dim>
  void
  Simulation<dim>::report_setup()
  {
    for (unsigned int i = 0; i < model.bodies.size(); ++i)
      {
        const Body<dim> &b = *model.bodies[i];
        log.line("Body '" + b.name + "': " + std::to_string(b.n_cells()) +
                 " cells, " + std::to_string(b.n_dofs()) + " dofs" +
                 b.description());
        std::string place;
        for (unsigned int d = 0; d < dim; ++d)
          {
            place += std::string(d == 0 ? "  " : ", ") + "xyz"[d] + " from " +
                     number(b.box().first[d]) + " to " +
                     number(b.box().second[d]);
          }
        log.line(place + "; boundary ids " + list_of(b.boundary_ids()) +
                 "; material ids " + list_of(b.material_ids()) +
                 b.names_in_file);
        const bool is_held =
          std::any_of(scene.conditions.begin(),
                      scene.conditions.end(),
                      [&](const BoundaryCondition &c) {
                        using Type = BoundaryCondition::Type;
                        return c.body == b.name &&
                               (c.type == Type::displacement ||
                                c.type == Type::symmetry);
                      });
        if (!is_held && !model.is_dynamic())
          log.line("  NOTE: no displacement or symmetry condition holds '" +
                   b.name +
                   "': in statics contact must hold all its motions, from the "
                   "first step on.");
      }
    log.line("Model: " + std::to_string(model.n_dofs()) + " dofs on " +
             std::to_string(Utilities::MPI::n_mpi_processes(communicator)) +
             " rank(s), about " +
             // 81 (27 x 3) entries per row in 3d, 18 (9 x 2) in 2d; a direct
             // factor holds some twenty times as many
             number(model.n_dofs() *
                      (dim == 3 ? 81. * 12. * 20. : 18. * 12. * 10.) / 1e9,
                    2) +
             " GB with the direct solver");
    for (const auto &interface : model.interfaces)
      log.line(Utilities::trim(interface->report().initial_text()));
  }


  template <int dim>
  Tensor<1, dim>
  Simulation<dim>::probe(const unsigned int p) const
  {
    std::vector<double> value(dim, 0.);
    for (unsigned int i = 0; i < dim; ++i)
      if (model.owned_dofs().is_element(probe_dofs[p][i]))
        value[i] = u(probe_dofs[p][i]);
    Utilities::MPI::sum(value, communicator, value);
    Tensor<1, dim> result;
    for (unsigned int i = 0; i < dim; ++i)
      result[i] = value[i];
    return result;
  }


  template <int dim>
  std::pair<Tensor<1, 3>, Tensor<1, 3>>
  Simulation<dim>::resultant(const MortarContact::RigidBody<dim> &body) const
  {
    std::pair<Tensor<1, 3>, Tensor<1, 3>> sum;
    for (const auto &interface : model.interfaces)
      for (const auto &part : interface->report().parts)
        if (part.name == body.name)
          {
            sum.first += part.force;
            sum.second += part.moment;
          }
    // about the centre of rotation, which moves with the body
    const RigidParameters *p = nullptr;
    for (const auto &r : scene.rigid_bodies)
      if (r.name == body.name)
        p = &r;
    const Tensor<1, dim> at =
      body.has_dofs() ? body.turning_point() : p->template turning_point<dim>();
    Tensor<1, 3> c;
    for (unsigned int i = 0; i < dim; ++i)
      c[i] = at[i];
    if (!body.has_dofs())
      c += p->template shift<dim>(time);
    sum.second -= cross_product_3d(c, sum.first);
    return sum;
  }


  template <int dim>
  Vector_t
  Simulation<dim>::predicted_motion(const double new_time)
  {
    Vector_t motion = model.make_vector();
    // after some failures a step starts from the last state
    if ((!scene.newton.predicts && !goes_again) || cut_backs_of_step >= 3 ||
        rate.linfty_norm() == 0.)
      return motion;
    // where overlaps have been removed the motion turns
    for (const auto &interface : model.interfaces)
      if (!goes_again && std::abs(time - interface->parameters.removal_time) <=
                           1e-10 * scene.steps.end_time)
        return motion;
    motion.equ(new_time - time, rate);
    double share = 1.;
    for (const auto &interface : model.interfaces)
      share =
        std::min(share, interface->largest_safe_step(u, motion, new_time));
    if (share < 1.)
      motion *= 0.99 * share;
    return motion;
  }


  template <int dim>
  double
  Simulation<dim>::safe_target(const double target)
  {
    double safe = target;
    if (rigid_bodies.empty())
      return safe;
    // the share is not linear where rigid bodies turn or bodies are curved
    for (unsigned int trial = 0; trial < 5; ++trial)
      {
        const Vector_t motion = predicted_motion(safe);
        double         share  = 1.;
        for (const auto &interface : model.interfaces)
          share =
            std::min(share, interface->largest_safe_step(u, motion, safe));
        const double shorter = 0.95 * share * (safe - time);
        if (share >= 1. || shorter < scene.steps.smallest)
          break;
        safe = time + shorter;
      }
    if (safe < target)
      log.line("  step to " + number(target) + " shortened to " + number(safe) +
               ": rigid bodies would pass what is in their way");
    return safe;
  }


  template <int dim>
  std::string
  Simulation<dim>::try_step(const double new_time)
  {
    Vector_t       trial    = u;
    const Vector_t start    = predicted_motion(new_time);
    const bool     predicts = start.linfty_norm() > 0.;
    trial += start;
    model.integration.start_step(new_time - time);
    last_newton       = NewtonResult();
    bool again        = true;
    bool mixed_points = model.has_shells();
    while (again)
      {
        const NewtonResult solved = solve_step(
          model,
          scene.newton,
          linear_solver,
          new_time,
          u,
          trial,
          mixed_points,
          [&](const NewtonIterate &i) {
            if (resolution)
              resolution->watch(model);
            std::ostringstream out;
            out << "    iteration " << i.iteration << "  residual "
                << std::scientific << std::setprecision(2) << i.residual;
            if (i.iteration > 0)
              {
                out << "  update " << i.update;
                if (i.step < 1.)
                  out << "  step " << std::fixed << i.step;
                if (i.linear.iterations > 0 || i.linear.method != "MUMPS")
                  out << "  " << i.linear.method << " " << i.linear.iterations;
              }
            log.line(out.str());
          });
        // with augmentations a step is solved more than once
        last_newton.converged = solved.converged;
        last_newton.failure   = solved.failure;
        last_newton.residual  = solved.residual;
        last_newton.iterations += solved.iterations;
        last_newton.linear_iterations += solved.linear_iterations;
        again = false;
        // a shorter step helps a prediction more than none
        if (!solved.converged && mixed_points && !predicts)
          {
            log.line("    " + solved.failure +
                     " with extrapolated stresses of shells; again without");
            mixed_points = false;
            trial        = u;
            for (const auto &interface : model.interfaces)
              interface->rollback();
            again = true;
          }
        if (solved.converged)
          for (const auto &interface : model.interfaces)
            again = interface->augment() || again;
      }
    newton_iterations += last_newton.iterations;
    linear_iterations += last_newton.linear_iterations;
    if (!last_newton.converged)
      return last_newton.failure;
    for (const auto &interface : model.interfaces)
      {
        const MortarContact::StepAdvice advice = interface->advice();
        if (!advice.accept)
          return advice.reason;
      }
    goes_again = false;
    rate       = trial;
    rate -= u;
    rate *= 1. / (new_time - time);
    u = trial;
    return "";
  }


  template <int dim>
  ExitCode
  Simulation<dim>::run()
  {
    const StepParameters &s     = scene.steps;
    std::vector<double>   stops = s.times_to_meet;
    stops.push_back(s.end_time);
    stops.insert(stops.end(),
                 scene.refinement.times.begin(),
                 scene.refinement.times.end());
    std::sort(stops.begin(), stops.end());

    if (step == 0)
      {
        output.start(used_parameters);
        log.open(output.directory + "/run.log", false);
        report_setup();
        output.fields(model, u, time, step);
        begin_audit();
      }
    audit.u = u;
    wall.restart();
    const double first_time = time;
    // times closer than this are the same
    const double same   = 1e-10 * s.end_time;
    unsigned int cycles = 0; // of refinement, in this step

    while (time < s.end_time - same && step < s.max_steps)
      {
        double target = time + next_step;
        double stop   = s.end_time;
        for (const double t : stops)
          if (t > time + same)
            {
              stop = std::min(stop, t);
              break;
            }
        // rather two equal steps than a full and a tiny one
        if (target > stop - same)
          target = stop;
        else if (target > stop - 0.5 * next_step)
          target = 0.5 * (time + stop);

        target = safe_target(target);
        std::vector<Vector_t> start;
        if (scene.refinement.is_on())
          for (const Vector_t *v : kept_vectors())
            start.push_back(*v);
        const std::string failure = try_step(target);
        if (!failure.empty())
          {
            ++cut_backs;
            ++cut_backs_of_step;
            goes_again = false;
            for (const auto &interface : model.interfaces)
              interface->rollback();
            next_step = s.cut * (target - time);
            log.line("  step to " + number(target) + " rejected: " + failure +
                     "; cut back to " + number(next_step));
            if (next_step < s.smallest)
              {
                log.line(
                  "No convergence: the step fell below 'Smallest step', " +
                  number(s.smallest) + ". Last good state: time " +
                  number(time) + ".");
                show_last_state();
                save_checkpoint();
                write_summary("no convergence");
                return no_convergence;
              }
            if (stop_is_requested(communicator))
              {
                show_last_state();
                return stop_run();
              }
            continue;
          }

        if (cycles < scene.refinement.cycles &&
            scene.refinement.is_due(step + 1, target, same) &&
            refine_and_go_back(target, start))
          {
            ++cycles;
            continue;
          }
        cycles = 0;

        const double step_size = target - time;
        time                   = target;
        ++step;
        model.commit(u);
        for (unsigned int i = 0; i < model.interfaces.size(); ++i)
          {
            model.interfaces[i]->commit(time);
            if (model.interfaces[i]->report().active_pairs > 0 ||
                model.interfaces[i]->ties() != nullptr)
              has_touched[i] = 1;
          }
        if (last_newton.iterations <= s.target_iterations)
          next_step =
            std::min(s.largest, std::max(next_step, step_size) * s.growth);

        const double done = (time - first_time) / (s.end_time - first_time);
        std::string  text =
          "Step " + std::to_string(step) + "  time " + number(time) + "  " +
          std::to_string(last_newton.iterations) + " iterations  residual " +
          number(last_newton.residual, 2);
        if (cut_backs_of_step > 0)
          text += "  " + std::to_string(cut_backs_of_step) + " cut-backs";
        text += "  remaining about " +
                duration(wall.wall_time() * (1. - done) / done);
        log.line(text);
        for (const auto &interface : model.interfaces)
          {
            const auto &r     = interface->report();
            const auto  every = interface->parameters.report_every;
            log.line("  " + r.brief());
            if (every > 0 && step % every == 0 && r.relative_penetration > 0.8)
              for (const auto &w : r.worst)
                log.line(std::string("    WARNING: ") +
                         (w.relative > 1. ? "deeper than release" :
                                            "close to release") +
                         ": penetration " + number(w.penetration) + " (" +
                         number(100. * w.relative) + " %) of cell " +
                         std::to_string(w.secondary.cell) + " of '" +
                         w.secondary.part + "' into cell " +
                         std::to_string(w.primary.cell) + " of '" +
                         w.primary.part + "'");
          }

        if (resolution)
          {
            resolution->measure(model, u);
            for (const std::string &line : resolution->lines())
              log.line(line);
          }

        const bool is_last = time >= s.end_time - same || step >= s.max_steps;
        write_step(step_size, is_last);
        cut_backs_of_step = 0;
        if (after_step)
          after_step(*this);
        if (!is_last && stop_is_requested(communicator))
          return stop_run();
      }
    const bool is_whole = time >= s.end_time - same;
    write_summary(is_whole ? "finished" : "most steps");
    log.line(
      (is_whole ? "Finished: " :
                  "Ended by 'Maximum steps' at time " + number(time) + " of " +
                    number(s.end_time) + ": ") +
      std::to_string(step) + " steps, " + std::to_string(newton_iterations) +
      " iterations, " + std::to_string(cut_backs) + " cut-backs, " +
      duration(wall.wall_time()) + ". Results in '" + output.directory + "'.");
    return finished;
  }


  template <int dim>
  void
  Simulation<dim>::show_last_state()
  {
    model.integration.dt = 0.; // reactions are static
    (void)model.assemble(u, time, false);
    // history follows facets, not points: evaluated anew, friction is not quite
    // what was accepted
    for (const auto &interface : model.interfaces)
      interface->rollback();
  }


  template <int dim>
  ExitCode
  Simulation<dim>::stop_run()
  {
    save_checkpoint();
    write_summary("stopped");
    log.line("Stopped by a signal after step " + std::to_string(step) +
             ", time " + number(time) + ". Continue with --restart " +
             output.directory + ".");
    return stopped;
  }


  template <int dim>
  void
  Simulation<dim>::write_step(const double step_size, const bool is_last)
  {
    TimerOutput::Scope                          scope(timer, "output");
    std::vector<std::pair<std::string, double>> row = {
      {"step", step},
      {"time", time},
      {"step_size", step_size},
      {"iterations", last_newton.iterations},
      {"linear_iterations", last_newton.linear_iterations},
      {"cut_backs", cut_backs_of_step},
      {"residual_relative", last_newton.residual}};
    for (const auto &interface : model.interfaces)
      {
        const auto       &r = interface->report();
        const std::string n = interface->name + ":";
        for (unsigned int i = 0; i < dim; ++i)
          row.emplace_back(n + "force_" + "xyz"[i], r.force[i]);
        if (!r.force_on.empty())
          for (const auto &part : r.parts)
            for (unsigned int i = 0; i < dim; ++i)
              row.emplace_back(n + part.name + "_force_" + "xyz"[i],
                               part.force[i]);
        row.emplace_back(n + "largest_penetration", r.largest_penetration);
        row.emplace_back(n + "penetration_over_release",
                         r.relative_penetration);
        row.emplace_back(n + "mean_penetration", r.mean_penetration);
        row.emplace_back(n + "largest_pressure", r.largest_pressure);
        row.emplace_back(n + "largest_overlap", r.largest_overlap);
        row.emplace_back(n + "active_area", r.active_area);
        row.emplace_back(n + "active_pairs", r.active_pairs);
        row.emplace_back(n + "energy", r.energy);
        row.emplace_back(n + "released_facets", r.n_released);
        if (interface->parameters.friction.is_on())
          {
            row.emplace_back(n + "slip_area", r.slip_area);
            row.emplace_back(n + "friction_dissipation", r.dissipation);
            row.emplace_back(n + "elastic_slip", r.elastic_slip);
          }
        if (interface->ties() != nullptr)
          {
            row.emplace_back(n + "whole_tied_area", r.whole_tied_area);
            row.emplace_back(n + "failed_tied_area", r.failed_tied_area);
            row.emplace_back(n + "damage_dissipation", r.damage_dissipation);
            row.emplace_back(n + "largest_tie_jump", r.largest_tie_jump);
          }
        if (interface->parameters.augmentation.is_on)
          row.emplace_back(n + "augmentations_total", r.n_augmentations_total);
        row.emplace_back(n + "remaining_overlap_share",
                         MortarContact::removal_share(
                           interface->parameters.initial_penetration,
                           time,
                           interface->parameters.removal_time));
      }
    for (const auto &body : rigid_bodies)
      {
        const auto [force, moment] = resultant(*body);
        for (unsigned int i = 0; i < dim; ++i)
          row.emplace_back("rigid:" + body->name + "_force_" + "xyz"[i],
                           force[i]);
        for (unsigned int i = (dim == 2 ? 2 : 0); i < 3; ++i)
          row.emplace_back("rigid:" + body->name + "_moment_" + "xyz"[i],
                           moment[i]);
        if (body->has_dofs())
          {
            const Tensor<1, dim> moved  = body->displacement_of_centre();
            const Tensor<1, 3>   turned = body->rotation_vector();
            for (unsigned int i = 0; i < dim; ++i)
              row.emplace_back("rigid:" + body->name + "_motion_" + "xyz"[i],
                               moved[i]);
            for (unsigned int i = (dim == 2 ? 2 : 0); i < 3; ++i)
              row.emplace_back("rigid:" + body->name + "_rotation_" + "xyz"[i],
                               turned[i]);
          }
      }
    const double strain  = model.strain_energy(u);
    const double kinetic = model.is_dynamic() ? model.kinetic_energy() : 0.;
    audit_energy(kinetic + strain);
    row.emplace_back("strain_energy", strain);
    if (audit.is_possible)
      row.emplace_back("outer_work", audit.work);
    if (model.is_dynamic())
      {
        row.emplace_back("kinetic_energy", kinetic);
        const Tensor<1, 3> momentum = model.momentum();
        for (unsigned int i = 0; i < dim; ++i)
          row.emplace_back(std::string("momentum_") + "xyz"[i], momentum[i]);
      }
    const auto append = [&](const auto &values) {
      row.insert(row.end(), values.begin(), values.end());
    };
    if (model.fluid)
      append(model.fluid->record());
    if (resolution)
      append(resolution->record());
    for (unsigned int c = 0; c < model.conditions.size(); ++c)
      if (model.conditions[c].type == BoundaryCondition::Type::displacement ||
          model.conditions[c].type == BoundaryCondition::Type::symmetry)
        {
          const Tensor<1, 3> f = model.reaction(c);
          for (unsigned int i = 0; i < dim; ++i)
            row.emplace_back("reaction:" + model.conditions[c].name + "_" +
                               "xyz"[i],
                             f[i]);
        }
    for (unsigned int p = 0; p < scene.output.probes.size(); ++p)
      {
        const Tensor<1, dim> v = probe(p);
        for (unsigned int i = 0; i < dim; ++i)
          row.emplace_back("probe:" + scene.output.probes[p].name + "_" +
                             "xyz"[i],
                           v[i]);
      }
    output.history(row);

    const unsigned int every = scene.output.every;
    if (is_last || (every > 0 && step % every == 0))
      output.fields(model, u, time, step);
    const unsigned int save = scene.output.checkpoint_every;
    if (is_last || (save > 0 && step % save == 0))
      save_checkpoint();
  }


  template <int dim>
  void
  Simulation<dim>::begin_audit()
  {
    if (!audit.is_possible)
      return;
    audit.start = (model.is_dynamic() ? model.kinetic_energy() : 0.) +
                  model.strain_energy(u) + contact_energy();
    audit.largest = audit.start;
    audit.forces  = model.outer_forces();
  }


  template <int dim>
  double
  Simulation<dim>::contact_energy() const
  {
    double energy = 0.;
    for (const auto &interface : model.interfaces)
      {
        const auto &r = interface->report();
        energy += r.energy + r.dissipation + r.damage_dissipation;
      }
    return energy;
  }


  template <int dim>
  void
  Simulation<dim>::audit_energy(const double energy_of_bodies)
  {
    if (!audit.is_possible)
      return;
    const double   energy = energy_of_bodies + contact_energy();
    const Vector_t forces = model.outer_forces();
    Vector_t       mean = forces, motion = u;
    mean.sadd(0.5, 0.5, audit.forces);
    motion -= audit.u;
    audit.work += mean * motion;
    audit.largest       = std::max(audit.largest, energy);
    const double excess = energy - audit.start - audit.work;
    const double before = audit.growth;
    if (model.is_dynamic())
      audit.growth = std::max(audit.growth, excess / audit.scale());
    audit.error = std::max(audit.error, std::abs(excess));
    if (before <= large_energy_growth && audit.growth > large_energy_growth)
      log.line("  WARNING: there is " + number(100. * audit.growth, 2) +
               " % more energy than what was put in; steps are too long for "
               "what happens in them");
    audit.forces = forces;
    audit.u      = u;
  }


  template <int dim>
  void
  Simulation<dim>::write_summary(const std::string &status)
  {
    // wall times of all ranks, slowest, by name
    auto times = timer.get_summary_data(TimerOutput::total_wall_time);
    for (auto &[name, seconds] : times)
      seconds = Utilities::MPI::max(seconds, communicator);
    Utilities::System::MemoryStats memory;
    Utilities::System::get_memory_stats(memory);
    const double peak =
      Utilities::MPI::sum(static_cast<double>(memory.VmHWM), communicator);

    RunFigures run;
    run.strain_energy = model.strain_energy(u);
    run.steps         = step;
    run.iterations    = newton_iterations;
    run.cut_backs     = cut_backs;
    run.predicts      = scene.newton.predicts;
    run.is_static     = !model.is_dynamic();
    run.energy_growth = audit.growth;
    if (const auto contact = times.find("contact: search and evaluation");
        contact != times.end())
      run.contact_seconds = contact->second;
    run.all_seconds = wall.wall_time();
    for (const auto &interface : model.interfaces)
      run.interfaces.push_back({interface->name,
                                &interface->parameters,
                                interface->report().energy,
                                interface->integration_error(),
                                interface->is_on_obstacle(),
                                has_touched[run.interfaces.size()] != 0,
                                interface->report().smallest_gap});

    nlohmann::json json;
    json["status"]            = status;
    json["version"]           = "0.1.0";
    json["deal.II version"]   = DEAL_II_PACKAGE_VERSION;
    json["ranks"]             = Utilities::MPI::n_mpi_processes(communicator);
    json["dofs"]              = model.n_dofs();
    json["steps"]             = step;
    json["time"]              = time;
    json["newton_iterations"] = newton_iterations;
    json["linear_iterations"] = linear_iterations;
    json["cut_backs"]         = cut_backs;
    json["matrix_patterns"]   = model.n_patterns;
    json["multigrid_setups"]  = linear_solver.n_setups();
    json["peak_memory_kB"]    = peak;
    json["wall_seconds"]      = wall.wall_time();
    json["strain_energy"]     = run.strain_energy;
    if (audit.is_possible)
      json[model.is_dynamic() ? "energy_growth" : "energy_error"] =
        model.is_dynamic() ? audit.growth : audit.error / audit.scale();
    json["parameters_hash"] = std::hash<std::string>()(used_parameters);
    for (const auto &[name, seconds] : times)
      json["seconds"][name] = seconds;
    for (unsigned int i = 0; i < model.interfaces.size(); ++i)
      {
        const auto     &r      = model.interfaces[i]->report();
        nlohmann::json &j      = json["interfaces"][model.interfaces[i]->name];
        j["penalty_share"]     = penalty_share(run, run.interfaces[i]);
        j["integration_error"] = run.interfaces[i].integration_error;
        j["balance_error"]     = model.interfaces[i]->check_balance();
        j["force"]             = {r.force[0], r.force[1], r.force[2]};
        j["moment"]            = {r.moment[0], r.moment[1], r.moment[2]};
        j["largest_penetration"]         = r.largest_penetration;
        j["penetration_over_release"]    = r.relative_penetration;
        j["mean_penetration"]            = r.mean_penetration;
        j["largest_pressure"]            = r.largest_pressure;
        j["largest_overlap"]             = r.largest_overlap;
        j["active_area"]                 = r.active_area;
        j["energy"]                      = r.energy;
        j["released_facets"]             = r.n_released;
        j["slip_area"]                   = r.slip_area;
        j["friction_dissipation"]        = r.dissipation;
        j["elastic_slip"]                = r.elastic_slip;
        j["tied_area"]                   = r.initial.tied_area;
        j["whole_tied_area"]             = r.whole_tied_area;
        j["failed_tied_area"]            = r.failed_tied_area;
        j["damage_dissipation"]          = r.damage_dissipation;
        j["largest_tie_jump"]            = r.largest_tie_jump;
        j["augmentations"]               = r.n_augmentations_total;
        j["search_seconds"]              = r.search_seconds;
        j["evaluate_seconds"]            = r.evaluate_seconds;
        j["initial_penetrating_facets"]  = r.initial.n_facets;
        j["initial_deepest_penetration"] = r.initial.deepest.penetration;
        j["initial_undetected_facets"]   = r.initial.n_undetected;
      }
    if (model.fluid)
      for (const auto &[name, value] : model.fluid->record())
        json["fluid"][name.substr(name.find(':') + 1)] = value;
    for (const auto &body : rigid_bodies)
      {
        const auto [force, moment]                 = resultant(*body);
        json["rigid_bodies"][body->name]["force"]  = {force[0],
                                                      force[1],
                                                      force[2]};
        json["rigid_bodies"][body->name]["moment"] = {moment[0],
                                                      moment[1],
                                                      moment[2]};
      }
    for (unsigned int c = 0; c < model.conditions.size(); ++c)
      if (model.conditions[c].type == BoundaryCondition::Type::displacement)
        {
          const Tensor<1, 3> f                        = model.reaction(c);
          json["reactions"][model.conditions[c].name] = {f[0], f[1], f[2]};
        }
    for (unsigned int p = 0; p < scene.output.probes.size(); ++p)
      {
        const Tensor<1, dim> v = probe(p);
        for (unsigned int i = 0; i < dim; ++i)
          json["probes"][scene.output.probes[p].name].push_back(v[i]);
      }
    output.text_file("summary.json", json.dump(2) + "\n");

    std::ostringstream table;
    table << std::fixed << std::setprecision(1);
    for (const auto &[name, seconds] : times)
      table << "  " << std::left << std::setw(34) << name << std::right
            << std::setw(8) << seconds << " s\n";
    table << "  peak memory " << peak / 1e6 << " GB";
    if (linear_solver.n_setups() > 0)
      table << "; matrix patterns: " << model.n_patterns
            << ", multigrid set-ups: " << linear_solver.n_setups();
    const unsigned int n_ranks = Utilities::MPI::n_mpi_processes(communicator);
    for (const auto &interface : model.interfaces)
      {
        const auto  &r     = interface->report();
        const double pairs = r.active_pairs + r.open_pairs;
        if (n_ranks > 1 && pairs > 0.)
          table << "\n  balance of '" << interface->name
                << "': " << std::setprecision(2)
                << r.busiest_rank_pairs * n_ranks / pairs
                << " times the mean of the ranks' pairs in the busiest";
      }
    log.line(table.str());
    for (const std::string &sentence : advice(run))
      log.line(sentence);
  }


  template class Simulation<2>;
  template class Simulation<3>;
} // namespace Structure

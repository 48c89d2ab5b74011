// SPDX-License-Identifier: LGPL-2.1-or-later

// How a run is saved and continued, and how its state goes to finer meshes.

#include "checkpoint.h"
#include "simulation.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

namespace Structure
{
  template <int dim>
  std::vector<Vector<double>>
  Simulation<dim>::values_by_body(const Vector_t &v) const
  {
    const Vector<double>        all(v);
    std::vector<Vector<double>> result;
    for (const auto &b : model.bodies)
      {
        result.emplace_back(b->n_dofs());
        for (types::global_dof_index i = 0; i < b->n_dofs(); ++i)
          result.back()(i) = all(b->numbering(i));
      }
    result.emplace_back(model.rigid_dofs.size() * RigidDofs<dim>::n);
    for (unsigned int r = 0; r < model.rigid_dofs.size(); ++r)
      for (unsigned int i = 0; i < RigidDofs<dim>::n; ++i)
        result.back()(r * RigidDofs<dim>::n + i) =
          all(model.rigid_dofs[r].first() + i);
    return result;
  }


  template <int dim>
  void
  Simulation<dim>::set_values_by_body(const std::vector<Vector<double>> &values,
                                      Vector_t                          &v)
  {
    const auto set = [&](const types::global_dof_index dof,
                         const double                  value) {
      if (model.owned_dofs().is_element(dof))
        v(dof) = value;
    };
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      for (types::global_dof_index i = 0; i < values[b].size(); ++i)
        set(model.bodies[b]->numbering(i), values[b](i));
    for (unsigned int r = 0; r < model.rigid_dofs.size(); ++r)
      for (unsigned int i = 0; i < RigidDofs<dim>::n; ++i)
        set(model.rigid_dofs[r].first() + i,
            values.back()(r * RigidDofs<dim>::n + i));
    v.compress(VectorOperation::insert);
  }


  template <int dim>
  void
  Simulation<dim>::check_refinement() const
  {
    if (!scene.refinement.is_on())
      return;
    AssertThrow(!scene.valve.is_on,
                ExcMessage("'Refinement' is on, but there is a fluid; expected "
                           "one of them."));
    std::string able;
    for (const auto &b : model.bodies)
      if (b->can_be_refined())
        able += (able.empty() ? "'" : ", '") + b->name + "'";
    for (const std::string &name : scene.refinement.bodies)
      AssertThrow(model.body(name).can_be_refined(),
                  ExcMessage("'Refinement/Bodies' has '" + name +
                             "', which cannot be refined; expected solids of "
                             "hexahedra (quadrilaterals): " +
                             (able.empty() ? "there are none" : able) + "."));
    AssertThrow(!able.empty(),
                ExcMessage("'Refinement' is on, but no body can be refined; "
                           "expected a solid of hexahedra (quadrilaterals)."));
  }


  template <int dim>
  bool
  Simulation<dim>::refine_and_go_back(const double                 new_time,
                                      const std::vector<Vector_t> &start)
  {
    TimerOutput::Scope             scope(timer, "refinement");
    const std::vector<std::string> flags =
      mark_cells(model, u, scene.refinement);
    if (flags.empty())
      return false;

    // where this step has led is the best guess of its end
    goes_again                            = true;
    const std::vector<Vector_t *> vectors = kept_vectors();
    for (std::size_t i = 0; i < vectors.size(); ++i)
      if (vectors[i] != &rate)
        *vectors[i] = start[i];
    std::vector<std::string> histories;
    for (const auto &interface : model.interfaces)
      {
        std::ostringstream out;
        interface->save(out);
        histories.push_back(out.str());
      }
    std::vector<std::vector<Vector<double>>> values; // [vector][body]
    for (const Vector_t *v : vectors)
      values.push_back(values_by_body(*v));

    unsigned int n_before = 0, n_after = 0;
    for (unsigned int b = 0; b < model.bodies.size(); ++b)
      {
        n_before += model.bodies[b]->n_cells();
        if (flags[b].empty())
          {
            n_after += model.bodies[b]->n_cells();
            continue;
          }
        std::vector<Vector<double>> of_body;
        for (const auto &v : values)
          of_body.push_back(v[b]);
        of_body = model.bodies[b]->refine(flags[b], of_body);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i][b] = of_body[i];
        n_after += model.bodies[b]->n_cells();
      }
    refinements.push_back(flags);
    connect();
    for (std::size_t i = 0; i < vectors.size(); ++i)
      {
        set_values_by_body(values[i], *vectors[i]);
        model.make_conforming(*vectors[i]); // where cells were coarsened
      }
    for (unsigned int i = 0; i < model.interfaces.size(); ++i)
      {
        std::istringstream in(histories[i]);
        model.interfaces[i]->load(in, u);
      }
    if (model.is_dynamic())
      model.resume_motion(u, time);
    std::ostringstream text;
    text << "  refined: " << n_before << " to " << n_after << " cells, "
         << model.n_dofs() << " dofs; step to " << new_time << " again";
    log.line(text.str());
    return true;
  }


  template <int dim>
  void
  Simulation<dim>::save_checkpoint()
  {
    Checkpoint c; // the same on all ranks
    c.parameters        = used_parameters;
    c.time              = time;
    c.next_step         = next_step;
    c.step              = step;
    c.cut_backs         = cut_backs;
    c.newton_iterations = newton_iterations;
    c.linear_iterations = linear_iterations;
    c.refinements       = refinements;
    c.has_touched       = has_touched;
    c.energies          = {
               audit.start, audit.work, audit.largest, audit.growth, audit.error};
    const auto dofs = dofs_in_order();
    for (const Vector_t *v : saved_vectors())
      {
        const Vector<double> all(*v);
        c.vectors.emplace_back();
        for (const auto dof : dofs)
          c.vectors.back().push_back(all(dof));
      }
    for (const auto &b : model.bodies)
      c.histories.push_back(b->history());
    if (model.fluid)
      c.fluid = model.fluid->history();
    for (const auto &interface : model.interfaces)
      {
        std::ostringstream out;
        interface->save(out);
        c.interfaces.push_back(out.str());
      }
    write_checkpoint(c, output.directory, communicator);
  }


  template <int dim>
  std::vector<types::global_dof_index>
  Simulation<dim>::dofs_in_order() const
  {
    std::vector<types::global_dof_index> result;
    for (const auto &b : model.bodies)
      {
        const auto of_body = b->dofs_in_order();
        result.insert(result.end(), of_body.begin(), of_body.end());
      }
    for (const auto &rigid : model.rigid_dofs)
      for (unsigned int i = 0; i < RigidDofs<dim>::n; ++i)
        result.push_back(rigid.first() + i);
    return result;
  }


  template <int dim>
  void
  Simulation<dim>::restart(const std::string &directory)
  {
    const Checkpoint c = read_checkpoint(directory, communicator);

    // Step 1: the meshes.
    const auto fits = [&](const bool ok, const std::string &what) {
      AssertThrow(ok,
                  ExcMessage("The checkpoint in '" + directory +
                             "' belongs to another scene: " + what + "."));
    };
    if (!c.refinements.empty() && !scene.refinement.is_on())
      make_bodies(/* whole_meshes = */ true);
    for (const auto &flags : c.refinements)
      {
        fits(flags.size() == model.bodies.size(), "it has other bodies");
        for (unsigned int b = 0; b < flags.size(); ++b)
          if (!flags[b].empty())
            (void)model.bodies[b]->refine(flags[b], {});
      }
    refinements = c.refinements;
    if (!refinements.empty())
      connect();

    // Step 2: the state.
    const std::vector<Vector_t *> vectors = saved_vectors();
    const auto                    dofs    = dofs_in_order();
    fits(c.vectors.size() == vectors.size() &&
           c.histories.size() == model.bodies.size() &&
           c.interfaces.size() == model.interfaces.size(),
         "it has other bodies, interfaces or dynamics");
    for (const auto &values : c.vectors)
      fits(values.size() == dofs.size(),
           "it has " + std::to_string(values.size()) + " dofs, this one has " +
             std::to_string(dofs.size()));
    for (std::size_t k = 0; k < vectors.size(); ++k)
      {
        for (std::size_t i = 0; i < dofs.size(); ++i)
          if (model.owned_dofs().is_element(dofs[i]))
            (*vectors[k])(dofs[i]) = c.vectors[k][i];
        vectors[k]->compress(VectorOperation::insert);
      }
    for (std::size_t b = 0; b < c.histories.size(); ++b)
      model.bodies[b]->restore(c.histories[b]);
    fits(c.fluid.empty() == !model.fluid, "one has a fluid, one has none");
    if (model.fluid)
      model.fluid->restore(c.fluid);
    for (std::size_t i = 0; i < c.interfaces.size(); ++i)
      {
        std::istringstream in(c.interfaces[i]);
        model.interfaces[i]->load(in, u);
      }
    fits(c.has_touched.size() == has_touched.size() && c.energies.size() == 5,
         "they differ in interfaces");
    has_touched       = c.has_touched;
    audit.start       = c.energies[0];
    audit.work        = c.energies[1];
    audit.largest     = c.energies[2];
    audit.growth      = c.energies[3];
    audit.error       = c.energies[4];
    time              = c.time;
    next_step         = c.next_step;
    step              = c.step;
    cut_backs         = c.cut_backs;
    newton_iterations = c.newton_iterations;
    linear_iterations = c.linear_iterations;
    if (model.is_dynamic())
      {
        model.integration.u_n = u;
        model.integration.dt  = 0.;
      }
    (void)model.assemble(u, time, false);

    // Step 3: the files. The same folder by whatever name: they are kept.
    std::error_code error;
    const bool      same_folder = Utilities::MPI::broadcast(
      communicator,
      std::filesystem::equivalent(directory, output.directory, error));
    if (same_folder)
      output.resume(time);
    else
      output.start(used_parameters);
    log.open(output.directory + "/run.log", same_folder);
    if (c.parameters != used_parameters)
      log.line("NOTE: the parameters differ from those of the checkpoint.");
    std::ostringstream text;
    text << "Restarted from '" << directory << "': step " << step << ", time "
         << time;
    log.line(text.str());
  }


  template std::vector<Vector<double>>
  Simulation<2>::values_by_body(const Vector_t &) const;
  template void
  Simulation<2>::set_values_by_body(const std::vector<Vector<double>> &,
                                    Vector_t &);
  template void
  Simulation<2>::check_refinement() const;
  template bool
  Simulation<2>::refine_and_go_back(const double,
                                    const std::vector<Vector_t> &);
  template void
  Simulation<2>::save_checkpoint();
  template std::vector<types::global_dof_index>
  Simulation<2>::dofs_in_order() const;
  template void
  Simulation<2>::restart(const std::string &);
  template std::vector<Vector<double>>
  Simulation<3>::values_by_body(const Vector_t &) const;
  template void
  Simulation<3>::set_values_by_body(const std::vector<Vector<double>> &,
                                    Vector_t &);
  template void
  Simulation<3>::check_refinement() const;
  template bool
  Simulation<3>::refine_and_go_back(const double,
                                    const std::vector<Vector_t> &);
  template void
  Simulation<3>::save_checkpoint();
  template std::vector<types::global_dof_index>
  Simulation<3>::dofs_in_order() const;
  template void
  Simulation<3>::restart(const std::string &);
} // namespace Structure

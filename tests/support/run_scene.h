// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_tests_run_scene_h
#define mortar_contact_tests_run_scene_h

// Scenes as text, built and run in tests.

#include <structure/simulation.h>
#include <structure/solid_body.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace Test
{
  using namespace dealii;
  using namespace Structure;

  /// A number with all its digits.
  inline std::string
  num(const double x)
  {
    std::ostringstream out;
    out.precision(17);
    out << x;
    return out.str();
  }

  /// A subsection with entries "Name = value; Name = value"; '|' separates
  /// entries so that values may hold commas and semicolons.
  inline std::string
  section(const std::string &name, const std::string &entries)
  {
    std::string text = "subsection " + name + "\n";
    for (const std::string &entry : Utilities::split_string_list(entries, '|'))
      text += (entry.find('=') == std::string::npos ||
               entry.find('\n') != std::string::npos) ?
                entry + "\n" :
                "set " + entry + "\n";
    return text + "end\n";
  }

  inline std::string
  body(const std::string &name,
       const std::string &mesh,
       const std::string &material,
       const std::string &more = "")
  {
    std::string text = "subsection Bodies\nsubsection " + name + "\n" +
                       section("Mesh", mesh) + section("Material", material);
    for (const std::string &entry : Utilities::split_string_list(more, '|'))
      text += "set " + entry + "\n";
    return text + "end\nend\n";
  }

  inline std::string
  condition(const std::string &name, const std::string &entries)
  {
    return "subsection Boundary conditions\n" + section(name, entries) +
           "end\n";
  }

  inline std::string
  interface(const std::string &name, const std::string &entries)
  {
    return "subsection Contact\n" + section(name, entries) + "end\n";
  }

  /// A rigid body; several need a line of names of their own.
  inline std::string
  rigid(const std::string &name, const std::string &entries)
  {
    return "subsection Rigid bodies\nset Names = " + name + "\n" +
           section(name, entries) + "end\n";
  }

  inline std::string
  names(const std::string &bodies,
        const std::string &conditions,
        const std::string &interfaces,
        const std::string &probes = "")
  {
    return section("Bodies", "Names = " + bodies) +
           section("Boundary conditions", "Names = " + conditions) +
           section("Contact", "Interfaces = " + interfaces) +
           section("Probes", "Names = " + probes);
  }

  inline std::string
  probe(const std::string &name,
        const std::string &of,
        const std::string &point)
  {
    return "subsection Probes\n" +
           section(name, "Body = " + of + "|Point = " + point) + "end\n";
  }

  /// Steps and solver of a test: tight, in one step unless said otherwise.
  inline std::string
  solver(const double tolerance = 1e-12, const double first_step = 1.)
  {
    std::ostringstream out;
    out << "subsection Solver\nsubsection Newton\nset Force tolerance = "
        << tolerance
        << "\nend\nend\nsubsection Steps\nset First step = " << first_step
        << "\nend\n";
    return out.str();
  }

  /// The scene of a text, on the ranks of a communicator. Collections of
  /// numbers are checked by the caller.
  template <int dim>
  std::unique_ptr<Simulation<dim>>
  make(const std::string &text,
       Log               &log,
       const MPI_Comm     communicator = MPI_COMM_WORLD)
  {
    const auto *info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name =
      std::string(info->test_suite_name()) + "." + info->name();
    for (char &c : name)
      if (c == '/')
        c = '_';
    const std::string file = "scene-" + name + ".prm";
    // one rank writes what all read
    MPI_Barrier(communicator);
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      std::ofstream(file) << "set Dimension = " << dim << "\n"
                          << text
                          << "subsection Output\nset Directory = output-"
                          << name
                          << "\nset Every = 0\nset Checkpoint every = 0\nend\n";
    MPI_Barrier(communicator);
    SceneSource source;
    source.file   = file;
    source.driver = "contact_scene";
    std::string used;
    const Scene scene = read_scene(source, used);
    auto        simulation =
      std::make_unique<Simulation<dim>>(scene, used, communicator, log);
    simulation->setup();
    return simulation;
  }

  template <int dim>
  std::unique_ptr<Simulation<dim>>
  run(const std::string &text, const bool show = false)
  {
    Log  log(MPI_COMM_WORLD, !show);
    auto simulation = make<dim>(text, log);
    EXPECT_EQ(simulation->run(), finished);
    return simulation;
  }

  /// Mean Cauchy stress of every cell of a body, with the cell's centre.
  template <int dim, class Function>
  void
  for_each_cell(const Simulation<dim> &s,
                const std::string     &name,
                const Function        &function)
  {
    const Vector_t                       ghosted = s.model.ghosted(s.u);
    Vector<double>                       values;
    std::vector<types::global_dof_index> dofs;
    for (const auto &b : s.model.bodies)
      if (b->name == name)
        {
          auto &body = dynamic_cast<SolidBody<dim> &>(*b);
          for (unsigned int cell = 0; cell < body.n_local_cells(); ++cell)
            {
              s.model.cell_values(body, cell, ghosted, values, dofs);
              body.energy(cell, values);
              function(body.centre_of(cell), body.state());
            }
        }
  }
} // namespace Test

#endif

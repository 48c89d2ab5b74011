// SPDX-License-Identifier: LGPL-2.1-or-later

// Elastic leaflets in the flow through a channel, in the plane: a valve that
// opens, closes, and whose leaflets come into contact.

#include "immersed/immersed_flow.h"
#include "structure/driver.h"

#include <iostream>
#include <sstream>

namespace
{
  using namespace Immersed;

  void
  declare(ParameterHandler &prm)
  {
    prm.declare_entry("Driver", "immersed_leaflets", Patterns::Anything(), "");
    Parameters::declare(prm);
  }


  Structure::ExitCode
  run(const Structure::Task &task,
      Structure::ExitCode   &stage,
      std::string           &directory)
  {
    AssertThrow(Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD) == 1,
                ExcMessage("immersed_leaflets runs on one rank; start it "
                           "without mpirun."));
    {
      // a file of another driver, before its entries are found unknown
      ParameterHandler prm;
      prm.declare_entry("Driver", "", Patterns::Anything());
      Structure::parse(prm, task.source, true);
    }
    ParameterHandler prm;
    declare(prm);
    Structure::parse(prm, task.source, false);
    const std::string used = Structure::used_entries(prm, task.source);
    if (task.print_only)
      {
        std::cout << used;
        return Structure::finished;
      }
    Parameters parameters;
    parameters.read(prm);
    directory = parameters.directory;

    Structure::Log log(MPI_COMM_WORLD, task.quiet);
    log.line("immersed_leaflets " + task.source.file);
    ImmersedFlow flow(parameters, used, log);
    if (task.check_only)
      {
        flow.report_setup();
        log.line("The scene is complete; not solved (--check).");
        return Structure::finished;
      }
    if (!task.restart.empty())
      flow.restart(task.restart);
    stage = Structure::internal_error;
    return flow.run();
  }
} // namespace


int
main(int argc, char **argv)
{
  Structure::Program program;
  program.name        = "immersed_leaflets";
  program.is_parallel = false;
  program.description =
    "Elastic leaflets in an incompressible flow, with contact, in the plane.";
  program.defaults = []() {
    ParameterHandler prm;
    declare(prm);
    std::ostringstream out;
    prm.print_parameters(out, ParameterHandler::PRM);
    return out.str();
  };
  program.run = run;
  return Structure::run_program(program, argc, argv);
}

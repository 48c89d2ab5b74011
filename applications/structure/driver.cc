// SPDX-License-Identifier: LGPL-2.1-or-later
#include "driver.h"

#include "accuracy.h"
#include "features.h"
#include "simulation.h"
#include "stop_signal.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <sstream>
#include <thread>

namespace Structure
{
  namespace
  {
    /// The message of an exception without deal.II's banner and stack.
    std::string
    message_of(const std::exception &e)
    {
      std::string text = e.what();
      if (const auto *ours = dynamic_cast<const ExceptionBase *>(&e))
        {
          std::ostringstream info;
          ours->print_info(info);
          text = info.str();
        }
      return Utilities::trim(text);
    }

    /**
     * Say what went wrong, once. All ranks come here when all of them saw it;
     * where only some did, the others wait for them somewhere else: then the
     * run is aborted rather than left hanging.
     */
    ExitCode
    fail(const ExitCode code, const std::string &message)
    {
      const unsigned int rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      if (rank == 0)
        std::cerr << message << std::endl;
      MPI_Request request;
      int         all_here = 0;
      MPI_Ibarrier(MPI_COMM_WORLD, &request);
      for (unsigned int i = 0; i < 100 && all_here == 0; ++i)
        {
          MPI_Test(&request, &all_here, MPI_STATUS_IGNORE);
          if (all_here == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
      if (all_here == 0)
        {
          if (rank != 0)
            std::cerr << message << " (rank " << rank << ")" << std::endl;
          MPI_Abort(MPI_COMM_WORLD, code);
        }
      return code;
    }

    /// Pictures and a page of a run, by the scripts beside the sources.
    void
    make_pictures(const std::string &driver,
                  const std::string &directory,
                  Log               &log)
    {
      const std::string script =
        (driver == "rubber_fit")        ? "pictures.py" :
        (driver == "dummy_on_hood")     ? "hood_pictures.py" :
        (driver == "shell_leaflet")     ? "valve_pictures.py" :
        (driver == "immersed_leaflets") ? "flow_pictures.py" :
                                          "plot_run.py";
      std::string quoted;
      for (const char c : directory)
        quoted += (c == '\'') ? "'\\''" : std::string(1, c);
      for (const std::string &name : {script, std::string("report.py")})
        {
          const std::string command = "/usr/bin/python3 '" +
                                      std::string(MORTAR_CONTACT_SCRIPTS) +
                                      "/" + name + "' '" + quoted + "'";
          if (std::system(command.c_str()) != 0)
            log.line("WARNING: no pictures: '" + command + "' failed.");
        }
    }

    /// @param stage What a failure means from now on.
    template <int dim>
    ExitCode
    run_scene(const Scene       &scene,
              const std::string &used,
              const std::string &restart,
              const bool         check_only,
              Log               &log,
              ExitCode          &stage)
    {
      Simulation<dim> simulation(scene, used, MPI_COMM_WORLD, log);
      simulation.setup();
      if (check_only)
        {
          simulation.report_setup();
          log.line(text_of(features(scene)));
          log.line("The scene is complete; not solved (--check).");
          return finished;
        }
      if (!restart.empty())
        simulation.restart(restart);
      stage = internal_error;
      return simulation.run();
    }
  } // namespace


  Driver
  make_driver(const std::string                              &name,
              const std::string                              &description,
              const std::function<void(ParameterHandler &)>  &declare,
              const std::function<Scene(ParameterHandler &)> &read)
  {
    const auto declare_all = [name, declare](ParameterHandler &prm) {
      prm.declare_entry("Driver", name, Patterns::Anything(), "");
      declare_accuracy(prm);
      declare(prm);
    };
    Driver driver;
    driver.name        = name;
    driver.description = description;
    driver.read        = [declare_all, read](const SceneSource &source,
                                      std::string       &used) {
      std::string accuracy;
      {
        // a file of another driver, before its entries are found unknown
        ParameterHandler prm;
        prm.declare_entry("Driver", "", Patterns::Anything());
        declare_accuracy(prm);
        parse(prm, source, true);
        accuracy = prm.get("Accuracy");
      }
      ParameterHandler prm;
      declare_all(prm);
      set_accuracy(prm, accuracy, {{"Contact"}});
      parse(prm, source, false);
      const Scene scene = read(prm);
      used              = used_entries(prm, source);
      return scene;
    };
    driver.defaults = [declare_all]() {
      ParameterHandler prm;
      declare_all(prm);
      std::ostringstream out;
      prm.print_parameters(out, ParameterHandler::PRM);
      return out.str();
    };
    return driver;
  }


  int
  run_program(const Program &program, int argc, char **argv)
  {
    // a user's mistake is no reason for a stack trace
    deal_II_exceptions::suppress_stacktrace_in_exceptions();
    Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    catch_stop_signals();
    const bool is_root = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;

    CLI::App    app(program.description, program.name);
    Task        task;
    std::string output;
    bool        pictures = false;
    task.source.driver   = program.name;
    app.add_option("FILE", task.source.file, "Parameter file (.prm, or .json)");
    app
      .add_option("--set",
                  task.source.settings,
                  "\"Section/Sub section/Entry=value\", after the file; may be "
                  "given several times")
      ->expected(1)
      ->take_all();
    app.add_option("--output", output, "Folder for the results");
    app.add_option("--restart",
                   task.restart,
                   "Continue the run in this folder");
    app.add_flag("--print-parameters",
                 task.print_only,
                 "Print the annotated defaults; "
                 "with FILE what it changes of them");
    app.add_flag("--check",
                 task.check_only,
                 "Read, build and report, do not solve");
    app.add_flag("--pictures",
                 pictures,
                 "At the end make pictures and report.html (needs the source "
                 "tree, VTK and matplotlib for Python)");
    app.add_flag("--quiet", task.quiet, "Nothing on the terminal but errors");
    app.set_version_flag("--version", "MortarContact 0.1.0");
    app.footer(
      "Examples:\n"
      "  " +
      program.name +
      " scene.prm --check          what the scene has, without solving\n"
      "  " +
      program.name + " scene.prm --set \"Steps/First step=0.01\"\n" +
      (program.is_parallel ? "  mpirun -np 2 " + program.name + " scene.prm\n" :
                             "") +
      "  " + program.name +
      " scene.prm --restart output continue where a run ended\n"
      "Exit codes: 0 finished, 1 wrong input, 2 no convergence (last state "
      "saved),\n"
      "3 internal error, 4 stopped by a signal (saved).\n"
      "Tutorials: prm/tutorial. All entries: --print-parameters. What to do "
      "when a run\n"
      "fails: doc/when_it_does_not_converge.md.");
    try
      {
        app.parse(argc, argv);
      }
    catch (const CLI::ParseError &e)
      {
        const bool asked = e.get_exit_code() == 0;
        if (is_root)
          app.exit(e);
        return asked ? finished : wrong_input;
      }
    if (task.print_only && task.source.file.empty())
      {
        if (is_root)
          std::cout << program.defaults();
        return finished;
      }
    task.source.only_changed = task.print_only;

    // Everything up to the first step that fails is the input's fault.
    ExitCode stage = wrong_input;
    try
      {
        AssertThrow(!task.source.file.empty(),
                    ExcMessage("No parameter file given; expected " +
                               program.name + " FILE.prm. See --help."));
        // a run goes on in its folder
        if (output.empty())
          output = task.restart;
        if (!output.empty())
          task.source.settings.push_back("Output/Directory=" + output);
        std::string    directory;
        const ExitCode code = program.run(task, stage, directory);
        if (code == finished && !task.check_only && !task.print_only &&
            pictures && is_root)
          {
            Log log(MPI_COMM_WORLD, task.quiet);
            make_pictures(program.name, directory, log);
          }
        return code;
      }
    catch (const ExcMessage &e)
      {
        return fail(wrong_input, "ERROR: " + message_of(e));
      }
    catch (const std::exception &e)
      {
        return fail(stage,
                    (stage == internal_error ? "Internal error: " : "ERROR: ") +
                      message_of(e));
      }
    catch (...)
      {
        return fail(internal_error, "Internal error: unknown exception");
      }
  }


  int
  run_driver(const Driver &driver, int argc, char **argv)
  {
    Program program;
    program.name        = driver.name;
    program.description = driver.description;
    program.defaults    = driver.defaults;
    program.run         = [&](const Task  &task,
                      ExitCode    &stage,
                      std::string &directory) {
      std::string used;
      const Scene scene = driver.read(task.source, used);
      directory         = scene.output.directory;
      Log log(MPI_COMM_WORLD, task.quiet);
      if (task.print_only)
        {
          if (log.is_root)
            std::cout << used;
          return finished;
        }
      log.line(driver.name + " " + task.source.file);
      const ExitCode code =
        (scene.dimension == 2) ?
                  run_scene<2>(scene, used, task.restart, task.check_only, log, stage) :
                  run_scene<3>(scene, used, task.restart, task.check_only, log, stage);
      if (code == finished && !task.check_only && driver.finish)
        driver.finish(directory, MPI_COMM_WORLD);
      return code;
    };
    return run_program(program, argc, argv);
  }
} // namespace Structure

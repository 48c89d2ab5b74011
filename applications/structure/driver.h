// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_driver_h
#define mortar_contact_structure_driver_h

#include "scene.h"
#include "simulation.h"

#include <functional>
#include <string>

namespace Structure
{
  /// What makes a driver: its name, and how it reads its parameter files.
  struct Driver
  {
    std::string name;
    std::string description;
    /// @param used All entries as used.
    std::function<Scene(const SceneSource &source, std::string &used)> read;
    /// The annotated defaults.
    std::function<std::string()> defaults;
    /// Called after a finished run, on all ranks, to add to the results.
    std::function<void(const std::string &directory, const MPI_Comm)> finish;
  };

  /// What the command line asks a program to do with its parameter file.
  struct Task
  {
    SceneSource source;
    std::string restart; ///< Folder to go on from; empty: none.
    bool        print_only = false, check_only = false, quiet = false;
  };

  /// A program that reads a parameter file and runs, whatever it solves.
  struct Program
  {
    std::string name;
    std::string description;
    bool        is_parallel = true; ///< Several ranks may run it.
    /// The annotated defaults.
    std::function<std::string()> defaults;
    /**
     * Read and run. Exceptions are the input's fault until @p stage is set to
     * internal_error.
     * @param directory Becomes the folder of the results.
     */
    std::function<
      ExitCode(const Task &task, ExitCode &stage, std::string &directory)>
      run;
  };

  /**
   * The main function of all programs: command line, reading, running, errors.
   *   APP FILE.prm [--set "Section/Entry=value"]... [--output DIR]
   *     [--restart DIR] [--print-parameters] [--check] [--quiet] [--help]
   *     [--version]
   * @return The exit code, see ExitCode.
   */
  int
  run_program(const Program &program, int argc, char **argv);

  /**
   * A driver whose entries can all be declared beforehand; 'Driver' itself is
   * declared and checked here.
   */
  Driver
  make_driver(const std::string                              &name,
              const std::string                              &description,
              const std::function<void(ParameterHandler &)>  &declare,
              const std::function<Scene(ParameterHandler &)> &read);

  /// run_program() for a driver of scenes.
  int
  run_driver(const Driver &driver, int argc, char **argv);
} // namespace Structure

#endif

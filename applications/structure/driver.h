// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_driver_h
#define mortar_contact_structure_driver_h

#include "scene.h"

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

  /**
   * A driver whose entries can all be declared beforehand; 'Driver' itself is
   * declared and checked here.
   */
  Driver
  make_driver(const std::string                              &name,
              const std::string                              &description,
              const std::function<void(ParameterHandler &)>  &declare,
              const std::function<Scene(ParameterHandler &)> &read);

  /**
   * The main function of all drivers: command line, reading, running, errors.
   *   APP FILE.prm [--set "Section/Entry=value"]... [--output DIR]
   *     [--restart DIR] [--print-parameters] [--check] [--quiet] [--help]
   *     [--version]
   * @return The exit code, see ExitCode.
   */
  int
  run_driver(const Driver &driver, int argc, char **argv);
} // namespace Structure

#endif

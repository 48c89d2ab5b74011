// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_shell_file_h
#define mortar_contact_applications_shell_file_h

#include <deal.II/base/types.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <string>

namespace Structure
{
  using namespace dealii;

  /// The parts of a shell's mesh: what its file says of them.
  struct ShellParts
  {
    std::map<std::string, types::material_id> names;
    std::map<types::material_id, double>      thickness; ///< [m]
  };

  /**
   * Read the shell elements (S3, S4 and their kin, R3D3, R3D4) of an Abaqus
   * input file without *INSTANCE. Parts are the sets that *SHELL SECTION names,
   * which gives the thickness too; without any the sets of the *ELEMENT lines.
   * They get the material ids 1, 2, ... in the order of the file.
   * @throw ExcMessage naming the file and the line.
   */
  ShellParts
  read_abaqus_shell(const std::string &file, Triangulation<2, 3> &mesh);

  /// The names that a gmsh file gives to its physical surfaces; their ids are
  /// the material ids.
  ShellParts
  gmsh_parts(const std::string &file);
} // namespace Structure

#endif

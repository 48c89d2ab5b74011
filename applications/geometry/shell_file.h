// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_shell_file_h
#define mortar_contact_applications_shell_file_h

#include "mesh_parts.h"

#include <deal.II/grid/tria.h>

#include <string>

namespace Structure
{
  using namespace dealii;

  /**
   * Read the shell elements (S3, S4 and their kin, R3D3, R3D4) of an Abaqus
   * input file without *INSTANCE. Parts are the sets that *SHELL SECTION names,
   * which gives the thickness too; without any the sets of the *ELEMENT lines.
   * They get the material ids 1, 2, ... in the order of the file.
   * @throw ExcMessage naming the file and the line.
   */
  MeshParts
  read_abaqus_shell(const std::string &file, Triangulation<2, 3> &mesh);

  /// The names that a gmsh file gives to its physical groups of @p dim
  /// dimensions (the parts) and of one less (the boundaries).
  MeshParts
  gmsh_parts(const std::string &file, const unsigned int dim);
} // namespace Structure

#endif

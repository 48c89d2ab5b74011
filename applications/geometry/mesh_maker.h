// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_mesh_maker_h
#define mortar_contact_applications_mesh_maker_h

#include "mesh_parameters.h"
#include "shell_file.h"

#include <deal.II/grid/tria.h>

namespace Structure
{
  /// Make the mesh. @return What a file says of its parts.
  /// @throw ExcMessage on settings that make no mesh.
  template <int dim>
  MeshParts
  make_mesh(const MeshParameters &parameters, Triangulation<dim> &mesh);

  /**
   * Make the mesh of a shell: a box of two dimensions (Cells, Lower and Upper
   * corner have two numbers) that Map takes to space (three formulas in x, y;
   * without it the plane z = 0), or a file with surface elements.
   * @return What a file says of its parts.
   */
  MeshParts
  make_shell_mesh(const MeshParameters &parameters, Triangulation<2, 3> &mesh);
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_abaqus_solid_h
#define mortar_contact_applications_abaqus_solid_h

#include "mesh_parts.h"

#include <deal.II/grid/tria.h>

#include <string>

namespace Structure
{
  using namespace dealii;

  /**
   * Read the solids (2d: plane elements) of an Abaqus input file. Parts get the
   * material ids 1, 2, ..., see AbaqusDeck; surfaces the boundary ids 1, 2, ...
   * in the order of the file (a face of several has that of the first), all
   * other faces 0.
   * @throw ExcMessage naming the file and the line.
   */
  template <int dim>
  MeshParts
  read_abaqus_solid(const std::string &file, Triangulation<dim> &mesh);
} // namespace Structure

#endif

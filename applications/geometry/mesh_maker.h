// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_mesh_maker_h
#define mortar_contact_applications_mesh_maker_h

#include "mesh_parameters.h"

#include <deal.II/grid/tria.h>

namespace Structure
{
  /// Make the mesh. @throw ExcMessage on settings that make no mesh.
  template <int dim>
  void
  make_mesh(const MeshParameters &parameters, Triangulation<dim> &mesh);
} // namespace Structure

#endif

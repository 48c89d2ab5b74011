// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_mesh_parts_h
#define mortar_contact_applications_mesh_parts_h

#include <deal.II/base/types.h>

#include <map>
#include <string>

namespace Structure
{
  using namespace dealii;

  /// What a mesh file says of its parts and boundaries.
  struct MeshParts
  {
    std::map<std::string, types::material_id> names;
    std::map<types::material_id, double>      thickness; ///< Of shells [m]
    std::map<std::string, types::boundary_id> boundaries;
  };
} // namespace Structure

#endif

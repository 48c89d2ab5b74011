// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_gmsh_check_h
#define mortar_contact_geometry_gmsh_check_h

#include <string>

namespace Structure
{
  /**
   * Check the sections of a gmsh file. One that lacks the end of a section, or
   * lines of one, would keep deal.II's reader waiting for ever.
   * @throw ExcMessage naming file and line.
   */
  void
  check_gmsh(const std::string &file);
} // namespace Structure

#endif

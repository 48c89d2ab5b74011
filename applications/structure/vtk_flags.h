// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_vtk_flags_h
#define mortar_contact_structure_vtk_flags_h

#include <deal.II/base/data_out_base.h>

namespace Structure
{
  using namespace dealii;

  /// How bodies are written: the last byte that deal.II would press out of the
  /// files takes a tenth of the output's time.
  inline DataOutBase::VtkFlags
  fast_vtk_flags()
  {
    DataOutBase::VtkFlags flags;
    flags.compression_level = decltype(flags.compression_level)::best_speed;
    return flags;
  }
} // namespace Structure

#endif

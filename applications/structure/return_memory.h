// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_return_memory_h
#define mortar_contact_structure_return_memory_h

#include <cstdlib>

#ifdef __GLIBC__
#  include <malloc.h>
#endif

namespace Structure
{
  /// Give memory that was freed in small pieces (a sparsity pattern, a mesh
  /// under construction) back to the system: what follows asks for large
  /// pieces, which would come on top of it.
  inline void
  return_memory()
  {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_host_dealii_compat_h
#define mortar_contact_host_dealii_compat_h

// All that depends on deal.II's version, 9.4.1 to 9.8.

#include <deal.II/base/config.h>
#include <deal.II/base/index_set.h>

#include <deal.II/lac/affine_constraints.h>

namespace MortarContact
{
  namespace Compat
  {
    using namespace dealii;

    /// Constraints that store lines for @p stored; this rank owns @p owned.
    inline AffineConstraints<double>
    make_constraints(const IndexSet &owned, const IndexSet &stored)
    {
#if DEAL_II_VERSION_GTE(9, 6, 0)
      return AffineConstraints<double>(owned, stored);
#else
      (void)owned;
      return AffineConstraints<double>(stored);
#endif
    }
  } // namespace Compat
} // namespace MortarContact

#endif

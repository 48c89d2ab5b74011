// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_parameters_tie_parameters_h
#define mortar_contact_parameters_tie_parameters_h

#include <mortar_contact/laws/tie_law.h>

#include <deal.II/base/parameter_handler.h>

namespace MortarContact
{
  /// Ties of an interface, for the kinds tied and tiebreak.
  struct TieParameters
  {
    double      tolerance = 0.; ///< [m]; 0: 5 % of each facet's diameter.
    TieStrength strength;       ///< Law: of tiebreak.

    /// Entries with their defaults and help.
    static void
    declare(ParameterHandler &prm);

    /// What declare() declared.
    void
    read(ParameterHandler &prm);

    /// @param is_tiebreak Whether ties can fail.
    void
    check(const bool is_tie, const bool is_tiebreak) const;
  };
} // namespace MortarContact

#endif

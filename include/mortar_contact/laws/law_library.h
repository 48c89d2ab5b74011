// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_laws_law_library_h
#define mortar_contact_laws_law_library_h

#include <mortar_contact/laws/paper_law.h>

#include <memory>
#include <string>
#include <vector>

namespace MortarContact
{
  /// The one list of normal laws and their names in parameter files. The first
  /// is the default.
  const std::vector<std::pair<std::string, PressureCurve>> &
  pressure_laws();

  /// The law called @p name, see PaperLaw for the numbers. The name must be in
  /// pressure_laws().
  std::unique_ptr<PressureLaw>
  make_pressure_law(const std::string &name,
                    const double       scale,
                    const double       stiffening,
                    const double       largest_penetration,
                    const bool         barrier = false);
} // namespace MortarContact

#endif

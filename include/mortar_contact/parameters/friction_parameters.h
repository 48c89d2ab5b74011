// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_parameters_friction_parameters_h
#define mortar_contact_parameters_friction_parameters_h

#include <mortar_contact/laws/friction_law.h>

#include <deal.II/base/parameter_handler.h>

#include <memory>
#include <string>

namespace MortarContact
{
  using namespace dealii;

  /// Friction of an interface. Without a coefficient nothing of it is stored or
  /// computed.
  struct FrictionParameters
  {
    double      coefficient = 0.;  ///< FS [-]
    double      dynamic     = -1.; ///< FD [-]; negative: FS.
    double      decay       = 0.;  ///< DC [s/m]
    std::string formula;           ///< mu(p, v); empty: Coulomb's law.
    double      elastic_slip = 0.; ///< [m]; 0: from the contact stiffness.

    /// Entries with their defaults and help.
    static void
    declare(ParameterHandler &prm);

    /// What declare() declared.
    void
    read(ParameterHandler &prm);

    /// @throw ExcMessage where entries do not fit together.
    void
    check() const;

    /// Whether there is a coefficient.
    bool
    is_on() const
    {
      return coefficient > 0. || !formula.empty();
    }

    /// Null if there is none.
    std::unique_ptr<FrictionLaw>
    make() const;
  };
} // namespace MortarContact

#endif

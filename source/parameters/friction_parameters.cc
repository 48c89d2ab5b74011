// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/parameters/friction_parameters.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>

namespace MortarContact
{
  void
  FrictionParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry("Friction coefficient",
                      "0.0",
                      Patterns::Double(0.),
                      "Coulomb's coefficient, at rest [-] (FS); 0: none.");
    prm.declare_entry("Dynamic friction coefficient",
                      "-1.0",
                      Patterns::Double(-1.),
                      "At high slip rates [-] (FD); -1: as at rest.");
    prm.declare_entry(
      "Friction decay",
      "0.0",
      Patterns::Double(0.),
      "The coefficient is FD + (FS - FD) exp(-DC v), v the slip "
      "rate [time/length] (DC).");
    prm.declare_entry(
      "Friction function",
      "",
      Patterns::Anything(),
      "The coefficient as a formula in p (pressure) and v (slip "
      "rate), instead of the three entries above.");
    prm.declare_entry("Elastic slip",
                      "0.0",
                      Patterns::Double(0.),
                      "Tangential motion at which sliding starts [length]; 0: "
                      "as the contact stiffness says, see the report.");
  }


  void
  FrictionParameters::read(ParameterHandler &prm)
  {
    coefficient  = prm.get_double("Friction coefficient");
    dynamic      = prm.get_double("Dynamic friction coefficient");
    decay        = prm.get_double("Friction decay");
    formula      = prm.get("Friction function");
    elastic_slip = prm.get_double("Elastic slip");
  }


  void
  FrictionParameters::check() const
  {
    AssertThrow(dynamic < 0. || decay > 0.,
                ExcMessage(
                  "'Dynamic friction coefficient' is set but 'Friction "
                  "decay' is 0; expected a positive decay."));
    AssertThrow(decay == 0. || dynamic >= 0.,
                ExcMessage("'Friction decay' is set but 'Dynamic friction "
                           "coefficient' is not; expected a coefficient."));
    AssertThrow(formula.empty() || (coefficient == 0. && dynamic < 0.),
                ExcMessage("'Friction function' and 'Friction coefficient' are "
                           "both set. Remove one of them."));
    AssertThrow(is_on() || (elastic_slip == 0. && dynamic < 0.),
                ExcMessage(
                  "'Elastic slip' or 'Dynamic friction coefficient' is "
                  "set but there is no friction; expected a positive "
                  "'Friction coefficient'."));
  }


  std::unique_ptr<FrictionLaw>
  FrictionParameters::make() const
  {
    if (!formula.empty())
      return std::make_unique<FormulaFriction>(formula);
    if (coefficient > 0.)
      return std::make_unique<CoulombFriction>(
        coefficient, dynamic < 0. ? coefficient : dynamic, decay);
    return {};
  }
} // namespace MortarContact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/parameters/tie_parameters.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/numbers.h>
#include <deal.II/base/patterns.h>

namespace MortarContact
{
  namespace
  {
    using Law = TieStrength::Law;
  }

  void
  TieParameters::declare(ParameterHandler &prm)
  {
    const auto positive_or_zero = [&](const char *name, const char *help) {
      prm.declare_entry(name, "0.0", Patterns::Double(0.), help);
    };
    positive_or_zero("Tie tolerance",
                     "Largest gap or overlap that is tied at the start "
                     "[length]; 0: 5 % of each facet's diameter.");
    prm.declare_entry(
      "Tiebreak",
      "strength",
      Patterns::Selection("strength|Dycoss|cohesive"),
      "strength: fails at once where (s_n/NFLS)^2 + "
      "(s_t/SFLS)^2 reaches 1 (OPTION 2). Dycoss: softens, "
      "shear strength grows with pressure (OPTION 7). cohesive: "
      "bilinear, mixed mode (OPTION 9). Then frictional "
      "contact.");
    positive_or_zero("Normal strength", "Of ties [pressure] (NFLS).");
    positive_or_zero("Shear strength", "Of ties [pressure] (SFLS).");
    positive_or_zero("Normal fracture energy",
                     "Mode I [energy/area] (ERATEN).");
    positive_or_zero("Shear fracture energy",
                     "Mode II [energy/area] (ERATES).");
    prm.declare_entry("Mixed mode",
                      "power law",
                      Patterns::Selection("power law|Benzeggagh-Kenane"),
                      "How modes I and II share (sign of PARAM).");
    prm.declare_entry("Mixed mode exponent",
                      "1.0",
                      Patterns::Double(0.01, 100.),
                      "Of the mixed mode law [-] (|PARAM|).");
    prm.declare_entry("Tie friction angle",
                      "0.0",
                      Patterns::Double(0., 89.9),
                      "Growth of the shear strength under pressure, Dycoss "
                      "[degrees] (PARAM).");
    positive_or_zero("Normal tie stiffness",
                     "Of whole ties [pressure/length] (CN); 0: the contact "
                     "stiffness.");
    prm.declare_entry("Shear to normal stiffness",
                      "1.0",
                      Patterns::Double(1e-6, 1e6),
                      "Of ties that can fail [-] (CT2CN).");
  }


  void
  TieParameters::read(ParameterHandler &prm)
  {
    tolerance                  = prm.get_double("Tie tolerance");
    const std::string name     = prm.get("Tiebreak");
    strength.law               = (name == "strength") ? Law::strength :
                                 (name == "Dycoss")   ? Law::dycoss :
                                                        Law::cohesive;
    strength.normal            = prm.get_double("Normal strength");
    strength.shear             = prm.get_double("Shear strength");
    strength.energy_normal     = prm.get_double("Normal fracture energy");
    strength.energy_shear      = prm.get_double("Shear fracture energy");
    strength.benzeggagh_kenane = prm.get("Mixed mode") == "Benzeggagh-Kenane";
    strength.exponent          = prm.get_double("Mixed mode exponent");
    strength.friction_angle =
      prm.get_double("Tie friction angle") * numbers::PI / 180.;
    strength.normal_stiffness = prm.get_double("Normal tie stiffness");
    strength.shear_ratio      = prm.get_double("Shear to normal stiffness");
  }


  void
  TieParameters::check(const bool is_tie, const bool is_tiebreak) const
  {
    AssertThrow(is_tie || tolerance == 0.,
                ExcMessage(
                  "'Tie tolerance' is set but 'Kind' is neither 'tied' "
                  "nor 'tiebreak'. Remove one of them."));
    const bool has_strength = strength.normal > 0. || strength.shear > 0. ||
                              strength.energy_normal > 0. ||
                              strength.energy_shear > 0.;
    AssertThrow(is_tiebreak || (strength.normal_stiffness == 0. &&
                                strength.shear_ratio == 1.),
                ExcMessage("'Normal tie stiffness' or 'Shear to normal "
                           "stiffness' is set but 'Kind' is not 'tiebreak'. "
                           "Remove one of them."));
    AssertThrow(is_tiebreak || !has_strength,
                ExcMessage("A strength or fracture energy of ties is set but "
                           "'Kind' is not 'tiebreak'. Remove one of them."));
    if (!is_tiebreak)
      return;
    AssertThrow(strength.normal > 0. && strength.shear > 0.,
                ExcMessage("'Kind' is 'tiebreak' but 'Normal strength' (NFLS) "
                           "or 'Shear strength' (SFLS) is 0; expected positive "
                           "strengths."));
    const bool softens = strength.law != Law::strength;
    AssertThrow(!softens ||
                  (strength.energy_normal > 0. && strength.energy_shear > 0.),
                ExcMessage("'Tiebreak' softens but 'Normal fracture energy' "
                           "(ERATEN) or 'Shear fracture energy' (ERATES) is 0; "
                           "expected positive energies."));
    AssertThrow(softens ||
                  (strength.energy_normal == 0. && strength.energy_shear == 0.),
                ExcMessage("'Tiebreak' is 'strength' but a fracture energy is "
                           "set; it fails at once. Remove one of them."));
    AssertThrow(strength.friction_angle == 0. || strength.law == Law::dycoss,
                ExcMessage("'Tie friction angle' is set but 'Tiebreak' is not "
                           "'Dycoss'. Remove one of them."));
    // whether the energies exceed the elastic ones is seen when the contact
    // stiffness is known, see TieLaw::brittleness()
  }
} // namespace MortarContact

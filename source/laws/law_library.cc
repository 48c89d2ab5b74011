// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/law_library.h>

#include <deal.II/base/exceptions.h>

namespace MortarContact
{
  const std::vector<std::pair<std::string, PressureCurve>> &
  pressure_laws()
  {
    static const std::vector<std::pair<std::string, PressureCurve>> laws = {
      {"parabola linear", PressureCurve::parabola_linear},
      {"parabola", PressureCurve::parabola},
      {"quartic linear", PressureCurve::quartic_linear},
      {"linear", PressureCurve::linear}};
    return laws;
  }


  std::unique_ptr<PressureLaw>
  make_pressure_law(const std::string &name,
                    const double       scale,
                    const double       stiffening,
                    const double       largest_penetration,
                    const bool         barrier)
  {
    for (const auto &[known, curve] : pressure_laws())
      if (known == name)
        return std::make_unique<PaperLaw>(
          curve, scale, stiffening, largest_penetration, 0.03, barrier);
    std::string all;
    for (const auto &[known, curve] : pressure_laws())
      all += (all.empty() ? "'" : ", '") + known + "'";
    AssertThrow(false,
                dealii::ExcMessage("There is no pressure law called '" + name +
                                   "'; expected one of " + all + "."));
    return nullptr;
  }
} // namespace MortarContact

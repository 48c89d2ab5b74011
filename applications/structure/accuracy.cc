// SPDX-License-Identifier: LGPL-2.1-or-later
#include "accuracy.h"

#include <deal.II/base/patterns.h>

#include <utility>

namespace Structure
{
  namespace
  {
    using Entries = std::vector<std::pair<std::string, std::string>>;

    // Measured: rough tolerances save a fifth of the time for no error that can
    // be seen; fixed points in place of segments save little, and cost steps
    // where something slides. The penalty's stiffness is most of the error.
    const Entries fast_contact  = {{"Degree", "3"}},
                  fast_newton   = {{"Force tolerance", "1e-4"},
                                   {"Displacement tolerance", "1e-2"}},
                  fast_linear   = {{"Tolerance", "1e-6"}},
                  exact_contact = {{"Degree", "6"}, {"Stiffness scale", "20"}},
                  exact_newton  = {{"Force tolerance", "1e-10"},
                                   {"Displacement tolerance", "1e-8"}},
                  exact_linear  = {{"Mixed tolerance", "1e-3"}};

    void
    set(ParameterHandler               &prm,
        const std::vector<std::string> &path,
        const Entries                  &entries)
    {
      for (const std::string &section : path)
        prm.enter_subsection(section);
      for (const auto &[entry, value] : entries)
        prm.set(entry, value);
      for (std::size_t i = 0; i < path.size(); ++i)
        prm.leave_subsection();
    }
  } // namespace


  void
  declare_accuracy(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Accuracy",
      "balanced",
      Patterns::Selection("fast|balanced|exact"),
      "Sets several entries at once; those that the file gives win. fast: "
      "rough tolerances, rules of degree 3. balanced: the defaults of each "
      "entry. exact: a stiffer penalty, rules of degree 6, tight tolerances. "
      "What each costs: doc/trade.md.");
  }


  void
  set_accuracy(ParameterHandler                            &prm,
               const std::string                           &accuracy,
               const std::vector<std::vector<std::string>> &interfaces)
  {
    if (accuracy == "balanced")
      return;
    const bool is_fast = accuracy == "fast";
    for (const auto &path : interfaces)
      set(prm, path, is_fast ? fast_contact : exact_contact);
    set(prm, {"Solver", "Newton"}, is_fast ? fast_newton : exact_newton);
    set(prm, {"Solver", "Linear"}, is_fast ? fast_linear : exact_linear);
  }


  bool
  is_set_by_accuracy(const std::string &entry)
  {
    for (const Entries *entries : {&fast_contact,
                                   &fast_newton,
                                   &fast_linear,
                                   &exact_contact,
                                   &exact_newton,
                                   &exact_linear})
      for (const auto &pair : *entries)
        if (pair.first == entry)
          return true;
    return false;
  }
} // namespace Structure

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_accuracy_h
#define mortar_contact_structure_accuracy_h

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Structure
{
  using namespace dealii;

  /// Declare 'Accuracy': entries of contact and solver that are set at once.
  void
  declare_accuracy(ParameterHandler &prm);

  /**
   * Set the entries of an accuracy; the file, which is parsed afterwards, may
   * give any of them. What each costs and how wrong it is:
   * doc/trade.md, benchmarks/tradeoff.py.
   *
   * @param interfaces Sections of the interfaces.
   */
  void
  set_accuracy(ParameterHandler                            &prm,
               const std::string                           &accuracy,
               const std::vector<std::vector<std::string>> &interfaces);

  /// Whether set_accuracy() may set an entry of this name.
  bool
  is_set_by_accuracy(const std::string &entry);
} // namespace Structure

#endif

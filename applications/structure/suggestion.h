// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_suggestion_h
#define mortar_contact_structure_suggestion_h

#include <deal.II/base/parameter_handler.h>

#include <string>

namespace Structure
{
  using namespace dealii;

  /**
   * What a misspelt entry or subsection may have meant, and where such an entry
   * belongs.
   *
   * @param error What ParameterHandler said of a line with a name that is not
   *        declared.
   * @return A sentence such as "Did you mean 'Stiffness scale'? ...", after a
   *         new line; empty where nothing is near, or the error is another.
   */
  std::string
  did_you_mean(const ParameterHandler &prm, const std::string &error);
} // namespace Structure

#endif

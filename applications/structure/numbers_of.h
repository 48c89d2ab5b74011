// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_numbers_of_h
#define mortar_contact_structure_numbers_of_h

#include <deal.II/base/utilities.h>

#include <sstream>
#include <string>
#include <vector>

namespace Structure
{
  /// The numbers of a list that its pattern has checked already.
  inline std::vector<double>
  numbers_of(const std::string &list)
  {
    return dealii::Utilities::string_to_double(
      dealii::Utilities::split_string_list(list));
  }

  /// A number for people.
  inline std::string
  number(const double x, const int precision = 4)
  {
    std::ostringstream out;
    out.precision(precision);
    out << x;
    return out.str();
  }

  /// A number as part of a formula.
  inline std::string
  text_of(const double x)
  {
    std::ostringstream out;
    out.precision(17);
    out << x;
    return out.str();
  }
} // namespace Structure

#endif

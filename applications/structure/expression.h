// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_structure_expression_h
#define mortar_contact_structure_expression_h

#include <deal.II/base/function_parser.h>

#include <memory>
#include <string>

namespace Structure
{
  using namespace dealii;

  /// A formula in x, y, z (undeformed place), t (time) and pi.
  template <int dim>
  class Expression
  {
  public:
    /// @throw ExcMessage naming @p entry if @p text is no formula.
    Expression(const std::string &text, const std::string &entry)
      : function(std::make_unique<FunctionParser<dim>>(1))
    {
      try
        {
          function->initialize((dim == 2) ? "x,y,t" : "x,y,z,t",
                               text,
                               {{"pi", numbers::PI}},
                               true);
          (void)value(Point<dim>(), 0.);
        }
      catch (const std::exception &)
        {
          AssertThrow(false,
                      ExcMessage("'" + entry + "' is '" + text +
                                 "'; expected a formula in " +
                                 ((dim == 2) ? "x, y" : "x, y, z") +
                                 ", t and pi, for example 0.1*sin(pi*t)."));
        }
    }

    double
    value(const Point<dim> &x, const double t)
    {
      function->set_time(t);
      return function->value(x);
    }

  private:
    std::unique_ptr<FunctionParser<dim>> function;
  };
} // namespace Structure

#endif

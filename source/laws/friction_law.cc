// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/friction_law.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/function_parser.h>

#include <cmath>

namespace MortarContact
{
  using namespace dealii;

  CoulombFriction::CoulombFriction(const double static_coefficient,
                                   const double dynamic_coefficient,
                                   const double decay)
    : fs(static_coefficient)
    , fd(dynamic_coefficient)
    , dc(decay)
  {}


  FrictionResponse
  CoulombFriction::evaluate(const double, const double rate) const
  {
    const double e = (fs - fd) * std::exp(-dc * rate);
    return {fd + e, 0., -dc * e};
  }


  struct FormulaFriction::Parser
  {
    Parser()
      : function(1)
    {}

    double
    value(const double pressure, const double rate) const
    {
      return function.value(Point<2>(pressure, rate));
    }

    FunctionParser<2> function;
  };


  FormulaFriction::FormulaFriction(const std::string &formula)
    : parser(std::make_unique<Parser>())
  {
    try
      {
        parser->function.initialize("p,v", formula, {{"pi", numbers::PI}});
        (void)parser->value(1., 0.);
      }
    catch (const std::exception &)
      {
        AssertThrow(false,
                    ExcMessage("'Friction function' is '" + formula +
                               "'; expected a formula in p (pressure), v (slip "
                               "rate) and pi, for example 0.3/(1 + p/1e6)."));
      }
  }


  FormulaFriction::~FormulaFriction() = default;


  FrictionResponse
  FormulaFriction::evaluate(const double pressure, const double rate) const
  {
    FrictionResponse r;
    r.coefficient = parser->value(pressure, rate);
    // iterates may go where the formula is not meant for
    if (!(r.coefficient > 0.))
      return {};
    const double step = 1e-5;
    r.by_pressure     = (parser->value((1. + step) * pressure, rate) -
                     parser->value((1. - step) * pressure, rate)) /
                    (2. * step * pressure);
    if (rate > 0.)
      r.by_rate = (parser->value(pressure, (1. + step) * rate) -
                   parser->value(pressure, (1. - step) * rate)) /
                  (2. * step * rate);
    return r;
  }
} // namespace MortarContact

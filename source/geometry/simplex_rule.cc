// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/simplex_rule.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/quadrature_lib.h>

#include <cmath>

namespace MortarContact
{
  using namespace dealii;

  namespace
  {
    /// The points (a, b, 1-a-b) in all different orders, @p weight each.
    void
    add_orbit(std::vector<SimplexPoint<3>> &points,
              const double                  a,
              const double                  b,
              const double                  weight)
    {
      const double c = 1. - a - b;
      points.push_back({{{a, b, c}}, weight});
      points.push_back({{{b, c, a}}, weight});
      points.push_back({{{c, a, b}}, weight});
      if (a == b)
        return;
      points.push_back({{{b, a, c}}, weight});
      points.push_back({{{a, c, b}}, weight});
      points.push_back({{{c, b, a}}, weight});
    }
  } // namespace


  template <>
  std::vector<SimplexPoint<2>>
  simplex_rule<2>(const unsigned int degree)
  {
    Assert(degree >= 1, ExcInternalError());
    const QGauss<1>              gauss(degree / 2 + 1);
    std::vector<SimplexPoint<2>> points;
    for (unsigned int q = 0; q < gauss.size(); ++q)
      points.push_back(
        {{{1. - gauss.point(q)[0], gauss.point(q)[0]}}, gauss.weight(q)});
    return points;
  }


  template <>
  std::vector<SimplexPoint<3>>
  simplex_rule<3>(const unsigned int degree)
  {
    Assert(degree >= 2 && degree <= 6, ExcIndexRange(degree, 2, 7));
    std::vector<SimplexPoint<3>> points;
    switch (degree)
      {
        case 2:
          add_orbit(points, 1. / 6., 1. / 6., 1. / 3.);
          break;
        case 3:
        case 4:
          {
            // roots of the moment equations in closed form
            const double r = std::sqrt(38. - 44. * std::sqrt(2. / 5.));
            const double a = (8. - std::sqrt(10.) + r) / 18.;
            const double b = (8. - std::sqrt(10.) - r) / 18.;
            const double s =
              std::sqrt(213125. - 53320. * std::sqrt(10.)) / 3720.;
            add_orbit(points, a, a, 620. / 3720. + s);
            add_orbit(points, b, b, 620. / 3720. - s);
            break;
          }
        case 5:
          {
            const double s = std::sqrt(15.);
            points.push_back({{{1. / 3., 1. / 3., 1. / 3.}}, 9. / 40.});
            add_orbit(points,
                      (6. - s) / 21.,
                      (6. - s) / 21.,
                      (155. - s) / 1200.);
            add_orbit(points,
                      (6. + s) / 21.,
                      (6. + s) / 21.,
                      (155. + s) / 1200.);
            break;
          }
        default:
          add_orbit(points,
                    0.063089014491502228340331602870819,
                    0.063089014491502228340331602870819,
                    0.050844906370206816920936809106869);
          add_orbit(points,
                    0.24928674517091042129163855310702,
                    0.24928674517091042129163855310702,
                    0.11678627572637936602528961138558);
          add_orbit(points,
                    0.053145049844816947353249671631398,
                    0.31035245103378440541660773395655,
                    0.082851075618373575193553456420442);
      }
    return points;
  }
} // namespace MortarContact

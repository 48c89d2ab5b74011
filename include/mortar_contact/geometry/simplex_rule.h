// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_simplex_rule_h
#define mortar_contact_geometry_simplex_rule_h

#include <array>
#include <vector>

namespace MortarContact
{
  /// One point of a quadrature rule on a simplex of dimension dim - 1.
  template <int dim>
  struct SimplexPoint
  {
    std::array<double, dim> lambda; ///< Barycentric coordinates, sum 1.
    double                  weight; ///< Share of the simplex' area, sum 1.
  };

  /**
   * Symmetric rule of positive weights with inner points: Gauss-Legendre on the
   * interval (dim = 2); on the triangle (dim = 3) Strang & Fix' rules of 3, 6,
   * 7 and 12 points, exact for polynomials of degree 2, 4, 5 and 6 (Dunavant
   * 1985, doi:10.1002/nme.1620210612, tables for p = 2, 4, 5, 6).
   *
   * @param degree 2 to 6; 3 takes the rule of degree 4.
   */
  template <int dim>
  std::vector<SimplexPoint<dim>>
  simplex_rule(const unsigned int degree);
} // namespace MortarContact

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/state/contact_history.h>

#include <cmath>

namespace MortarContact
{
  namespace
  {
    const double root3 = std::sqrt(3.);
    /// Gauss points on [0,1], and the weights of the two values in the linear
    /// extrapolation to 0: near + far = 1.
    const double low = 0.5 - 0.5 / root3, high = 0.5 + 0.5 / root3;
    const double near_weight = 0.5 * (1. + root3);
    const double far_weight  = 0.5 * (1. - root3);
  } // namespace


  template <>
  std::vector<PlanePoint<2>>
  material_points<2>(const unsigned int)
  {
    return {PlanePoint<2>({low}), PlanePoint<2>({high})};
  }


  template <>
  std::vector<PlanePoint<3>>
  material_points<3>(const unsigned int n_vertices)
  {
    if (n_vertices == 3)
      return {PlanePoint<3>({1. / 6., 1. / 6.}),
              PlanePoint<3>({2. / 3., 1. / 6.}),
              PlanePoint<3>({1. / 6., 2. / 3.})};
    return {PlanePoint<3>({low, low}),
            PlanePoint<3>({high, low}),
            PlanePoint<3>({high, high}),
            PlanePoint<3>({low, high})};
  }


  template <>
  VertexValues<2>
  extrapolate_to_vertices<2>(const unsigned int, const VertexValues<2> &f)
  {
    return {{near_weight * f[0] + far_weight * f[1],
             near_weight * f[1] + far_weight * f[0]}};
  }


  template <>
  VertexValues<3>
  extrapolate_to_vertices<3>(const unsigned int     n_vertices,
                             const VertexValues<3> &f)
  {
    VertexValues<3> v = {};
    if (n_vertices == 3)
      for (unsigned int a = 0; a < 3; ++a)
        v[a] = 2. * f[a] - (f[0] + f[1] + f[2]) / 3.;
    else
      for (unsigned int a = 0; a < 4; ++a)
        v[a] = near_weight * near_weight * f[a] +
               near_weight * far_weight * (f[(a + 1) % 4] + f[(a + 3) % 4]) +
               far_weight * far_weight * f[(a + 2) % 4];
    return v;
  }


  template <int dim>
  std::array<PlanePoint<dim>, max_vertices<dim>>
  extrapolate_to_vertices(
    const unsigned int                                    n_vertices,
    const std::array<PlanePoint<dim>, max_vertices<dim>> &at_points)
  {
    std::array<PlanePoint<dim>, max_vertices<dim>> result;
    for (unsigned int c = 0; c < dim - 1; ++c)
      {
        VertexValues<dim> component = {};
        for (unsigned int q = 0; q < max_vertices<dim>; ++q)
          component[q] = at_points[q][c];
        component = extrapolate_to_vertices<dim>(n_vertices, component);
        for (unsigned int a = 0; a < max_vertices<dim>; ++a)
          result[a][c] = component[a];
      }
    return result;
  }

  template std::array<PlanePoint<2>, max_vertices<2>>
  extrapolate_to_vertices<2>(
    const unsigned int,
    const std::array<PlanePoint<2>, max_vertices<2>> &);
  template std::array<PlanePoint<3>, max_vertices<3>>
  extrapolate_to_vertices<3>(
    const unsigned int,
    const std::array<PlanePoint<3>, max_vertices<3>> &);
} // namespace MortarContact

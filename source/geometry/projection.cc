// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/projection.h>

#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Newton steps allowed; a bilinear map needs about five.
    constexpr unsigned int max_projection_steps = 30;

    /// Newton has converged when xi moves less than this (reference units):
    /// the step after it would be of the size of its square.
    constexpr double projection_tolerance = 1e-9;

    /// A map is degenerate where |det J| is below this times |J|^(dim-1).
    constexpr double degenerate = 1e-12;

    /// Newton is lost when xi is farther than this from the reference domain.
    constexpr double far_away = 1e4;
  } // namespace


  template <int dim>
  std::optional<PlanePoint<dim>>
  inverse_map(const unsigned int     n_vertices,
              const PlaneFacet<dim> &vertices,
              const PlanePoint<dim> &y)
  {
    const bool      affine = (n_vertices != 4);
    PlanePoint<dim> xi     = reference_centre<dim>(n_vertices);

    for (unsigned int step = 0; step < max_projection_steps; ++step)
      {
        const auto      N        = shape_values<dim>(n_vertices, xi);
        PlanePoint<dim> residual = y;
        for (unsigned int a = 0; a < n_vertices; ++a)
          residual -= N[a] * vertices[a];

        const Tensor<2, dim - 1> J =
          plane_jacobian<dim>(n_vertices, vertices, xi);
        const double det   = determinant(J);
        const double scale = (dim == 2) ? std::abs(J[0][0]) : J.norm_square();
        // written so that NaN is degenerate
        if (!(std::abs(det) > degenerate * scale))
          return {};

        const PlanePoint<dim> dxi = invert(J) * residual;
        xi += dxi;
        if (affine || dxi.norm() < projection_tolerance)
          return xi;
        if (!(xi.norm() < far_away))
          return {};
      }
    return {};
  }


  template std::optional<PlanePoint<2>>
  inverse_map<2>(const unsigned int,
                 const PlaneFacet<2> &,
                 const PlanePoint<2> &);
  template std::optional<PlanePoint<3>>
  inverse_map<3>(const unsigned int,
                 const PlaneFacet<3> &,
                 const PlanePoint<3> &);
} // namespace MortarContact

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_projection_h
#define mortar_contact_geometry_projection_h

#include <mortar_contact/geometry/facet.h>

#include <optional>

namespace MortarContact
{
  /// The vertices of a facet, projected into a plane along the plane's normal.
  template <int dim>
  using PlaneFacet = std::array<PlanePoint<dim>, max_vertices<dim>>;

  /**
   * Reference coordinates xi of the plane point @p y: sum_a N_a(xi) y_a = y.
   * Exact in one step for lines and triangles, Newton's method from the centre
   * for quadrilaterals.
   *
   * The facet is extended beyond its edges: xi may lie outside the reference
   * domain; callers decide with is_inside().
   *
   * @return Nothing if the projected facet has (nearly) no area at the point or
   * Newton did not converge.
   */
  template <int dim>
  std::optional<PlanePoint<dim>>
  inverse_map(const unsigned int     n_vertices,
              const PlaneFacet<dim> &vertices,
              const PlanePoint<dim> &y);

  /// Derivatives dy/dxi of the projected facet: column c is dy/dxi_c.
  template <int dim>
  inline Tensor<2, dim - 1>
  plane_jacobian(const unsigned int     n_vertices,
                 const PlaneFacet<dim> &vertices,
                 const PlanePoint<dim> &xi)
  {
    const auto         dN = shape_gradients<dim>(n_vertices, xi);
    Tensor<2, dim - 1> J;
    for (unsigned int a = 0; a < n_vertices; ++a)
      for (unsigned int r = 0; r < dim - 1; ++r)
        for (unsigned int c = 0; c < dim - 1; ++c)
          J[r][c] += vertices[a][r] * dN[c][a];
    return J;
  }
} // namespace MortarContact

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_applications_ellipsoid_h
#define mortar_contact_applications_ellipsoid_h

#include <deal.II/base/tensor.h>

#include <deal.II/grid/tria.h>

#include <vector>

namespace Structure
{
  using namespace dealii;

  /// Semi-axes along x, y, z.
  struct Ellipsoid
  {
    Tensor<1, 3> centre, axes;

    /// Less than 1 inside.
    double
    level(const Tensor<1, 3> &x) const;
  };

  /**
   * Quadrilaterals of about the given size on the surface of ellipsoids that
   * may overlap, without those inside another; corners counterclockwise seen
   * from outside.
   */
  void
  make_surface(const std::vector<Ellipsoid>           &ellipsoids,
               const double                            size,
               std::vector<Tensor<1, 3>>              &vertices,
               std::vector<std::vector<unsigned int>> &facets);

  /**
   * Hexahedra of the lower half of a layer inside an ellipsoid: boundary id 1
   * inside, 3 outside, 0 on the rim.
   * @param n_layers Cells across.
   */
  void
  make_lower_layer(const Ellipsoid   &ellipsoid,
                   const double       thickness,
                   const unsigned int n_layers,
                   const double       size,
                   Triangulation<3>  &mesh);
} // namespace Structure

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_smooth_facets_h
#define mortar_contact_geometry_smooth_facets_h

#include <mortar_contact/geometry/facet.h>
#include <mortar_contact/geometry/obstacle.h>

#include <memory>
#include <vector>

namespace MortarContact
{
  /**
   * The facets of a rigid body, smoothed: each line or triangle becomes a
   * quadratic patch through its vertices and across its vertex normals (T.
   * Nagata, Computer Aided Geometric Design 22 (2005) 327-347,
   * doi:10.1016/j.cagd.2005.01.006); quadrilaterals count as two triangles.
   * Neighbouring patches meet along their common edge, with normals that agree
   * up to O(h^2) instead of O(h): where a coarse facet's normal would jump, the
   * force hardly does.
   */
  template <int dim>
  class SmoothFacets : public Obstacle<dim>
  {
  public:
    /**
     * @param crease Facets that meet at a larger angle keep their edge [rad].
     */
    SmoothFacets(const std::vector<Facet<dim>> &facets, const double crease);
    ~SmoothFacets() override;

  protected:
    std::optional<SurfacePoint<dim>>
    meet_in_body(const Tensor<1, dim> &X,
                 const Tensor<1, dim> &N,
                 const double          range) const override;

    /// By boxes around the patches.
    bool
    is_far_in_body(const Tensor<1, dim> &X, const double r) const override;

  private:
    /// x(eta) = sum of coefficients times 1, eta_b, eta_b eta_c.
    struct Patch
    {
      Tensor<1, dim>                                           constant;
      std::array<Tensor<1, dim>, dim - 1>                      linear;
      std::array<std::array<Tensor<1, dim>, dim - 1>, dim - 1> second;
    };

    struct Tree;
    std::vector<Patch>    patches;
    std::unique_ptr<Tree> tree;
  };
} // namespace MortarContact

#endif

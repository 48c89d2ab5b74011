// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_pair_kernel_h
#define mortar_contact_mortar_pair_kernel_h

#include <mortar_contact/geometry/simplex_rule.h>
#include <mortar_contact/mortar/point_kernel.h>
#include <mortar_contact/mortar/segmentation.h>

#include <optional>
#include <vector>

namespace MortarContact
{
  /**
   * The contact integral over a pair of facets: points and weights by segments,
   * or at points fixed on the secondary; what happens at a point is the
   * PointKernel's. Weights W_q are of the undeformed secondary. The tangent is
   * the exact derivative of the forces, the moving overlap included, in closed
   * form; the tests compare it with automatic differentiation of an independent
   * implementation.
   */
  template <int dim>
  class PairKernel
  {
  public:
    /// See PointKernel.
    PairKernel(const PressureLaw   &law,
               const FrictionLaw   *friction,
               const KernelOptions &options);

    /**
     * Evaluate one secondary facet against one primary facet by segments.
     *
     * @param secondary_frame The frame of @p secondary's current facet.
     * @param primary_before Where the primary was at the end of the last
     *                accepted step; may be null without friction.
     * @param weight  Factor of the energy: 1/2 for each sweep of a two-sided
     *                interface.
     */
    void
    evaluate_segments(const SecondaryFrame<dim> &secondary_frame,
                      const ContactFacet<dim>   &secondary,
                      const SecondaryState<dim> &state,
                      const ContactFacet<dim>   &primary,
                      const Facet<dim>          *primary_before,
                      const double               weight,
                      const bool                 with_tangent,
                      PairBlock<dim>            &block) const;

    /// The fixed points of the other rules on a facet with @p n_vertices
    /// vertices: reference coordinates and weights.
    std::vector<std::pair<PlanePoint<dim>, double>>
    fixed_points(const unsigned int n_vertices) const;

    /// Modulus and length that act between two points of a pair.
    ContactStiffness
    stiffness(const ContactFacet<dim> &secondary,
              const PlanePoint<dim>   &xi,
              const ContactFacet<dim> &primary,
              const PlanePoint<dim>   &eta) const;

    /// Where the line along the secondary's normal through the fixed point
    /// @p xi meets @p primary, if it does; with the depth there.
    struct Hit
    {
      PlanePoint<dim> eta;   ///< On a facet.
      double          depth; ///< n . (x_s - x_p) [m]
      /// On an obstacle.
      std::optional<SurfacePoint<dim>> surface;
    };
    /// Where the line along the secondary's normal at @p xi meets a facet.
    std::optional<Hit>
    hit(const SecondaryFrame<dim> &secondary_frame,
        const PlanePoint<dim>     &xi,
        const ContactFacet<dim>   &primary) const;

    /// Add one fixed point of @p secondary, which meets @p primary.
    void
    add_fixed_point(const SecondaryFrame<dim> &secondary_frame,
                    const ContactFacet<dim>   &secondary,
                    const SecondaryState<dim> &state,
                    const PrimaryPoint<dim>   &primary,
                    const PlanePoint<dim>     &xi,
                    const double               weight,
                    const bool                 with_tangent,
                    PairBlock<dim>            &block) const;

    /// Symmetrise the tangent if the options say so; after the last point.
    void
    finish(PairBlock<dim> &block) const;

    /// A point of a segment, with its undeformed area.
    struct SegmentPoint
    {
      PlanePoint<dim> xi;     ///< On the secondary [-]
      PlanePoint<dim> eta;    ///< On the primary [-]
      double          weight; ///< [m^2]
    };

    /// All points by segments; see evaluate_segments().
    std::vector<SegmentPoint>
    segment_points(const SecondaryFrame<dim> &secondary_frame,
                   const ContactFacet<dim>   &secondary,
                   const ContactFacet<dim>   &primary) const;

    /// The surface of a facet at @p eta.
    /// @param is_open The point carries nothing: its derivatives are left out.
    PrimaryPoint<dim>
    primary_point(const ContactFacet<dim> &primary,
                  const Facet<dim>        *before,
                  const PlanePoint<dim>   &eta,
                  const bool               is_open = false) const;

    /// What happens at each point.
    const PointKernel<dim> point;
    /// Of the point kernel.
    const KernelOptions &options;

  private:
    std::vector<SimplexPoint<dim>> rule;
    std::vector<double>            points_1d, weights_1d;
  };
} // namespace MortarContact

#endif

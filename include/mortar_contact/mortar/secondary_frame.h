// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_secondary_frame_h
#define mortar_contact_mortar_secondary_frame_h

#include <mortar_contact/geometry/projection.h>

namespace MortarContact
{
  /// Derivatives by the positions of the vertices of one facet:
  /// [vertex * dim + component].
  template <int dim>
  using FacetVector = std::array<double, max_facet_components<dim>>;

  /// Derivatives by the positions of the vertices of a pair: those of the
  /// secondary facet, then, from max_facet_components on, of the primary.
  template <int dim>
  using PairVector = std::array<double, max_pair_components<dim>>;

  /**
   * Plane of a secondary facet: through its centre, across its centre normal n.
   * All integration happens in this plane; coordinates y in it belong to an
   * orthonormal basis e_c with e_0 along the centre tangent, so that it turns
   * with the material. The overlap does not feel the spin about n: its motion,
   * frame_motion(), takes Delta e_c = -(Delta n . e_c) n. Vectors that are
   * stored in the basis do, see spin().
   */
  template <int dim>
  struct SecondaryFrame
  {
    /// Of the facet in its present place.
    explicit SecondaryFrame(const Facet<dim> &facet);

    /// As given.
    Facet<dim> facet;
    /// Mean of the vertices [m].
    Tensor<1, dim>                      centre;
    Tensor<1, dim>                      normal;        ///< n, unit, outward.
    double                              normal_length; ///< |w|
    std::array<Tensor<1, dim>, dim - 1> basis;  ///< Of the plane, orthonormal.
    PlaneFacet<dim>                     y;      ///< Projected vertices.
    VertexValues<dim>                   height; ///< n . (x_a - centre)
    /// Largest distance of vertices [m].
    double diameter;

    /// dw/dx_a of the unnormalised normal w, [vertex] dim x dim.
    std::array<Tensor<2, dim>, max_vertices<dim>> dw;
    /// dn/dx_a of the unit normal, [vertex] dim x dim.
    std::array<Tensor<2, dim>, max_vertices<dim>> dn;

    /// |x_,0| at the centre, the length of the tangent that e_0 follows.
    double tangent_length;
    /// Coefficients of the vertices in that tangent.
    VertexValues<dim> tangent_of;

    /// Coordinates of @p x in the plane.
    PlanePoint<dim>
    project(const Tensor<1, dim> &x) const;

    /**
     * Derivative of the plane coordinates of a point by the vertices of the
     * secondary facet, the point itself held fixed in space:
     *   Delta y_c = -e_c . Delta centre - (n . (x - centre)) (e_c . Delta n).
     * @param height n . (x - centre) of the point.
     */
    std::array<FacetVector<dim>, dim - 1>
    frame_motion(const double height) const;

    /// Derivative of the spin of the basis about n: the part e_1 . Delta e_0.
    /// Zero in 2d.
    FacetVector<dim>
    spin() const;

    /**
     * Second derivative of the unit normal, contracted with a vector:
     * b . d2n/(dx_a dx_b) [vertex, component; vertex, component], where the
     * part along n is weighted separately: b is replaced by
     * @p across (its part across n counts) + @p along n.
     */
    std::array<FacetVector<dim>, max_facet_components<dim>>
    normal_curvature(const Tensor<1, dim> &across, const double along) const;

  private:
    /// Coefficients of the two vectors p, q of which w is the product.
    VertexValues<dim> p_of, q_of;
  };
} // namespace MortarContact

#endif

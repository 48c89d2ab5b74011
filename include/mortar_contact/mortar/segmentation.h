// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_segmentation_h
#define mortar_contact_mortar_segmentation_h

#include <mortar_contact/geometry/clipping.h>
#include <mortar_contact/mortar/secondary_frame.h>

#include <vector>

namespace MortarContact
{
  /// Motion of a point in the secondary's plane: dy_c by the pair's vertices.
  template <int dim>
  using PlaneMotion = std::array<PairVector<dim>, dim - 1>;

  /// A primary facet as seen in the plane of a secondary facet.
  template <int dim>
  struct ProjectedPrimary
  {
    /// Project @p facet along the secondary's normal.
    ProjectedPrimary(const SecondaryFrame<dim> &frame, const Facet<dim> &facet);

    /// As given.
    Facet<dim>        facet;
    PlaneFacet<dim>   y;      ///< Its vertices in the secondary's plane [m].
    VertexValues<dim> height; ///< n . (x_b - centre of the secondary)
  };

  /**
   * Motion of the projected vertices of both facets: for vertices of the
   * secondary and of the primary
   *   Delta y_c = e_c . (Delta x - Delta centre) - height (e_c . Delta n).
   */
  template <int dim>
  struct VertexMotion
  {
    /// Motion of both facets' vertices in the secondary's plane.
    VertexMotion(const SecondaryFrame<dim>   &frame,
                 const ProjectedPrimary<dim> &primary);

    /// [side][vertex]
    std::array<std::array<PlaneMotion<dim>, max_vertices<dim>>, 2> dy;
  };

  /**
   * Mortar segments: the overlap of two facets in the secondary's plane, cut
   * into simplices (an interval in 2d; in 3d triangles around the area
   * centroid, which must be the area centroid: with the mean of the vertices
   * the quadrature would jump when the overlap gains a vertex).
   *
   * A vertex that is almost on the line between its neighbours, where edges of
   * the two facets almost coincide, becomes the tip of a thin triangle of its
   * own: it runs along the whole edge while the facets move by next to nothing,
   * and around the centroid the quadrature would change with it as fast.
   */
  template <int dim>
  class MortarSegments
  {
  public:
    /// Cut @p overlap into simplices.
    explicit MortarSegments(const Overlap<dim> &overlap);

    /// Intervals (2d) or triangles.
    unsigned int
    n_simplices() const
    {
      return n_triangles;
    }

    /// Corner @p k of simplex @p s.
    const PlanePoint<dim> &
    corner(const unsigned int s, const unsigned int k) const;

    /// Area of simplex @p s (length in 2d), positive.
    double
    area(const unsigned int s) const;

    /// Compute the motion of all corners. Where they come from decides: facet
    /// vertices move with the facet, crossings with the two lines.
    void
    compute_motion(const SecondaryFrame<dim>   &frame,
                   const ProjectedPrimary<dim> &primary,
                   const VertexMotion<dim>     &vertices);

    /// Whether derivatives have been asked for.
    bool
    has_motion() const
    {
      return motion_known;
    }

    /// Motion of corner @p k of simplex @p s; after compute_motion().
    const PlaneMotion<dim> &
    motion(const unsigned int s, const unsigned int k) const;

    /// Derivative of the area of simplex @p s; after compute_motion().
    PairVector<dim>
    area_motion(const unsigned int s) const;

  private:
    /// Cut the overlap into triangles. @return No area is negative.
    bool
    cut(const bool with_tips);

    /// Number of corner @p k of simplex @p s; the centroid comes last.
    unsigned int
    corner_index(const unsigned int s, const unsigned int k) const
    {
      return (dim == 2) ? k : triangles[s][k];
    }

    /// Overlap vertices plus the centroid.
    static constexpr unsigned int max_corners = max_overlap_vertices<dim> + 1;

    bool         motion_known = false;
    Overlap<dim> overlap;
    unsigned int n_triangles = 1;
    std::array<std::array<unsigned int, 3>, max_overlap_vertices<dim>>
                                              triangles; ///< Not in 2d.
    PlanePoint<dim>                           centroid;
    std::array<PlaneMotion<dim>, max_corners> corner_motion;
  };
} // namespace MortarContact

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_geometry_clipping_h
#define mortar_contact_geometry_clipping_h

#include <mortar_contact/geometry/projection.h>

#include <array>

namespace MortarContact
{
  /// The two facets of a pair, where a name for the side is needed.
  enum class Side
  {
    secondary = 0,
    primary   = 1
  };

  /// A vertex of one of the two facets.
  struct FacetVertex
  {
    Side         side;   ///< Of the pair.
    unsigned int vertex; ///< Its number in that facet.
  };

  /// The line through two vertices of one facet.
  struct FacetLine
  {
    Side         side; ///< Of the pair.
    unsigned int from; ///< Vertex of that facet,
    unsigned int to;   ///< and another.
  };

  /**
   * A vertex of the overlap of two facets in the secondary's plane and where it
   * comes from: a vertex of one of the facets, or the crossing of two lines.
   * What it comes from is what moves it, see THEORY 2.4 and
   * mortar/segmentation.h.
   */
  template <int dim>
  struct OverlapVertex
  {
    PlanePoint<dim> y;                   ///< In the secondary's plane [m].
    bool            is_crossing = false; ///< Of two lines; else a vertex.
    FacetVertex     origin      = {Side::secondary, 0}; ///< If no crossing.
    FacetLine first  = {Side::secondary, 0, 0}; ///< If a crossing: of this line
    FacetLine second = {Side::secondary, 0, 0}; ///< and this one.
    /// Line on which the polygon's edge from this vertex to the next lies.
    FacetLine edge = {Side::secondary, 0, 0};
  };

  /// Two convex quadrilaterals have at most eight vertices in common; one more
  /// can occur for an instant while clipping.
  template <int dim>
  constexpr unsigned int max_overlap_vertices = (dim == 2) ? 2 : 10;

  /// The overlap: an interval (dim = 2) or a convex polygon, counter-clockwise.
  template <int dim>
  struct Overlap
  {
    /// Of the polygon; 0: no overlap.
    unsigned int n_vertices = 0;
    /// The first n_vertices count.
    std::array<OverlapVertex<dim>, max_overlap_vertices<dim>> vertices;
  };

  /// A convex piece of a projected facet: its vertices counter-clockwise (in
  /// 2d: from small to large) by their numbers in the facet.
  template <int dim>
  struct ConvexPiece
  {
    unsigned int n_vertices = 0; ///< Of the piece.
    /// Numbers in the facet; the first n_vertices count.
    std::array<unsigned int, max_vertices<dim>> vertices = {};
  };

  /// All pieces of one projected facet.
  template <int dim>
  struct ConvexPieces
  {
    unsigned int n_pieces = 0; ///< 0, 1 or 2.
    /// The first n_pieces count.
    std::array<ConvexPiece<dim>, 2> pieces = {};
  };

  /**
   * Cut a projected facet into convex pieces, for clipping only: itself if it
   * is convex, two triangles if it is a quadrilateral with a re-entrant corner
   * (a warped facet seen at an angle). No piece at all if it is folded or has
   * no area.
   */
  template <int dim>
  ConvexPieces<dim>
  convex_pieces(const unsigned int n_vertices, const PlaneFacet<dim> &y);

  /**
   * Overlap of two convex pieces by the method of Sutherland & Hodgman (1974,
   * doi:10.1145/360767.360802), remembering the origin of each vertex.
   *
   * Points closer than @p tolerance [length of the mesh] to a clipping line
   * count as inside, so that edges that coincide make no slivers.
   */
  template <int dim>
  Overlap<dim>
  clip(const PlaneFacet<dim>  &secondary,
       const ConvexPiece<dim> &secondary_piece,
       const PlaneFacet<dim>  &primary,
       const ConvexPiece<dim> &primary_piece,
       const double            tolerance);

  /// Signed area of the overlap (length in 2d).
  template <int dim>
  double
  area(const Overlap<dim> &overlap);
} // namespace MortarContact

#endif

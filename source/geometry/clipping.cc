// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/geometry/clipping.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Twice the area of the triangle (a, b, c); positive if counter-clockwise.
    double
    turn(const Tensor<1, 2> &a, const Tensor<1, 2> &b, const Tensor<1, 2> &c)
    {
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /// A corner is flat where its turn is below this times the facet's area.
    constexpr double flat_corner = 1e-12;

    /// An edge is none where its squared length is below this times the area.
    constexpr double no_edge = 1e-20;

    /// If two lines are the two edges of one facet that meet in a vertex, that
    /// vertex; @p found tells whether they are.
    FacetVertex
    common_vertex(const FacetLine &a, const FacetLine &b, bool &found)
    {
      found = (a.side == b.side);
      if (found && (a.from == b.from || a.from == b.to))
        return {a.side, a.from};
      if (found && (a.to == b.from || a.to == b.to))
        return {a.side, a.to};
      found = false;
      return {a.side, 0};
    }

    void
    append(Overlap<3> &polygon, const OverlapVertex<3> &vertex)
    {
      AssertIndexRange(polygon.n_vertices, max_overlap_vertices<3>);
      polygon.vertices[polygon.n_vertices++] = vertex;
    }

    /// Part of @p polygon on the left of the line from @p a to @p b.
    Overlap<3>
    clip_by_line(const Overlap<3>    &polygon,
                 const PlaneFacet<3> &secondary,
                 const FacetLine     &line,
                 const double         tolerance)
    {
      const Tensor<1, 2> a         = secondary[line.from];
      const Tensor<1, 2> direction = secondary[line.to] - a;
      const double       length    = direction.norm();

      const auto distance = [&](const OverlapVertex<3> &v) {
        return turn(a, a + direction, v.y) / length;
      };

      Overlap<3> result;
      for (unsigned int k = 0; k < polygon.n_vertices; ++k)
        {
          const OverlapVertex<3> &from = polygon.vertices[k];
          const OverlapVertex<3> &to =
            polygon.vertices[(k + 1) % polygon.n_vertices];
          const double d_from = distance(from);
          const double d_to   = distance(to);
          const bool   in     = d_from >= -tolerance;
          const bool   in_to  = d_to >= -tolerance;

          if (in)
            append(result, from);
          if (in == in_to)
            continue;

          // The edge crosses the line. Leaving, the polygon goes on along the
          // clipping line; entering, along its own edge.
          OverlapVertex<3> crossing;
          crossing.is_crossing = true;
          crossing.first       = from.edge;
          crossing.second      = line;
          // both ends may lie within the tolerance: never beyond the edge
          const double t = std::min(1., std::max(0., d_from / (d_from - d_to)));
          crossing.y     = from.y + t * (to.y - from.y);
          crossing.edge  = in ? line : from.edge;

          bool              is_corner = false;
          const FacetVertex corner = common_vertex(from.edge, line, is_corner);
          if (is_corner)
            {
              crossing.is_crossing = false;
              crossing.origin      = corner;
              crossing.y           = secondary[corner.vertex];
            }
          append(result, crossing);
        }
      return result;
    }
  } // namespace


  template <>
  double
  area<2>(const Overlap<2> &overlap)
  {
    return (overlap.n_vertices == 0) ?
             0. :
             overlap.vertices[1].y[0] - overlap.vertices[0].y[0];
  }


  template <>
  double
  area<3>(const Overlap<3> &overlap)
  {
    double twice_area = 0.;
    for (unsigned int k = 1; k + 1 < overlap.n_vertices; ++k)
      twice_area += turn(overlap.vertices[0].y,
                         overlap.vertices[k].y,
                         overlap.vertices[k + 1].y);
    return 0.5 * twice_area;
  }


  template <>
  ConvexPieces<2>
  convex_pieces<2>(const unsigned int, const PlaneFacet<2> &y)
  {
    ConvexPieces<2> result;
    if (y[0] == y[1])
      return result;
    result.n_pieces             = 1;
    result.pieces[0].n_vertices = 2;
    if (y[0][0] < y[1][0])
      result.pieces[0].vertices = {{0, 1}};
    else
      result.pieces[0].vertices = {{1, 0}};
    return result;
  }


  template <>
  ConvexPieces<3>
  convex_pieces<3>(const unsigned int n, const PlaneFacet<3> &y)
  {
    ConvexPieces<3> result;
    const double    twice_area = (n == 3) ?
                                   turn(y[0], y[1], y[2]) :
                                   turn(y[0], y[1], y[2]) + turn(y[0], y[2], y[3]);
    // written so that NaN has no area
    if (!(std::abs(twice_area) > 0.))
      return result;

    const bool reversed = twice_area < 0.;
    // Vertices are given modulo 4.
    const auto add_piece = [&](const unsigned int                n_corners,
                               const std::array<unsigned int, 4> corners) {
      ConvexPiece<3> &piece = result.pieces[result.n_pieces++];
      piece.n_vertices      = n_corners;
      for (unsigned int k = 0; k < n_corners; ++k)
        piece.vertices[k] = corners[reversed ? n_corners - 1 - k : k] % 4;
    };

    if (n == 3)
      {
        add_piece(3, {{0, 1, 2, 0}});
        return result;
      }

    // a quadrilateral that has lost an edge is a triangle: an edge without a
    // direction cuts nothing
    for (unsigned int a = 0; a < 4; ++a)
      if ((y[(a + 1) % 4] - y[a]).norm_square() <=
          no_edge * std::abs(twice_area))
        {
          add_piece(3, {{a + 1, a + 2, a + 3, 0}});
          return result;
        }

    unsigned int n_reentrant = 0, reentrant = 0;
    for (unsigned int a = 0; a < 4; ++a)
      if (turn(y[(a + 3) % 4], y[a], y[(a + 1) % 4]) / twice_area <
          -flat_corner)
        {
          ++n_reentrant;
          reentrant = a;
        }

    if (n_reentrant == 0)
      add_piece(4, {{0, 1, 2, 3}});
    else if (n_reentrant == 1)
      // the diagonal from the re-entrant corner cuts the facet in two triangles
      for (const unsigned int second : {1u, 2u})
        add_piece(3,
                  {{reentrant, reentrant + second, reentrant + second + 1, 0}});
    // else: folded like a bow tie
    return result;
  }


  template <>
  Overlap<2>
  clip<2>(const PlaneFacet<2>  &secondary,
          const ConvexPiece<2> &secondary_piece,
          const PlaneFacet<2>  &primary,
          const ConvexPiece<2> &primary_piece,
          const double          tolerance)
  {
    Overlap<2> result;
    result.n_vertices = 2;
    for (unsigned int end = 0; end < 2; ++end)
      {
        const unsigned int s = secondary_piece.vertices[end];
        const unsigned int p = primary_piece.vertices[end];
        // the larger of the lower ends, the smaller of the upper ends
        const double beyond = (end == 0) ? primary[p][0] - secondary[s][0] :
                                           secondary[s][0] - primary[p][0];
        OverlapVertex<2> &vertex = result.vertices[end];
        vertex.origin = (beyond > tolerance) ? FacetVertex{Side::primary, p} :
                                               FacetVertex{Side::secondary, s};
        vertex.y      = (beyond > tolerance) ? primary[p] : secondary[s];
      }
    if (!(area(result) > 0.))
      result.n_vertices = 0;
    return result;
  }


  template <>
  Overlap<3>
  clip<3>(const PlaneFacet<3>  &secondary,
          const ConvexPiece<3> &secondary_piece,
          const PlaneFacet<3>  &primary,
          const ConvexPiece<3> &primary_piece,
          const double          tolerance)
  {
    Overlap<3> polygon;
    for (unsigned int k = 0; k < primary_piece.n_vertices; ++k)
      {
        const unsigned int from = primary_piece.vertices[k];
        const unsigned int to =
          primary_piece.vertices[(k + 1) % primary_piece.n_vertices];
        OverlapVertex<3> vertex;
        vertex.y      = primary[from];
        vertex.origin = {Side::primary, from};
        vertex.edge   = {Side::primary, from, to};
        append(polygon, vertex);
      }
    for (unsigned int k = 0;
         k < secondary_piece.n_vertices && polygon.n_vertices > 0;
         ++k)
      {
        const FacetLine line = {
          Side::secondary,
          secondary_piece.vertices[k],
          secondary_piece.vertices[(k + 1) % secondary_piece.n_vertices]};
        polygon = clip_by_line(polygon, secondary, line, tolerance);
      }
    if (polygon.n_vertices < 3)
      polygon.n_vertices = 0;
    return polygon;
  }
} // namespace MortarContact

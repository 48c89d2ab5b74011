// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/pair_kernel.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <cmath>

namespace MortarContact
{
  namespace
  {
    /// Overlaps smaller than this times the smaller facet carry nothing: below
    /// the round-off of all sums.
    constexpr double negligible_area = 1e-14;

    /// Points this close to a clipping line, relative to the diameter of the
    /// secondary, lie on it.
    constexpr double coincident = 1e-13;

    /// Fixed points may miss a facet by this (reference units), so that none
    /// falls between two facets.
    constexpr double between_facets = 1e-9;
  } // namespace

  using namespace PairAlgebra;


  template <int dim>
  PairKernel<dim>::PairKernel(const PressureLaw   &law,
                              const FrictionLaw   *friction,
                              const KernelOptions &options)
    : point(law, friction, options)
    , options(point.options)
    , rule(simplex_rule<dim>(options.integration.degree))
  {
    const QGauss<1> gauss(options.integration.points_per_direction);
    for (unsigned int q = 0; q < gauss.size(); ++q)
      {
        points_1d.push_back(gauss.point(q)[0]);
        weights_1d.push_back(gauss.weight(q));
      }
  }


  template <int dim>
  std::vector<std::pair<PlanePoint<dim>, double>>
  PairKernel<dim>::fixed_points(const unsigned int n_vertices) const
  {
    std::vector<std::pair<PlanePoint<dim>, double>> points;
    if (options.integration.rule == Integration::Rule::nodes)
      {
        // each vertex with its share of the reference domain
        const double       domain = (dim == 3 && n_vertices == 3) ? 0.5 : 1.;
        const unsigned int n      = (dim == 2) ? 2 : n_vertices;
        for (unsigned int a = 0; a < n; ++a)
          points.emplace_back(reference_vertex<dim>(n, a), domain / n);
        return points;
      }
    if constexpr (dim == 2)
      {
        (void)n_vertices;
        for (unsigned int q = 0; q < points_1d.size(); ++q)
          points.emplace_back(PlanePoint<dim>({points_1d[q]}), weights_1d[q]);
      }
    else
      for (unsigned int r = 0; r < points_1d.size(); ++r)
        for (unsigned int q = 0; q < points_1d.size(); ++q)
          {
            // triangles: the square with one edge collapsed
            const double s = (n_vertices == 3) ? 1. - points_1d[r] : 1.;
            points.emplace_back(PlanePoint<dim>(
                                  {s * points_1d[q], points_1d[r]}),
                                s * weights_1d[q] * weights_1d[r]);
          }
    return points;
  }


  template <int dim>
  ContactStiffness
  PairKernel<dim>::stiffness(const ContactFacet<dim> &secondary,
                             const PlanePoint<dim>   &xi,
                             const ContactFacet<dim> &primary,
                             const PlanePoint<dim>   &eta) const
  {
    const auto N_s = shape_values<dim>(secondary.current.n_vertices, xi);
    const auto N_p = shape_values<dim>(primary.current.n_vertices, eta);
    return point.combine(dot<dim>(N_s, secondary.compliance),
                         dot<dim>(N_s, secondary.length),
                         dot<dim>(N_p, primary.compliance),
                         dot<dim>(N_p, primary.length));
  }


  template <int dim>
  std::optional<typename PairKernel<dim>::Hit>
  PairKernel<dim>::hit(const SecondaryFrame<dim> &frame,
                       const PlanePoint<dim>     &xi,
                       const ContactFacet<dim>   &primary) const
  {
    const ProjectedPrimary<dim> projected(frame, primary.current);
    PlanePoint<dim>             y;
    const auto N = shape_values<dim>(frame.facet.n_vertices, xi);
    for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
      y += N[a] * frame.y[a];
    const auto eta =
      inverse_map<dim>(primary.current.n_vertices, projected.y, y);
    if (!eta ||
        !is_inside<dim>(primary.current.n_vertices, *eta, between_facets))
      return {};
    const double depth =
      dot<dim>(N, frame.height) -
      dot<dim>(shape_values<dim>(primary.current.n_vertices, *eta),
               projected.height);
    return Hit{*eta, depth, {}};
  }


  template <int dim>
  PrimaryPoint<dim>
  PairKernel<dim>::primary_point(const ContactFacet<dim> &primary,
                                 const Facet<dim>        *before,
                                 const PlanePoint<dim>   &eta,
                                 const bool               is_open) const
  {
    constexpr unsigned int T = dim - 1;
    PrimaryPoint<dim>      p;
    p.n_vertices     = primary.current.n_vertices;
    p.N              = shape_values<dim>(p.n_vertices, eta);
    p.dN             = shape_gradients<dim>(p.n_vertices, eta);
    p.x              = interpolate(primary.current, p.N);
    p.compliance     = dot<dim>(p.N, primary.compliance);
    p.length         = dot<dim>(p.N, primary.length);
    p.surface_offset = primary.surface_offset;
    for (unsigned int b = 0; b < T; ++b)
      p.tangents[b] = interpolate(primary.current, p.dN[b]);
    if (is_open)
      return p;
    for (unsigned int b = 0; b < T; ++b)
      {
        p.dcompliance[b] = dot<dim>(p.dN[b], primary.compliance);
        p.dlength[b]     = dot<dim>(p.dN[b], primary.length);
      }
    if (p.n_vertices == 4)
      {
        Tensor<1, dim> twist;
        for (unsigned int v = 0; v < 4; ++v)
          twist += shape_twist<dim>(4, v) * primary.current.x[v];
        p.second[0][T - 1] = twist;
        p.second[T - 1][0] = twist;
      }
    if (before != nullptr)
      {
        p.before = interpolate(*before, p.N);
        for (unsigned int b = 0; b < T; ++b)
          p.before_tangents[b] = interpolate(*before, p.dN[b]);
      }
    return p;
  }


  template <int dim>
  void
  PairKernel<dim>::add_fixed_point(const SecondaryFrame<dim> &frame,
                                   const ContactFacet<dim>   &secondary,
                                   const SecondaryState<dim> &state,
                                   const PrimaryPoint<dim>   &primary,
                                   const PlanePoint<dim>     &xi,
                                   const double               weight,
                                   const bool                 with_tangent,
                                   PairBlock<dim>            &block) const
  {
    ContactPoint<dim> at;
    at.xi     = xi;
    at.weight = weight * area_element(secondary.reference, xi);
    CurvatureSums<dim> sums;
    point.add_point(
      frame, secondary, state, primary, at, with_tangent, sums, block);
    if (with_tangent)
      point.add_curvature(frame, sums, block);
  }


  namespace
  {
    /**
     * Visit the points of all mortar segments of a pair:
     *   visit(segments, s, number, q, xi, eta, J),
     * s a simplex of the segments, number its number in the pair, q a point of
     * the rule on it, J the Jacobian of the secondary's plane map there.
     * @return False if a facet has no usable shape.
     */
    template <int dim, class Visitor>
    bool
    visit_segments(const SecondaryFrame<dim>            &frame,
                   const ProjectedPrimary<dim>          &projected,
                   const std::vector<SimplexPoint<dim>> &rule,
                   const Visitor                        &visit)
    {
      const unsigned int      n_s      = frame.facet.n_vertices;
      const unsigned int      n_p      = projected.facet.n_vertices;
      const ConvexPieces<dim> pieces_s = convex_pieces<dim>(n_s, frame.y);
      const ConvexPieces<dim> pieces_p = convex_pieces<dim>(n_p, projected.y);
      if (pieces_s.n_pieces == 0 || pieces_p.n_pieces == 0)
        return false;
      const double minimum_area =
        negligible_area * MortarContact::area(frame.facet);

      bool         is_fine = true;
      unsigned int number  = 0;
      for (unsigned int i = 0; i < pieces_s.n_pieces; ++i)
        for (unsigned int j = 0; j < pieces_p.n_pieces; ++j)
          {
            const Overlap<dim> overlap = clip<dim>(frame.y,
                                                   pieces_s.pieces[i],
                                                   projected.y,
                                                   pieces_p.pieces[j],
                                                   coincident * frame.diameter);
            if (overlap.n_vertices == 0 ||
                !(MortarContact::area(overlap) > minimum_area))
              continue;
            MortarSegments<dim> segments(overlap);
            for (unsigned int s = 0; s < segments.n_simplices(); ++s, ++number)
              for (const SimplexPoint<dim> &q : rule)
                {
                  PlanePoint<dim> y;
                  for (unsigned int k = 0; k < dim; ++k)
                    y += q.lambda[k] * segments.corner(s, k);
                  const auto xi  = inverse_map<dim>(n_s, frame.y, y);
                  const auto eta = inverse_map<dim>(n_p, projected.y, y);
                  if (xi && eta)
                    visit(segments,
                          s,
                          number,
                          q,
                          *xi,
                          *eta,
                          plane_jacobian<dim>(n_s, frame.y, *xi));
                  else
                    is_fine = false;
                }
          }
      return is_fine;
    }
  } // namespace


  template <int dim>
  std::vector<typename PairKernel<dim>::SegmentPoint>
  PairKernel<dim>::segment_points(const SecondaryFrame<dim> &frame,
                                  const ContactFacet<dim>   &secondary,
                                  const ContactFacet<dim>   &primary) const
  {
    std::vector<SegmentPoint> points;
    visit_segments(frame,
                   ProjectedPrimary<dim>(frame, primary.current),
                   rule,
                   [&](const MortarSegments<dim> &segments,
                       const unsigned int         s,
                       const unsigned int,
                       const SimplexPoint<dim>  &q,
                       const PlanePoint<dim>    &xi,
                       const PlanePoint<dim>    &eta,
                       const Tensor<2, dim - 1> &J) {
                     points.push_back({xi,
                                       eta,
                                       segments.area(s) * q.weight *
                                         area_element(secondary.reference, xi) /
                                         determinant(J)});
                   });
    return points;
  }


  template <int dim>
  void
  PairKernel<dim>::evaluate_segments(const SecondaryFrame<dim> &frame,
                                     const ContactFacet<dim>   &secondary,
                                     const SecondaryState<dim> &state,
                                     const ContactFacet<dim>   &primary,
                                     const Facet<dim>          *primary_before,
                                     const double               weight,
                                     const bool                 with_tangent,
                                     PairBlock<dim>            &block) const
  {
    const unsigned int          n_s = secondary.current.n_vertices;
    const unsigned int          n_p = primary.current.n_vertices;
    const ProjectedPrimary<dim> projected(frame, primary.current);

    std::optional<VertexMotion<dim>> vertex_motion;
    CurvatureSums<dim>               sums;
    PairVector<dim>                  darea;
    // simplex that darea belongs to
    unsigned int darea_of  = numbers::invalid_unsigned_int;
    const auto   add_point = [&](MortarSegments<dim>      &segments,
                               const unsigned int        s,
                               const unsigned int        number,
                               const SimplexPoint<dim>  &q,
                               const PlanePoint<dim>    &xi,
                               const PlanePoint<dim>    &eta,
                               const Tensor<2, dim - 1> &J) {
      ContactPoint<dim> at;
      at.xi              = xi;
      const double J0    = area_element(secondary.reference, xi);
      const double J_y   = determinant(J);
      const double ratio = weight * q.weight * J0 / J_y;
      at.weight          = segments.area(s) * ratio;

      // Motion of the point and of its weight. Needed where
      // there is penetration only; a depth that the offset takes
      // back costs a little in vain.
      const auto   N = shape_values<dim>(n_s, xi);
      const double depth =
        dot<dim>(N, frame.height) -
        dot<dim>(shape_values<dim>(n_p, eta), projected.height) +
        secondary.surface_offset + primary.surface_offset +
        std::max(0., dot<dim>(N, state.augmentation));
      const bool is_open = !(depth > 0.);
      if (with_tangent && !is_open)
        {
          if (!vertex_motion)
            vertex_motion.emplace(frame, projected);
          if (!segments.has_motion())
            segments.compute_motion(frame, projected, *vertex_motion);
          if (darea_of != number)
            {
              darea    = segments.area_motion(s);
              darea_of = number;
            }

          // J dxi = dy - N_a dy_a
          PlaneMotion<dim> dy = {};
          for (unsigned int k = 0; k < dim; ++k)
            for (unsigned int c = 0; c < dim - 1; ++c)
              add(q.lambda[k], segments.motion(s, k)[c], dy[c]);
          const auto &dy_s = vertex_motion->dy[0];
          for (unsigned int a = 0; a < n_s; ++a)
            for (unsigned int c = 0; c < dim - 1; ++c)
              add_secondary(-N[a], dy_s[a][c], dy[c]);
          const Tensor<2, dim - 1> J_inv = invert(J);
          at.moves                       = true;
          for (unsigned int c = 0; c < dim - 1; ++c)
            {
              at.dxi[c] = scaled(J_inv[c][0], dy[0]);
              for (unsigned int r = 1; r < dim - 1; ++r)
                add(J_inv[c][r], dy[r], at.dxi[c]);
            }
          // W = w A J0 / J_y:
          // dW = w J0/J_y dA + W (dJ0/J0 - dJ_y/J_y)
          at.dweight    = scaled(ratio, darea);
          const auto dN = shape_gradients<dim>(n_s, xi);
          for (unsigned int a = 0; a < n_s; ++a)
            for (unsigned int r = 0; r < dim - 1; ++r)
              {
                double g = 0.;
                for (unsigned int c = 0; c < dim - 1; ++c)
                  g += dN[c][a] * J_inv[c][r];
                add_secondary(-at.weight * g, dy_s[a][r], at.dweight);
              }
          if constexpr (dim == 3)
            if (n_s == 4)
              {
                // second derivatives of the two bilinear maps
                VertexValues<dim> twist;
                PlanePoint<dim>   y_twist;
                for (unsigned int a = 0; a < 4; ++a)
                  {
                    twist[a] = shape_twist<dim>(4, a);
                    y_twist += twist[a] * frame.y[a];
                  }
                const auto X_twist = interpolate(secondary.reference, twist);
                const auto X_0     = interpolate(secondary.reference, dN[0]);
                const auto X_1     = interpolate(secondary.reference, dN[1]);
                const auto m       = cross_product_3d(X_0, X_1);
                const std::array<double, 2> dJ0 = {
                  {cross_product_3d(X_0, X_twist) * m / J0,
                   cross_product_3d(X_twist, X_1) * m / J0}};
                for (unsigned int c = 0; c < 2; ++c)
                  {
                    double log_dJ_y = 0.;
                    for (unsigned int r = 0; r < 2; ++r)
                      log_dJ_y += J_inv[1 - c][r] * y_twist[r];
                    add(at.weight * (dJ0[c] / J0 - log_dJ_y),
                        at.dxi[c],
                        at.dweight);
                  }
              }
        }
      point.add_point(frame,
                      secondary,
                      state,
                      primary_point(primary, primary_before, eta, is_open),
                      at,
                      with_tangent,
                      sums,
                      block);
    };
    block.is_degenerate = !visit_segments(frame, projected, rule, add_point);
    if (with_tangent && block.is_active())
      point.add_curvature(frame, sums, block);
  }


  template <int dim>
  void
  PairKernel<dim>::finish(PairBlock<dim> &block) const
  {
    if (options.symmetrise)
      symmetrise(block.tangent);
  }


  template class PairKernel<2>;
  template class PairKernel<3>;
} // namespace MortarContact

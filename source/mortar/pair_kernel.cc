// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/initial_penetration.h>
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

    template <std::size_t n>
    void
    add(const double                 factor,
        const std::array<double, n> &v,
        std::array<double, n>       &sum)
    {
      for (std::size_t i = 0; i < n; ++i)
        sum[i] += factor * v[i];
    }

    /// sum += left right^T
    template <std::size_t n>
    void
    add_outer(const std::array<double, n>          &left,
              const std::array<double, n>          &right,
              std::array<std::array<double, n>, n> &sum)
    {
      for (std::size_t i = 0; i < n; ++i)
        if (left[i] != 0.)
          add(left[i], right, sum[i]);
    }

    template <int dim>
    double
    dot(const VertexValues<dim> &a, const VertexValues<dim> &b)
    {
      double sum = 0.;
      for (unsigned int i = 0; i < max_vertices<dim>; ++i)
        sum += a[i] * b[i];
      return sum;
    }
  } // namespace


  /// A contact point with the motion of its place and weight.
  template <int dim>
  struct PairKernel<dim>::Point
  {
    PlanePoint<dim>  xi, eta;
    double           weight; ///< W, reference area times the sweep's weight.
    bool             moves = false; ///< Whether the next two are there.
    PairVector<dim>  dweight;
    PlaneMotion<dim> dxi;
  };

  /// What can be summed over the points of a pair before the last product.
  template <int dim>
  struct PairKernel<dim>::Sums
  {
    Tensor<1, dim> curvature_across;     ///< sum of W sigma d a
    double         curvature_along = 0.; ///< sum of W sigma d
  };


  template <int dim>
  PairKernel<dim>::PairKernel(const PressureLaw   &law,
                              const KernelOptions &options)
    : options(options)
    , law(&law)
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
  PairKernel<dim>::combine(const double c_s,
                           const double l_s,
                           const double c_p,
                           const double l_p) const
  {
    if (options.stiffness_side == StiffnessSide::series)
      return in_series(c_s, l_s, c_p, l_p);
    return {l_s / c_s, l_s};
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
    return combine(dot<dim>(N_s, secondary.compliance),
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
    return Hit{*eta, depth};
  }


  template <int dim>
  void
  PairKernel<dim>::add_fixed_point(const SecondaryFrame<dim> &frame,
                                   const ContactFacet<dim>   &secondary,
                                   const FacetOffset<dim>    &offset,
                                   const ContactFacet<dim>   &primary,
                                   const PlanePoint<dim>     &xi,
                                   const PlanePoint<dim>     &eta,
                                   const double               weight,
                                   const bool                 with_tangent,
                                   PairBlock<dim>            &block) const
  {
    Point point;
    point.xi     = xi;
    point.eta    = eta;
    point.weight = weight * area_element(secondary.reference, xi);
    Sums sums;
    add_point(
      frame, secondary, offset, primary, point, with_tangent, sums, block);
    if (with_tangent)
      add_sums(frame, sums, block);
  }


  template <int dim>
  void
  PairKernel<dim>::evaluate_segments(const SecondaryFrame<dim> &frame,
                                     const ContactFacet<dim>   &secondary,
                                     const FacetOffset<dim>    &offset,
                                     const ContactFacet<dim>   &primary,
                                     const double               weight,
                                     const bool                 with_tangent,
                                     PairBlock<dim>            &block) const
  {
    const unsigned int n_s = secondary.current.n_vertices;
    const unsigned int n_p = primary.current.n_vertices;

    // Step 1: overlaps in the secondary's plane.
    const ProjectedPrimary<dim> projected(frame, primary.current);
    const ConvexPieces<dim>     pieces_s = convex_pieces<dim>(n_s, frame.y);
    const ConvexPieces<dim>     pieces_p = convex_pieces<dim>(n_p, projected.y);
    if (pieces_s.n_pieces == 0 || pieces_p.n_pieces == 0)
      {
        block.is_degenerate = true;
        return;
      }
    const double minimum_area =
      negligible_area * MortarContact::area(frame.facet);

    std::optional<VertexMotion<dim>> vertex_motion;
    Sums                             sums;
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
          bool                motion_known = false;

          // Step 2: the points of all simplices.
          for (unsigned int s = 0; s < segments.n_simplices(); ++s)
            {
              const double    simplex_area = segments.area(s);
              PairVector<dim> darea        = {};
              bool            darea_known  = false;
              for (const SimplexPoint<dim> &q : rule)
                {
                  PlanePoint<dim> y;
                  for (unsigned int k = 0; k < dim; ++k)
                    y += q.lambda[k] * segments.corner(s, k);
                  const auto xi  = inverse_map<dim>(n_s, frame.y, y);
                  const auto eta = inverse_map<dim>(n_p, projected.y, y);
                  if (!xi || !eta)
                    {
                      block.is_degenerate = true;
                      continue;
                    }

                  Point point;
                  point.xi  = *xi;
                  point.eta = *eta;
                  const Tensor<2, dim - 1> J =
                    plane_jacobian<dim>(n_s, frame.y, *xi);
                  const double J0    = area_element(secondary.reference, *xi);
                  const double J_y   = determinant(J);
                  const double ratio = weight * q.weight * J0 / J_y;
                  point.weight       = simplex_area * ratio;

                  // Step 3: motion of the point and of its weight. Needed where
                  // there is penetration only; a depth that the offset takes
                  // back costs a little in vain.
                  const auto   N = shape_values<dim>(n_s, *xi);
                  const double depth =
                    dot<dim>(N, frame.height) -
                    dot<dim>(shape_values<dim>(n_p, *eta), projected.height) +
                    secondary.surface_offset + primary.surface_offset;
                  if (with_tangent && depth > 0.)
                    {
                      if (!motion_known)
                        {
                          if (!vertex_motion)
                            vertex_motion.emplace(frame, projected);
                          segments.compute_motion(frame,
                                                  projected,
                                                  *vertex_motion);
                          motion_known = true;
                        }
                      if (!darea_known)
                        {
                          darea       = segments.area_motion(s);
                          darea_known = true;
                        }

                      // J dxi = dy - N_a dy_a
                      PlaneMotion<dim> dy = {};
                      for (unsigned int k = 0; k < dim; ++k)
                        for (unsigned int c = 0; c < dim - 1; ++c)
                          add(q.lambda[k], segments.motion(s, k)[c], dy[c]);
                      const auto &dy_s = vertex_motion->dy[0];
                      for (unsigned int a = 0; a < n_s; ++a)
                        for (unsigned int c = 0; c < dim - 1; ++c)
                          add(-N[a], dy_s[a][c], dy[c]);
                      const Tensor<2, dim - 1> J_inv = invert(J);
                      point.moves                    = true;
                      point.dxi                      = {};
                      for (unsigned int c = 0; c < dim - 1; ++c)
                        for (unsigned int r = 0; r < dim - 1; ++r)
                          add(J_inv[c][r], dy[r], point.dxi[c]);

                      // W = w A J0 / J_y:
                      // dW = w J0/J_y dA + W (dJ0/J0 - dJ_y/J_y)
                      point.dweight = {};
                      add(ratio, darea, point.dweight);
                      const auto dN = shape_gradients<dim>(n_s, *xi);
                      for (unsigned int a = 0; a < n_s; ++a)
                        for (unsigned int r = 0; r < dim - 1; ++r)
                          {
                            double g = 0.;
                            for (unsigned int c = 0; c < dim - 1; ++c)
                              g += dN[c][a] * J_inv[c][r];
                            add(-point.weight * g, dy_s[a][r], point.dweight);
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
                            const auto X_twist =
                              interpolate(secondary.reference, twist);
                            const auto X_0 =
                              interpolate(secondary.reference, dN[0]);
                            const auto X_1 =
                              interpolate(secondary.reference, dN[1]);
                            const auto m = cross_product_3d(X_0, X_1);
                            const std::array<double, 2> dJ0 = {
                              {cross_product_3d(X_0, X_twist) * m / J0,
                               cross_product_3d(X_twist, X_1) * m / J0}};
                            for (unsigned int c = 0; c < 2; ++c)
                              {
                                double log_dJ_y = 0.;
                                for (unsigned int r = 0; r < 2; ++r)
                                  log_dJ_y += J_inv[1 - c][r] * y_twist[r];
                                add(point.weight * (dJ0[c] / J0 - log_dJ_y),
                                    point.dxi[c],
                                    point.dweight);
                              }
                          }
                    }
                  add_point(frame,
                            secondary,
                            offset,
                            primary,
                            point,
                            with_tangent,
                            sums,
                            block);
                }
            }
        }
    if (with_tangent && block.is_active())
      add_sums(frame, sums, block);
  }


  template <int dim>
  void
  PairKernel<dim>::add_point(const SecondaryFrame<dim> &frame,
                             const ContactFacet<dim>   &secondary,
                             const FacetOffset<dim>    &offset,
                             const ContactFacet<dim>   &primary,
                             const Point               &point,
                             const bool                 with_tangent,
                             Sums                      &sums,
                             PairBlock<dim>            &block) const
  {
    const unsigned int     n_s = secondary.current.n_vertices;
    const unsigned int     n_p = primary.current.n_vertices;
    constexpr unsigned int P   = max_facet_components<dim>;
    constexpr unsigned int T   = dim - 1;
    const Tensor<1, dim>  &n   = frame.normal;

    // Step 1: the two points and the penetration.
    const auto           N_s      = shape_values<dim>(n_s, point.xi);
    const auto           N_p      = shape_values<dim>(n_p, point.eta);
    const auto           dN_s     = shape_gradients<dim>(n_s, point.xi);
    const auto           dN_p     = shape_gradients<dim>(n_p, point.eta);
    const Tensor<1, dim> x_s      = interpolate(secondary.current, N_s);
    const Tensor<1, dim> x_p      = interpolate(primary.current, N_p);
    const double         distance = n * (x_s - x_p);

    const double level = (offset.share > 0.) ? dot<dim>(N_s, offset.level) : 0.;
    const double overlap =
      distance + secondary.surface_offset + primary.surface_offset;
    const double d = overlap - MortarContact::offset(level, offset.share);

    // Step 2: stiffness and facing angle.
    const double l_s    = dot<dim>(N_s, secondary.length);
    const double c_s    = dot<dim>(N_s, secondary.compliance);
    const double l_p    = dot<dim>(N_p, primary.length);
    const double c_p    = dot<dim>(N_p, primary.compliance);
    const bool   series = options.stiffness_side == StiffnessSide::series;
    const ContactStiffness stiffness = combine(c_s, l_s, c_p, l_p);

    std::array<Tensor<1, dim>, T> t_p, t_s;
    for (unsigned int c = 0; c < T; ++c)
      {
        t_p[c] = interpolate(primary.current, dN_p[c]);
        t_s[c] = interpolate(secondary.current, dN_s[c]);
      }
    Tensor<1, dim> m;
    if constexpr (dim == 2)
      m = cross_product_2d(t_p[0]);
    else
      m = cross_product_3d(t_p[0], t_p[1]);
    const double m_norm = m.norm();
    const double cosine = -(n * m) / m_norm;
    if (!(cosine > options.zero_cosine))
      return;

    block.area += point.weight;
    ++block.n_points;
    if (d > options.ceiling * stiffness.length)
      {
        ++block.n_beyond;
        return;
      }
    block.smallest_gap = std::min(block.smallest_gap, -d);
    block.overlap      = std::max(block.overlap, overlap);
    if (!(d > 0.))
      return;

    const double s      = std::min(1.,
                              (cosine - options.zero_cosine) /
                                (options.full_cosine - options.zero_cosine));
    const double facing = s * s * (3. - 2. * s);

    const NormalResponse r =
      law->evaluate(d, stiffness.modulus, stiffness.length);
    const double W       = point.weight;
    const double sigma   = r.pressure * facing;
    const double W_sigma = W * sigma;

    ++block.n_active;
    block.active_area += W;
    block.penetration_volume += W * d;
    block.energy += W * r.energy;
    if (d > block.penetration)
      {
        block.penetration      = d;
        block.deepest_position = x_s;
      }
    block.relative_penetration =
      std::max(block.relative_penetration, d / stiffness.length);

    // Step 3: first variation. With the dual basis of (t_p, n),
    //   delta d = a . v,  delta eta_b = a_b . v,
    //   v = delta x_s - delta x_p - distance delta n.
    const Tensor<1, dim>          a = m / (m * n);
    std::array<Tensor<1, dim>, T> a_eta;
    if constexpr (dim == 2)
      {
        a_eta[0] = cross_product_2d(n);
        a_eta[0] /= a_eta[0] * t_p[0];
      }
    else
      {
        a_eta[0] = cross_product_3d(t_p[1], n);
        a_eta[1] = cross_product_3d(n, t_p[0]);
        for (unsigned int c = 0; c < T; ++c)
          a_eta[c] /= a_eta[c] * t_p[c];
      }

    std::array<Tensor<1, dim>, max_vertices<dim>> a_dn;
    for (unsigned int v = 0; v < n_s; ++v)
      a_dn[v] = a * frame.dn[v];

    PairVector<dim> g = {};
    for (unsigned int v = 0; v < n_s; ++v)
      for (unsigned int i = 0; i < dim; ++i)
        g[v * dim + i] = N_s[v] * a[i] - distance * a_dn[v][i];
    for (unsigned int v = 0; v < n_p; ++v)
      for (unsigned int i = 0; i < dim; ++i)
        g[P + v * dim + i] = -N_p[v] * a[i];

    add(W_sigma, g, block.residual);
    if (!with_tangent)
      return;

    // Step 4: the tangent, W sigma d2d + g (sigma dW + W dsigma) + W sigma
    // (dg/dxi) dxi. First the variation of eta at fixed xi, and of n.
    PlaneMotion<dim> deta = {};
    for (unsigned int c = 0; c < T; ++c)
      {
        for (unsigned int v = 0; v < n_s; ++v)
          {
            const Tensor<1, dim> a_eta_dn = a_eta[c] * frame.dn[v];
            for (unsigned int i = 0; i < dim; ++i)
              deta[c][v * dim + i] =
                N_s[v] * a_eta[c][i] - distance * a_eta_dn[i];
          }
        for (unsigned int v = 0; v < n_p; ++v)
          for (unsigned int i = 0; i < dim; ++i)
            deta[c][P + v * dim + i] = -N_p[v] * a_eta[c][i];
      }
    PairVector<dim> a_dn_row = {};
    for (unsigned int v = 0; v < n_s; ++v)
      for (unsigned int i = 0; i < dim; ++i)
        a_dn_row[v * dim + i] = a_dn[v][i];
    std::array<PairVector<dim>, T> a_dt = {};
    for (unsigned int c = 0; c < T; ++c)
      for (unsigned int v = 0; v < n_p; ++v)
        for (unsigned int i = 0; i < dim; ++i)
          a_dt[c][P + v * dim + i] = dN_p[c][v] * a[i];

    // a . t_p,12, nonzero on warped or distorted primaries only
    double a_twist = 0.;
    if constexpr (dim == 3)
      if (n_p == 4)
        for (unsigned int v = 0; v < 4; ++v)
          a_twist += shape_twist<dim>(4, v) * (a * primary.current.x[v]);

    // Derivatives along xi at fixed vertices: d, eta, and g.
    std::array<double, T>                d_xi;
    std::array<std::array<double, T>, T> eta_xi; // [eta][xi]
    for (unsigned int c = 0; c < T; ++c)
      {
        d_xi[c] = a * t_s[c];
        for (unsigned int b = 0; b < T; ++b)
          eta_xi[b][c] = a_eta[b] * t_s[c];
      }

    // d2d/dx2 = -[ a_dt_b deta_b + deta_b a_dt_b + a_twist (deta_1 deta_2 + ..)
    //              + g a_dn + a_dn g + distance a . d2n ]
    PairVector<dim> right_of_g   = {};
    PairVector<dim> right_of_adn = {};
    add(-W_sigma, a_dn_row, right_of_g);
    add(-W_sigma, g, right_of_adn);
    for (unsigned int b = 0; b < T; ++b)
      {
        PairVector<dim> right_of_adt = {};
        add(-W_sigma, deta[b], right_of_adt);
        PairVector<dim> right_of_deta = {};
        add(-W_sigma, a_dt[b], right_of_deta);
        if (T == 2)
          add(-W_sigma * a_twist, deta[T - 1 - b], right_of_deta);

        if (point.moves)
          // dg/dxi_c = a . (dN_s - dt_b eta_b,c - t_12 ...) - a_dn d,c ; the
          // parts along a_dt_b and deta_b are added here
          for (unsigned int c = 0; c < T; ++c)
            {
              add(-W_sigma * eta_xi[b][c], point.dxi[c], right_of_adt);
              if (T == 2)
                add(-W_sigma * a_twist * eta_xi[T - 1 - b][c],
                    point.dxi[c],
                    right_of_deta);
            }
        add_outer(a_dt[b], right_of_adt, block.tangent);
        add_outer(deta[b], right_of_deta, block.tangent);
      }
    sums.curvature_across += W_sigma * distance * a;
    sums.curvature_along += W_sigma * distance;

    // Total motion of d, of eta, and of the two stiffness values.
    PairVector<dim> dd = g;
    if (point.moves)
      {
        add(sigma, point.dweight, right_of_g);
        for (unsigned int c = 0; c < T; ++c)
          {
            add(-W_sigma * d_xi[c], point.dxi[c], right_of_adn);
            PairVector<dim> dN_a = {};
            for (unsigned int v = 0; v < n_s; ++v)
              for (unsigned int i = 0; i < dim; ++i)
                dN_a[v * dim + i] = W_sigma * dN_s[c][v] * a[i];
            add_outer(dN_a, point.dxi[c], block.tangent);

            double d_effective_xi = d_xi[c];
            if (level > 0.)
              d_effective_xi -= offset.share * dot<dim>(dN_s[c], offset.level);
            add(d_effective_xi, point.dxi[c], dd);
            for (unsigned int b = 0; b < T; ++b)
              add(eta_xi[b][c], point.dxi[c], deta[b]);
          }
      }
    add(W * facing * r.stiffness, dd, right_of_g);

    // p = K phi(d/l): dp/dK = p/K, dp/dl = -(d/l) dp/dd
    const double dp_dl = -d / stiffness.length * r.stiffness;
    const double dp_dK = r.pressure / stiffness.modulus;
    // with c = c_s + c_p: l = (c_s l_s + c_p l_p)/c and K = l/c
    const auto dp = [&](const double dc, const double dcl) {
      if (series)
        {
          const double c  = c_s + c_p;
          const double dl = (dcl - stiffness.length * dc) / c;
          return dp_dl * dl + dp_dK * (dl - stiffness.modulus * dc) / c;
        }
      const double dl = (dcl - l_s * dc) / c_s;
      return dp_dl * dl + dp_dK * (dl - stiffness.modulus * dc) / c_s;
    };
    for (unsigned int c = 0; c < T; ++c)
      {
        if (point.moves)
          {
            const double dc = dot<dim>(dN_s[c], secondary.compliance);
            const double dl = dot<dim>(dN_s[c], secondary.length);
            add(W * facing * dp(dc, dc * l_s + c_s * dl),
                point.dxi[c],
                right_of_g);
          }
        if (series)
          {
            const double dc = dot<dim>(dN_p[c], primary.compliance);
            const double dl = dot<dim>(dN_p[c], primary.length);
            add(W * facing * dp(dc, dc * l_p + c_p * dl), deta[c], right_of_g);
          }
      }

    // Facing angle: cosine = -n . m / |m|.
    if (s < 1.)
      {
        const double dfacing =
          6. * s * (1. - s) / (options.full_cosine - options.zero_cosine);
        const Tensor<1, dim> n_p_unit = m / m_norm;
        const Tensor<1, dim> across =
          -(n + cosine * n_p_unit) / m_norm; // d(cosine)/dm
        PairVector<dim> dcosine = {};
        for (unsigned int v = 0; v < n_s; ++v)
          {
            const Tensor<1, dim> tilt = n_p_unit * frame.dn[v];
            for (unsigned int i = 0; i < dim; ++i)
              dcosine[v * dim + i] -= tilt[i];
          }
        if constexpr (dim == 2)
          for (unsigned int v = 0; v < n_p; ++v)
            {
              dcosine[P + v * dim + 0] -= dN_p[0][v] * across[1];
              dcosine[P + v * dim + 1] += dN_p[0][v] * across[0];
            }
        else
          {
            const Tensor<1, dim> by_t0 = cross_product_3d(t_p[1], across);
            const Tensor<1, dim> by_t1 = cross_product_3d(across, t_p[0]);
            for (unsigned int v = 0; v < n_p; ++v)
              for (unsigned int i = 0; i < dim; ++i)
                dcosine[P + v * dim + i] +=
                  dN_p[0][v] * by_t0[i] + dN_p[1][v] * by_t1[i];
            if (n_p == 4)
              {
                Tensor<1, dim> twist;
                for (unsigned int v = 0; v < 4; ++v)
                  twist += shape_twist<dim>(4, v) * primary.current.x[v];
                add(by_t0 * twist, deta[1], dcosine);
                add(by_t1 * twist, deta[0], dcosine);
              }
          }
        add(W * r.pressure * dfacing, dcosine, right_of_g);
      }

    add_outer(g, right_of_g, block.tangent);
    add_outer(a_dn_row, right_of_adn, block.tangent);
  }


  template <int dim>
  void
  PairKernel<dim>::add_sums(const SecondaryFrame<dim> &frame,
                            const Sums                &sums,
                            PairBlock<dim>            &block) const
  {
    // -distance a . d2n, with a . n = 1
    const auto curvature =
      frame.normal_curvature(sums.curvature_across, sums.curvature_along);
    for (unsigned int i = 0; i < max_facet_components<dim>; ++i)
      for (unsigned int j = 0; j < max_facet_components<dim>; ++j)
        block.tangent[i][j] -= curvature[i][j];
  }


  template <int dim>
  void
  PairKernel<dim>::finish(PairBlock<dim> &block) const
  {
    if (!options.symmetrise)
      return;
    for (unsigned int i = 0; i < max_pair_components<dim>; ++i)
      for (unsigned int j = 0; j < i; ++j)
        {
          const double mean = 0.5 * (block.tangent[i][j] + block.tangent[j][i]);
          block.tangent[i][j] = mean;
          block.tangent[j][i] = mean;
        }
  }


  template class PairKernel<2>;
  template class PairKernel<3>;
} // namespace MortarContact

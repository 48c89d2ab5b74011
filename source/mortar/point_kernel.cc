// SPDX-License-Identifier: LGPL-2.1-or-later
#include "point_kinematics.h"
#include "vector_clones.h"

#include <mortar_contact/laws/initial_penetration.h>

#include <cmath>

namespace MortarContact
{
  using namespace PairAlgebra;

  template <int dim>
  PointKernel<dim>::PointKernel(const PressureLaw   &law,
                                const FrictionLaw   *friction,
                                const KernelOptions &options)
    : options(options)
    , law(&law)
    , friction(friction)
  {}


  template <int dim>
  ContactStiffness
  PointKernel<dim>::combine(const double c_s,
                            const double l_s,
                            const double c_p,
                            const double l_p) const
  {
    // where the secondary is rigid, the primary gives way
    if (options.stiffness_side == StiffnessSide::series || c_s == 0.)
      return in_series(c_s, l_s, c_p, l_p);
    return {l_s / c_s, l_s};
  }


  template <int dim>
  typename PointKernel<dim>::Kinematics
  PointKernel<dim>::kinematics(const SecondaryFrame<dim> &frame,
                               const ContactFacet<dim>   &secondary,
                               const SecondaryState<dim> &state,
                               const PrimaryPoint<dim>   &primary,
                               const PlanePoint<dim>     &xi) const
  {
    const unsigned int n_s = secondary.current.n_vertices;
    Kinematics         k;
    k.N_s      = shape_values<dim>(n_s, xi);
    k.dN_s     = shape_gradients<dim>(n_s, xi);
    k.x_s      = interpolate(secondary.current, k.N_s);
    k.distance = frame.normal * (k.x_s - primary.x);
    k.overlap  = k.distance + secondary.surface_offset + primary.surface_offset;
    k.level    = (state.share > 0.) ? dot<dim>(k.N_s, state.level) : 0.;
    // the interpolation of what is nowhere negative may be
    k.augmentation = std::max(0., dot<dim>(k.N_s, state.augmentation));
    k.d            = k.overlap - offset(k.level, state.share);

    k.l_s = dot<dim>(k.N_s, secondary.length);
    k.c_s = dot<dim>(k.N_s, secondary.compliance);
    for (unsigned int c = 0; c < dim - 1; ++c)
      k.dc_s[c] = dot<dim>(k.dN_s[c], secondary.compliance);
    k.stiffness = combine(k.c_s, k.l_s, primary.compliance, primary.length);

    if constexpr (dim == 2)
      k.m = cross_product_2d(primary.tangents[0]);
    else
      k.m = cross_product_3d(primary.tangents[0], primary.tangents[1]);
    k.m_norm = k.m.norm();
    k.cosine = -(frame.normal * k.m) / k.m_norm;

    const double acting = k.d + k.augmentation;
    if (!(k.cosine > options.zero_cosine) || !(acting > 0.) ||
        k.d > options.ceiling * k.stiffness.length)
      return k;
    k.facing_s = std::min(1.,
                          (k.cosine - options.zero_cosine) /
                            (options.full_cosine - options.zero_cosine));
    k.facing   = k.facing_s * k.facing_s * (3. - 2. * k.facing_s);
    k.r        = law->evaluate(acting, k.stiffness.modulus, k.stiffness.length);
    k.sigma    = k.r.pressure * k.facing;
    return k;
  }


  template <int dim>
  PointState<dim>
  PointKernel<dim>::state_at(const SecondaryFrame<dim> &frame,
                             const ContactFacet<dim>   &secondary,
                             const SecondaryState<dim> &state,
                             const PrimaryPoint<dim>   &primary,
                             const PlanePoint<dim>     &xi) const
  {
    const Kinematics k = kinematics(frame, secondary, state, primary, xi);
    PointState<dim>  result;
    result.penetration = k.d;
    result.pressure    = k.sigma;
    result.length      = k.stiffness.length;
    if (friction != nullptr && state.slip != nullptr && k.sigma > 0.)
      {
        const Response r    = friction_response(state, primary, k);
        result.elastic_slip = r.elastic;
        result.slip         = r.sliding;
        result.sticks       = r.sticks;
      }
    return result;
  }


  template <int dim>
  MORTAR_CONTACT_VECTOR_CLONES void
  PointKernel<dim>::add_point(const SecondaryFrame<dim> &frame,
                              const ContactFacet<dim>   &secondary,
                              const SecondaryState<dim> &state,
                              const PrimaryPoint<dim>   &primary,
                              const ContactPoint<dim>   &point,
                              const bool                 with_tangent,
                              CurvatureSums<dim>        &sums,
                              PairBlock<dim>            &block) const
  {
    const unsigned int     n_s = secondary.current.n_vertices;
    const unsigned int     n_p = primary.n_vertices;
    constexpr unsigned int P   = max_facet_components<dim>;
    constexpr unsigned int T   = dim - 1;
    const Tensor<1, dim>  &n   = frame.normal;
    const auto            &t_p = primary.tangents;

    // Step 1: the two points and the penetration.
    Kinematics k = kinematics(frame, secondary, state, primary, point.xi);
    if (!(k.cosine > options.zero_cosine))
      return;
    const double            d         = k.d;
    const double            distance  = k.distance;
    const ContactStiffness &stiffness = k.stiffness;
    const double            W         = point.weight;

    block.area += W;
    ++block.n_points;
    if (d > options.ceiling * stiffness.length)
      {
        ++block.n_beyond;
        return;
      }
    block.smallest_gap = std::min(block.smallest_gap, -d);
    block.largest_gap  = std::max(block.largest_gap, -d);
    block.overlap      = std::max(block.overlap, k.overlap);
    if (!(d + k.augmentation > 0.))
      return;

    const NormalResponse &r       = k.r;
    const double          sigma   = k.sigma;
    const double          W_sigma = W * sigma;

    ++block.n_active;
    block.active_area += W;
    block.penetration_volume += W * std::max(d, 0.);
    block.energy += W * r.energy;
    block.pressure = std::max(block.pressure, sigma);
    if (d > block.penetration)
      {
        block.penetration      = d;
        block.deepest_position = k.x_s;
      }
    block.relative_penetration =
      std::max(block.relative_penetration, d / stiffness.length);

    // Step 2: first variation. With the dual basis of (t_p, n),
    //   delta d = a . v,  delta eta_b = a_b . v,
    //   v = delta x_s - delta x_p - distance delta n.
    const Tensor<1, dim>          a = k.m / (k.m * n);
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
    const PairVector<dim> g = work_of(a, frame, k.N_s, primary, distance);

    add(W_sigma, g, block.residual);
    const bool with_friction =
      friction != nullptr && state.slip != nullptr && sigma > 0.;
    if (!with_tangent)
      {
        if (with_friction)
          add_friction(frame, state, primary, point, k, false, sums, block);
        return;
      }

    // Step 3: how eta and the distance move: with the vertices at fixed xi,
    // then also with xi.
    for (unsigned int b = 0; b < T; ++b)
      k.deta[b] = work_of(a_eta[b], frame, k.N_s, primary, distance);
    k.ddistance = g;
    k.ddepth    = g;
    if (point.moves)
      for (unsigned int c = 0; c < T; ++c)
        {
          const Tensor<1, dim> t_s = interpolate(secondary.current, k.dN_s[c]);
          double               by_xi = a * t_s;
          add(by_xi, point.dxi[c], k.ddistance);
          if (k.level > 0.)
            by_xi -= state.share * dot<dim>(k.dN_s[c], state.level);
          if (k.augmentation > 0.)
            by_xi += dot<dim>(k.dN_s[c], state.augmentation);
          add(by_xi, point.dxi[c], k.ddepth);
          for (unsigned int b = 0; b < T; ++b)
            add(a_eta[b] * t_s, point.dxi[c], k.deta[b]);
        }

    // Step 4: the change of the pressure.
    k.dsigma = scaled(k.facing * r.stiffness, k.ddepth);

    // p = K phi(d/l): dp/dK = p/K, dp/dl = -(d/l) dp/dd
    const bool   series = options.stiffness_side == StiffnessSide::series;
    const double dp_dl = -(d + k.augmentation) / stiffness.length * r.stiffness;
    const double dp_dK = r.pressure / stiffness.modulus;
    // with c = c_s + c_p: l = (c_s l_s + c_p l_p)/c and K = l/c
    const auto dp = [&](const double dc, const double dcl) {
      const double c =
        (series || k.c_s == 0.) ? k.c_s + primary.compliance : k.c_s;
      const double dl = (dcl - stiffness.length * dc) / c;
      return dp_dl * dl + dp_dK * (dl - stiffness.modulus * dc) / c;
    };
    for (unsigned int c = 0; c < T; ++c)
      {
        if (point.moves)
          {
            const double dc = k.dc_s[c];
            const double dl = dot<dim>(k.dN_s[c], secondary.length);
            add(k.facing * dp(dc, dc * k.l_s + k.c_s * dl),
                point.dxi[c],
                k.dsigma);
          }
        if (series || k.c_s == 0.)
          add(k.facing * dp(primary.dcompliance[c],
                            primary.dcompliance[c] * primary.length +
                              primary.compliance * primary.dlength[c]),
              k.deta[c],
              k.dsigma);
      }

    // Facing angle: cosine = -n . m / |m|.
    if (k.facing_s < 1.)
      {
        const double s = k.facing_s;
        const double dfacing =
          6. * s * (1. - s) / (options.full_cosine - options.zero_cosine);
        const Tensor<1, dim> n_p_unit = k.m / k.m_norm;
        const Tensor<1, dim> across =
          -(n + k.cosine * n_p_unit) / k.m_norm; // d(cosine)/dm
        PairVector<dim> dcosine = {};
        for (unsigned int v = 0; v < n_s; ++v)
          {
            const Tensor<1, dim> tilt = n_p_unit * frame.dn[v];
            for (unsigned int i = 0; i < dim; ++i)
              dcosine[v * dim + i] -= tilt[i];
          }
        // along the motion of the tangents
        std::array<Tensor<1, dim>, T> by_t;
        if constexpr (dim == 2)
          by_t[0] = -cross_product_2d(across);
        else
          {
            by_t[0] = cross_product_3d(t_p[1], across);
            by_t[1] = cross_product_3d(across, t_p[0]);
          }
        for (unsigned int b = 0; b < T; ++b)
          {
            for (unsigned int v = 0; v < n_p; ++v)
              for (unsigned int i = 0; i < dim; ++i)
                dcosine[P + v * dim + i] += primary.dN[b][v] * by_t[b][i];
            for (unsigned int c = 0; c < T; ++c)
              add(by_t[b] * primary.second[b][c], k.deta[c], dcosine);
          }
        add(r.pressure * dfacing, dcosine, k.dsigma);
      }

    // Step 5: the tangent of the normal part. With g = work of a(eta),
    //   d2d = -[ a_dt_b deta_b + deta_b (a_dt_b + a . x_p,bc deta_c)
    //            + g a_dn + a_dn g + distance a . d2n ] + a . dN_s dxi.
    // g and deta_b are work of a and of a_eta_b: what they are multiplied by is
    // gathered in the motion of a force at the point, W_j, and dealt to the
    // vertices once.
    PairVector<dim>                  right_of_g = scaled(W, k.dsigma);
    std::array<PairVector<dim>, dim> motion; // of the force
    if (W_sigma != 0.)
      {
        for (unsigned int v = 0; v < n_s; ++v)
          {
            const Tensor<1, dim> a_dn_v = a * frame.dn[v];
            for (unsigned int i = 0; i < dim; ++i)
              right_of_g[v * dim + i] -= W_sigma * a_dn_v[i];
          }
        if (point.moves)
          add(sigma, point.dweight, right_of_g);
      }
    for (unsigned int j = 0; j < dim; ++j)
      motion[j] = scaled(a[j], right_of_g);
    const Tensor<1, dim> force = W_sigma * a;
    if (W_sigma != 0.)
      {
        for (unsigned int b = 0; b < T; ++b)
          {
            PairVector<dim> right_of_deta = {};
            for (unsigned int v = 0; v < n_p; ++v)
              for (unsigned int i = 0; i < dim; ++i)
                right_of_deta[P + v * dim + i] = -primary.dN[b][v] * force[i];
            for (unsigned int c = 0; c < T; ++c)
              {
                const double by_eta = force * primary.second[b][c];
                if (by_eta != 0.)
                  add(-by_eta, k.deta[c], right_of_deta);
              }
            for (unsigned int j = 0; j < dim; ++j)
              add(a_eta[b][j], right_of_deta, motion[j]);
          }
        sums.across += distance * force;
        sums.along += W_sigma * distance;
      }
    // the force goes with xi on the secondary, with eta on the primary
    for (unsigned int v = 0; v < n_s; ++v)
      {
        PairVector<dim> along = {};
        if (point.moves)
          for (unsigned int c = 0; c < T; ++c)
            add(k.dN_s[c][v], point.dxi[c], along);
        for (unsigned int i = 0; i < dim; ++i)
          add(k.N_s[v], motion[i], force[i], along, block.tangent[v * dim + i]);
      }
    for (unsigned int v = 0; v < n_p; ++v)
      {
        PairVector<dim> along = {};
        for (unsigned int b = 0; b < T; ++b)
          add(primary.dN[b][v], k.deta[b], along);
        for (unsigned int i = 0; i < dim; ++i)
          add(-primary.N[v],
              motion[i],
              -force[i],
              along,
              block.tangent[P + v * dim + i]);
      }
    for (unsigned int j = 0; j < dim; ++j)
      add(distance, motion[j], force[j], k.ddistance, sums.couple[j]);

    if (with_friction)
      add_friction(frame, state, primary, point, k, true, sums, block);
  }


  template <int dim>
  void
  PointKernel<dim>::add_curvature(const SecondaryFrame<dim> &frame,
                                  const CurvatureSums<dim>  &sums,
                                  PairBlock<dim>            &block) const
  {
    // -distance (sigma a + tau) . d2n, with a . n = 1, tau . n = 0; and the
    // couple of the force on the secondary, along dn
    const auto curvature = frame.normal_curvature(sums.across, sums.along);
    for (unsigned int i = 0; i < max_facet_components<dim>; ++i)
      for (unsigned int j = 0; j < max_facet_components<dim>; ++j)
        block.tangent[i][j] -= curvature[i][j];
    for (unsigned int v = 0; v < frame.facet.n_vertices; ++v)
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int j = 0; j < dim; ++j)
          add(-frame.dn[v][j][i], sums.couple[j], block.tangent[v * dim + i]);
  }


  template class PointKernel<2>;
  template class PointKernel<3>;
} // namespace MortarContact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "point_kinematics.h"
#include "vector_clones.h"

#include <mortar_contact/laws/initial_penetration.h>

#include <cmath>

namespace MortarContact
{
  using namespace PairAlgebra;

  template <int dim>
  typename PointKernel<dim>::Response
  PointKernel<dim>::friction_response(const SecondaryState<dim> &state,
                                      const PrimaryPoint<dim>   &primary,
                                      const Kinematics          &k) const
  {
    constexpr unsigned int T    = dim - 1;
    const FacetSlip<dim>  &slip = *state.slip;
    Response               f;

    // Step 1: slip. A point that was open slips for the part of the step only
    // in which it is in contact.
    f.x_s_before           = interpolate(slip.before, k.N_s);
    const Tensor<1, dim> r = primary.before - f.x_s_before;
    const double         level_before =
      (slip.share > 0.) ? dot<dim>(k.N_s, state.level) : 0.;
    f.d_before = -(slip.normal * r) + (k.overlap - k.distance) -
                 offset(level_before, slip.share) + k.augmentation;
    const double acting = k.d + k.augmentation;
    f.share = (f.d_before < 0.) ? acting / (acting - f.d_before) : 1.;
    for (unsigned int c = 0; c < T; ++c)
      {
        f.increment[c] = slip.basis[c] * r;
        f.trial[c]     = f.share * f.increment[c];
      }
    f.rate = (slip.time_step > 0.) ? f.trial.norm() / slip.time_step : 0.;
    for (unsigned int a = 0; a < slip.before.n_vertices; ++a)
      f.trial += k.N_s[a] * slip.elastic[a];
    f.trial_size = f.trial.norm();

    // Step 2: return map.
    f.mu    = friction->evaluate(k.sigma, f.rate);
    f.limit = f.mu.coefficient * k.sigma;
    f.c     = (options.stiffness_side == StiffnessSide::series || k.c_s == 0.) ?
                k.c_s + primary.compliance :
                k.c_s;
    f.modulus = (options.elastic_slip > 0.) ? f.limit / options.elastic_slip :
                                              options.tangential_scale / f.c;
    f.sticks  = f.modulus * f.trial_size <= f.limit;
    if (f.sticks)
      {
        f.traction = f.modulus * f.trial;
        f.elastic  = f.trial;
        f.sliding  = 0.;
      }
    else
      {
        f.traction = f.limit / f.trial_size * f.trial;
        f.elastic  = f.traction / f.modulus;
        f.sliding  = f.trial_size - f.elastic.norm();
      }
    return f;
  }


  template <int dim>
  MORTAR_CONTACT_VECTOR_CLONES void
  PointKernel<dim>::add_friction(const SecondaryFrame<dim> &frame,
                                 const SecondaryState<dim> &state,
                                 const PrimaryPoint<dim>   &primary,
                                 const ContactPoint<dim>   &point,
                                 const Kinematics          &k,
                                 const bool                 with_tangent,
                                 CurvatureSums<dim>        &sums,
                                 PairBlock<dim>            &block) const
  {
    constexpr unsigned int T    = dim - 1;
    constexpr unsigned int P    = max_facet_components<dim>;
    const FacetSlip<dim>  &slip = *state.slip;
    const double           W    = point.weight;
    const Response         f    = friction_response(state, primary, k);

    // Step 1: forces.
    Tensor<1, dim> tau;
    for (unsigned int c = 0; c < T; ++c)
      tau += f.traction[c] * frame.basis[c];
    add(W, work_of(tau, frame, k.N_s, primary, k.distance), block.residual);
    block.energy += W * 0.5 * (f.traction * f.elastic);
    block.elastic_slip = std::max(block.elastic_slip, f.elastic.norm());
    block.dissipation += W * f.limit * f.sliding;
    if (!f.sticks)
      block.slip_area += W;
    if (!with_tangent)
      return;

    // Step 2: how the trial slip changes.
    std::array<PairVector<dim>, T> dtrial = {}, dslip = {};
    std::array<Tensor<1, dim>, T>  t_s_before;
    for (unsigned int c = 0; c < T; ++c)
      t_s_before[c] = interpolate(slip.before, k.dN_s[c]);
    for (unsigned int c = 0; c < T; ++c)
      {
        for (unsigned int b = 0; b < T; ++b)
          add(slip.basis[c] * primary.before_tangents[b], k.deta[b], dslip[c]);
        if (point.moves)
          for (unsigned int b = 0; b < T; ++b)
            add(-(slip.basis[c] * t_s_before[b]), point.dxi[b], dslip[c]);
      }
    if (f.d_before < 0.)
      {
        // share = d / (d - d_before)
        PairVector<dim> dbefore = {};
        for (unsigned int b = 0; b < T; ++b)
          {
            add(-(slip.normal * primary.before_tangents[b]),
                k.deta[b],
                dbefore);
            if (point.moves)
              {
                double by_xi = slip.normal * t_s_before[b];
                if (k.augmentation > 0.)
                  by_xi += dot<dim>(k.dN_s[b], state.augmentation);
                if (slip.share > 0. && dot<dim>(k.N_s, state.level) > 0.)
                  by_xi -= slip.share * dot<dim>(k.dN_s[b], state.level);
                add(by_xi, point.dxi[b], dbefore);
              }
          }
        const double    acting = k.d + k.augmentation;
        const double    total  = acting - f.d_before;
        PairVector<dim> dshare = {};
        add(-f.d_before / (total * total), k.ddepth, dshare);
        add(acting / (total * total), dbefore, dshare);
        for (unsigned int c = 0; c < T; ++c)
          {
            for (double &entry : dslip[c])
              entry *= f.share;
            add(f.increment[c], dshare, dslip[c]);
          }
      }
    dtrial = dslip;
    if (point.moves)
      for (unsigned int b = 0; b < T; ++b)
        for (unsigned int a = 0; a < slip.before.n_vertices; ++a)
          for (unsigned int c = 0; c < T; ++c)
            add(k.dN_s[b][a] * slip.elastic[a][c], point.dxi[b], dtrial[c]);

    // Step 3: how the limit changes, and the stiffness.
    PairVector<dim> dlimit = {};
    add(f.mu.coefficient + k.sigma * f.mu.by_pressure, k.dsigma, dlimit);
    if (f.mu.by_rate != 0. && f.rate > 0.)
      {
        const double size = f.rate * slip.time_step;
        for (unsigned int c = 0; c < T; ++c)
          add(k.sigma * f.mu.by_rate / slip.time_step *
                (f.share * f.increment[c] / size),
              dslip[c],
              dlimit);
      }

    std::array<PairVector<dim>, T> dtau = {};
    if (f.sticks)
      {
        PairVector<dim> dmodulus = {};
        if (options.elastic_slip > 0.)
          add(1. / options.elastic_slip, dlimit, dmodulus);
        else
          {
            const double factor = -f.modulus / f.c;
            for (unsigned int b = 0; b < T; ++b)
              {
                const bool series =
                  options.stiffness_side == StiffnessSide::series ||
                  k.c_s == 0.;
                if (series)
                  add(factor * primary.dcompliance[b], k.deta[b], dmodulus);
                if (point.moves)
                  add(factor * k.dc_s[b], point.dxi[b], dmodulus);
              }
          }
        for (unsigned int c = 0; c < T; ++c)
          {
            add(f.modulus, dtrial[c], dtau[c]);
            add(f.trial[c], dmodulus, dtau[c]);
          }
      }
    else
      {
        const PlanePoint<dim> m = f.trial / f.trial_size;
        for (unsigned int c = 0; c < T; ++c)
          {
            add(m[c], dlimit, dtau[c]);
            for (unsigned int b = 0; b < T; ++b)
              add(f.limit / f.trial_size * ((b == c ? 1. : 0.) - m[b] * m[c]),
                  dtrial[b],
                  dtau[c]);
          }
      }

    // Step 4: the tangent,
    //   W e_c-work (x) dtau_c + tau-work (x) dW + W d(tau-work) at fixed tau_c.
    for (unsigned int c = 0; c < T; ++c)
      {
        PairVector<dim> right = {};
        add(W, dtau[c], right);
        if (point.moves)
          add(f.traction[c], point.dweight, right);
        add_outer(work_of(frame.basis[c], frame, k.N_s, primary, k.distance),
                  right,
                  block.tangent);
      }
    const auto by_secondary = [](const FacetVector<dim> &v) {
      PairVector<dim> row = {};
      std::copy(v.begin(), v.end(), row.begin());
      return row;
    };
    // the basis: turns about n, tilts with it
    FacetVector<dim> tau_dn = {};
    for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
      {
        const Tensor<1, dim> v = tau * frame.dn[a];
        for (unsigned int i = 0; i < dim; ++i)
          tau_dn[a * dim + i] = v[i];
      }
    PairVector<dim> right_of_n = {};
    add(-W, by_secondary(tau_dn), right_of_n);
    add_outer(work_of(frame.normal, frame, k.N_s, primary, k.distance),
              right_of_n,
              block.tangent);
    if constexpr (dim == 3)
      {
        PairVector<dim> right = {};
        add(W, by_secondary(frame.spin()), right);
        add_outer(work_of<dim>(cross_product_3d(frame.normal, tau),
                               frame,
                               k.N_s,
                               primary,
                               k.distance),
                  right,
                  block.tangent);
      }
    // the points that the work is taken at
    PairVector<dim> right_of_tdn = {};
    add(-W, k.ddistance, right_of_tdn);
    add_outer(by_secondary(tau_dn), right_of_tdn, block.tangent);
    for (unsigned int b = 0; b < T; ++b)
      {
        PairVector<dim> row_s = {}, row_p = {};
        for (unsigned int i = 0; i < dim; ++i)
          {
            for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
              row_s[a * dim + i] = W * k.dN_s[b][a] * tau[i];
            for (unsigned int a = 0; a < primary.n_vertices; ++a)
              row_p[P + a * dim + i] = -W * primary.dN[b][a] * tau[i];
          }
        if (point.moves)
          add_outer(row_s, point.dxi[b], block.tangent);
        add_outer(row_p, k.deta[b], block.tangent);
      }
    sums.across += W * k.distance * tau;
  }


  // The class is instantiated in point_kernel.cc; these members here.
  template PointKernel<2>::Response
  PointKernel<2>::friction_response(const SecondaryState<2> &,
                                    const PrimaryPoint<2> &,
                                    const Kinematics &) const;
  template PointKernel<3>::Response
  PointKernel<3>::friction_response(const SecondaryState<3> &,
                                    const PrimaryPoint<3> &,
                                    const Kinematics &) const;
  template void
  PointKernel<2>::add_friction(const SecondaryFrame<2> &,
                               const SecondaryState<2> &,
                               const PrimaryPoint<2> &,
                               const ContactPoint<2> &,
                               const Kinematics &,
                               const bool,
                               CurvatureSums<2> &,
                               PairBlock<2> &) const;
  template void
  PointKernel<3>::add_friction(const SecondaryFrame<3> &,
                               const SecondaryState<3> &,
                               const PrimaryPoint<3> &,
                               const ContactPoint<3> &,
                               const Kinematics &,
                               const bool,
                               CurvatureSums<3> &,
                               PairBlock<3> &) const;
} // namespace MortarContact

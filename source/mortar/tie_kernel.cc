// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/tie_kernel.h>

namespace MortarContact
{
  using namespace PairAlgebra;

  namespace
  {
    template <int dim>
    Tensor<1, dim>
    components_in(const SecondaryFrame<dim> &frame, const Tensor<1, dim> &r)
    {
      Tensor<1, dim> c;
      for (unsigned int a = 0; a < dim - 1; ++a)
        c[a] = frame.basis[a] * r;
      c[dim - 1] = frame.normal * r;
      return c;
    }

    template <int dim>
    PairVector<dim>
    by_secondary(const FacetVector<dim> &v)
    {
      PairVector<dim> row = {};
      std::copy(v.begin(), v.end(), row.begin());
      return row;
    }
  } // namespace


  template <int dim>
  Tensor<1, dim>
  apart(const SecondaryFrame<dim> &frame,
        const Facet<dim>          &primary,
        const PlanePoint<dim>     &xi,
        const PlanePoint<dim>     &eta)
  {
    return components_in(
      frame,
      Tensor<1, dim>(
        interpolate(frame.facet,
                    shape_values<dim>(frame.facet.n_vertices, xi)) -
        interpolate(primary, shape_values<dim>(primary.n_vertices, eta))));
  }


  template <int dim>
  TieResponse<dim>
  add_tie(const SecondaryFrame<dim> &frame,
          const Facet<dim>          &primary,
          const TiePoint<dim>       &tie,
          const TieLaw<dim>         &law,
          const bool                 with_tangent,
          PairBlock<dim>            &block)
  {
    constexpr unsigned int P   = max_facet_components<dim>;
    constexpr unsigned int T   = dim - 1;
    const unsigned int     n_s = frame.facet.n_vertices;
    const double           W   = tie.weight;
    const auto             N_s = shape_values<dim>(n_s, tie.xi);
    const auto             N_p = shape_values<dim>(primary.n_vertices, tie.eta);

    // Step 1: the law.
    const Tensor<1, dim> r =
      interpolate(frame.facet, N_s) - interpolate(primary, N_p);
    const Tensor<1, dim> c = components_in(frame, r);
    // the law's normal jump is an opening, c_n the opposite
    Tensor<1, dim> jump = c - tie.apart;
    jump[T] *= -1.;
    TieResponse<dim> response = law.evaluate(jump, tie.stiffness, tie.history);
    response.traction[T] *= -1.;
    for (unsigned int a = 0; a < T; ++a)
      {
        response.tangent[a][T] *= -1.;
        response.tangent[T][a] *= -1.;
      }

    block.energy += W * response.energy;
    block.area += W;
    block.active_area += W;
    ++block.n_points;
    ++block.n_active;

    // Step 2: dc_a. The basis turns by
    //   de_0 = w e_1 - a_0 n,  de_1 = -w e_0 - a_1 n,  dn = a_0 e_0 + a_1 e_1.
    const auto row_of = [&](const Tensor<1, dim> &v) {
      PairVector<dim> row = {};
      for (unsigned int a = 0; a < n_s; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          row[a * dim + i] = N_s[a] * v[i];
      for (unsigned int a = 0; a < primary.n_vertices; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          row[P + a * dim + i] = -N_p[a] * v[i];
      return row;
    };
    std::array<PairVector<dim>, T> tilt;
    for (unsigned int b = 0; b < T; ++b)
      {
        FacetVector<dim> v = {};
        for (unsigned int a = 0; a < n_s; ++a)
          {
            const Tensor<1, dim> e_dn = frame.basis[b] * frame.dn[a];
            for (unsigned int i = 0; i < dim; ++i)
              v[a * dim + i] = e_dn[i];
          }
        tilt[b] = by_secondary<dim>(v);
      }
    const PairVector<dim> spin = by_secondary<dim>(frame.spin());

    std::array<PairVector<dim>, dim> dc;
    for (unsigned int b = 0; b < T; ++b)
      {
        dc[b] = row_of(frame.basis[b]);
        add(-c[T], tilt[b], dc[b]);
      }
    dc[T] = row_of(frame.normal);
    for (unsigned int b = 0; b < T; ++b)
      add(c[b], tilt[b], dc[T]);
    if constexpr (dim == 3)
      {
        add(c[1], spin, dc[0]);
        add(-c[0], spin, dc[1]);
      }

    for (unsigned int a = 0; a < dim; ++a)
      add(W * response.traction[a], dc[a], block.residual);
    if (!with_tangent)
      return response;

    // Step 3: dc_a D_ab dc_b.
    for (unsigned int a = 0; a < dim; ++a)
      {
        PairVector<dim> right = {};
        for (unsigned int b = 0; b < dim; ++b)
          add(W * response.tangent[a][b], dc[b], right);
        add_outer(dc[a], right, block.tangent);
      }

    // Step 4: T_a d2c_a, first where the points and the basis move together.
    const Tensor<1, dim> t        = W * response.traction;
    const auto           add_both = [&](const PairVector<dim> &a,
                              const PairVector<dim> &b) {
      add_outer(a, b, block.tangent);
      add_outer(b, a, block.tangent);
    };
    for (unsigned int b = 0; b < T; ++b)
      add_both(row_of(t[T] * frame.basis[b] - t[b] * frame.normal), tilt[b]);

    // then where the basis turns twice
    Tensor<1, dim> on_normal = t[T] * r, on_tangent = t[0] * r;
    if constexpr (dim == 3)
      {
        add_both(row_of(t[0] * frame.basis[1] - t[1] * frame.basis[0]), spin);
        on_normal += t[1] * cross_product_3d(frame.basis[0], r);
        on_tangent += t[1] * cross_product_3d(r, frame.normal);
        // t_1 r . (dn x de_0), twice
        PairVector<dim> right = {};
        add(t[1] * c[2], spin, right);
        add(t[1] * c[1], tilt[0], right);
        add_both(tilt[0], right);
        right = {};
        add(-t[1] * c[0], tilt[0], right);
        add_both(tilt[1], right);
      }
    const auto curvature =
      frame.normal_curvature(on_normal, on_normal * frame.normal);
    // e_0 = a/|a|: q . d2e_0 [u, v] = -(1/|a|^2) [ (q . Pu)(e_0 . v)
    //   + (q . Pv)(e_0 . u) + (q . e_0)(Pu . Pv) ],  P = I - e_0 e_0
    const Tensor<1, dim> &e  = frame.basis[0];
    const double          qe = on_tangent * e;
    const Tensor<1, dim>  Pq = on_tangent - qe * e;
    const double          L2 = frame.tangent_length * frame.tangent_length;
    for (unsigned int a = 0; a < n_s; ++a)
      for (unsigned int b = 0; b < n_s; ++b)
        {
          const double factor = -frame.tangent_of[a] * frame.tangent_of[b] / L2;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              block.tangent[a * dim + i][b * dim + j] +=
                curvature[a * dim + i][b * dim + j] +
                factor * (Pq[i] * e[j] + e[i] * Pq[j] +
                          qe * ((i == j ? 1. : 0.) - e[i] * e[j]));
        }
    return response;
  }


  template Tensor<1, 2>
  apart(const SecondaryFrame<2> &,
        const Facet<2> &,
        const PlanePoint<2> &,
        const PlanePoint<2> &);
  template Tensor<1, 3>
  apart(const SecondaryFrame<3> &,
        const Facet<3> &,
        const PlanePoint<3> &,
        const PlanePoint<3> &);
  template TieResponse<2>
  add_tie(const SecondaryFrame<2> &,
          const Facet<2> &,
          const TiePoint<2> &,
          const TieLaw<2> &,
          const bool,
          PairBlock<2> &);
  template TieResponse<3>
  add_tie(const SecondaryFrame<3> &,
          const Facet<3> &,
          const TiePoint<3> &,
          const TieLaw<3> &,
          const bool,
          PairBlock<3> &);
} // namespace MortarContact

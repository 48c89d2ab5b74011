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
  TiedPair<dim>::TiedPair(const SecondaryFrame<dim> &frame,
                          const Facet<dim>          &primary,
                          const TieLaw<dim>         &law,
                          const bool                 with_tangent,
                          PairBlock<dim>            &block)
    : frame(frame)
    , primary(primary)
    , law(law)
    , with_tangent(with_tangent)
    , block(block)
    , spin(by_secondary<dim>(frame.spin()))
  {
    for (unsigned int b = 0; b < T; ++b)
      {
        FacetVector<dim> v = {};
        for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
          {
            const Tensor<1, dim> e_dn = frame.basis[b] * frame.dn[a];
            for (unsigned int i = 0; i < dim; ++i)
              v[a * dim + i] = e_dn[i];
          }
        tilt[b] = by_secondary<dim>(v);
      }
  }


  template <int dim>
  PairVector<dim>
  TiedPair<dim>::row_of(const VertexValues<dim> &N_s,
                        const VertexValues<dim> &N_p,
                        const Tensor<1, dim>    &v) const
  {
    constexpr unsigned int P   = max_facet_components<dim>;
    PairVector<dim>        row = {};
    for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        row[a * dim + i] = N_s[a] * v[i];
    for (unsigned int a = 0; a < primary.n_vertices; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        row[P + a * dim + i] = -N_p[a] * v[i];
    return row;
  }


  template <int dim>
  TieResponse<dim>
  TiedPair<dim>::add(const TiePoint<dim> &tie)
  {
    const double W   = tie.weight;
    const auto   N_s = shape_values<dim>(frame.facet.n_vertices, tie.xi);
    const auto   N_p = shape_values<dim>(primary.n_vertices, tie.eta);
    const auto   row = [&](const Tensor<1, dim> &v) {
      return row_of(N_s, N_p, v);
    };

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

    // Step 2: dc_a.
    std::array<PairVector<dim>, dim> dc;
    for (unsigned int b = 0; b < T; ++b)
      {
        dc[b] = row(frame.basis[b]);
        add_secondary(-c[T], tilt[b], dc[b]);
      }
    dc[T] = row(frame.normal);
    for (unsigned int b = 0; b < T; ++b)
      add_secondary(c[b], tilt[b], dc[T]);
    if constexpr (dim == 3)
      {
        add_secondary(c[1], spin, dc[0]);
        add_secondary(-c[0], spin, dc[1]);
      }

    for (unsigned int a = 0; a < dim; ++a)
      PairAlgebra::add(W * response.traction[a], dc[a], block.residual);
    if (!with_tangent)
      return response;

    // Step 3: dc_a D_ab dc_b.
    for (unsigned int a = 0; a < dim; ++a)
      {
        PairVector<dim> right = {};
        for (unsigned int b = 0; b < dim; ++b)
          if (response.tangent[a][b] != 0.)
            PairAlgebra::add(W * response.tangent[a][b], dc[b], right);
        add_outer(dc[a], right, block.tangent);
      }

    // Step 4: T_a d2c_a, first where the points and the basis move together,
    const Tensor<1, dim> t = W * response.traction;
    for (unsigned int b = 0; b < T; ++b)
      PairAlgebra::add(1.,
                       row(t[T] * frame.basis[b] - t[b] * frame.normal),
                       with_tilt[b]);

    // then where the basis turns twice
    on_normal += t[T] * r;
    on_tangent += t[0] * r;
    if constexpr (dim == 3)
      {
        PairAlgebra::add(1.,
                         row(t[0] * frame.basis[1] - t[1] * frame.basis[0]),
                         with_spin);
        on_normal += t[1] * cross_product_3d(frame.basis[0], r);
        on_tangent += t[1] * cross_product_3d(r, frame.normal);
        // t_1 r . (dn x de_0), twice
        add_secondary(t[1] * c[2], tilt[0], with_spin);
        add_secondary(t[1] * c[1], tilt[0], with_tilt[0]);
        add_secondary(-t[1] * c[0], tilt[0], with_tilt[1]);
      }
    return response;
  }


  template <int dim>
  void
  TiedPair<dim>::finish()
  {
    if (!with_tangent)
      return;
    const auto add_both = [&](const PairVector<dim> &a,
                              const PairVector<dim> &b) {
      add_outer(a, b, block.tangent);
      add_outer(b, a, block.tangent);
    };
    for (unsigned int b = 0; b < T; ++b)
      add_both(with_tilt[b], tilt[b]);
    if (dim == 3)
      add_both(with_spin, spin);

    const auto curvature =
      frame.normal_curvature(on_normal, on_normal * frame.normal);
    // e_0 = a/|a|: q . d2e_0 [u, v] = -(1/|a|^2) [ (q . Pu)(e_0 . v)
    //   + (q . Pv)(e_0 . u) + (q . e_0)(Pu . Pv) ],  P = I - e_0 e_0
    const Tensor<1, dim> &e   = frame.basis[0];
    const double          qe  = on_tangent * e;
    const Tensor<1, dim>  Pq  = on_tangent - qe * e;
    const double          L2  = frame.tangent_length * frame.tangent_length;
    const unsigned int    n_s = frame.facet.n_vertices;
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
  template class TiedPair<2>;
  template class TiedPair<3>;
} // namespace MortarContact

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "element.h"

#include "solid_body.h"

namespace Structure
{
  template <int dim>
  std::vector<unsigned int>
  components_of(const FiniteElement<dim> &fe)
  {
    std::vector<unsigned int> component(fe.n_dofs_per_cell());
    for (unsigned int a = 0; a < component.size(); ++a)
      component[a] = fe.system_to_component_index(a).first;
    return component;
  }


  template <int dim>
  Tensor<2, 3>
  deformation_gradient(const FEValuesBase<dim>         &fe_values,
                       const std::vector<unsigned int> &component,
                       const Vector<double>            &u,
                       const unsigned int               q)
  {
    Tensor<2, 3> F;
    for (unsigned int i = 0; i < 3; ++i)
      F[i][i] = 1.;
    for (unsigned int a = 0; a < component.size(); ++a)
      {
        const Tensor<1, dim> g = fe_values.shape_grad(a, q);
        for (unsigned int J = 0; J < dim; ++J)
          F[component[a]][J] += u(a) * g[J];
      }
    return F;
  }


  template <int dim>
  Element<dim>::Element(const SolidBody<dim> &body)
    : body(body)
    , fe_values(*body.mapping,
                body.elements[0],
                *body.quadrature,
                update_values | update_gradients | update_JxW_values)
    , component(components_of(body.elements[0]))
    , F(body.quadrature->size())
  {}


  template <int dim>
  bool
  Element<dim>::evaluate(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const Vector<double>                                 &u,
    const bool                                            with_tangent,
    Vector<double>                                       &forces,
    FullMatrix<double>                                   &tangent)
  {
    fe_values.reinit(cell);
    const unsigned int n        = component.size();
    const Material    &material = *body.material;
    forces                      = 0.;
    if (with_tangent)
      tangent = 0.;
    cell_state        = {};
    double volume     = 0.;
    double new_volume = 0.;

    for (unsigned int q = 0; q < F.size(); ++q)
      {
        F[q]           = deformation_gradient<dim>(fe_values, component, u, q);
        const double J = determinant(F[q]);
        // written so that NaN is refused
        if (!(J > 0.) && !material.is_linear)
          return false;
        volume += fe_values.JxW(q);
        new_volume += J * fe_values.JxW(q);
      }

    VolumetricResponse volumetric;
    Vector<double>     dv; // derivative of the cell's volume by its dofs
    if (body.mean_dilatation)
      {
        volumetric = material.volumetric(new_volume / volume);
        dv.reinit(n);
        cell_state.energy = volumetric.energy * volume;
      }

    for (unsigned int q = 0; q < F.size(); ++q)
      {
        const double   w = fe_values.JxW(q);
        StressResponse r;
        double         J = determinant(F[q]);
        if (body.mean_dilatation)
          {
            // stress J p F^-T with the cell's pressure p, and its derivative
            // at fixed p; that of p follows below
            r = material.isochoric(F[q]);
            cell_state.energy += r.energy * w;
            const Tensor<2, 3> H = transpose(invert(F[q]));
            const double       p = volumetric.pressure;
            r.P += J * p * H;
            if (with_tangent)
              for (unsigned int i = 0; i < 3; ++i)
                for (unsigned int K = 0; K < 3; ++K)
                  for (unsigned int k = 0; k < 3; ++k)
                    for (unsigned int L = 0; L < 3; ++L)
                      r.A[i][K][k][L] +=
                        J * p * (H[i][K] * H[k][L] - H[i][L] * H[k][K]);
            for (unsigned int a = 0; a < n; ++a)
              {
                const Tensor<1, dim> g = fe_values.shape_grad(a, q);
                for (unsigned int K = 0; K < dim; ++K)
                  dv(a) += J * H[component[a]][K] * g[K] * w;
              }
          }
        else
          {
            r = material.evaluate(F[q]);
            cell_state.energy += r.energy * w;
          }

        const Tensor<2, 3> tau =
          material.is_linear ? r.P : Tensor<2, 3>(r.P * transpose(F[q]) / J);
        cell_state.stress += w / volume * symmetrize(tau);

        for (unsigned int a = 0; a < n; ++a)
          {
            const Tensor<1, dim> g = fe_values.shape_grad(a, q);
            for (unsigned int K = 0; K < dim; ++K)
              forces(a) += r.P[component[a]][K] * g[K] * w;
          }
        if (!with_tangent)
          continue;

        // columns node by node: A grad N_b, then grad N_a . that
        for (unsigned int b = 0; b < n; ++b)
          {
            const Tensor<1, dim> g  = fe_values.shape_grad(b, q);
            const unsigned int   kb = component[b];
            double               B[dim][dim];
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int K = 0; K < dim; ++K)
                {
                  B[i][K] = 0.;
                  for (unsigned int L = 0; L < dim; ++L)
                    B[i][K] += r.A[i][K][kb][L] * g[L];
                  B[i][K] *= w;
                }
            for (unsigned int a = 0; a < n; ++a)
              {
                const Tensor<1, dim> h = fe_values.shape_grad(a, q);
                double               k = 0.;
                for (unsigned int K = 0; K < dim; ++K)
                  k += B[component[a]][K] * h[K];
                tangent(a, b) += k;
              }
          }
      }

    if (body.mean_dilatation && with_tangent)
      for (unsigned int a = 0; a < n; ++a)
        for (unsigned int b = 0; b < n; ++b)
          tangent(a, b) += volumetric.derivative / volume * dv(a) * dv(b);

    cell_state.volume_ratio = new_volume / volume;
    return true;
  }


  template <int dim>
  void
  Element<dim>::mass(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     FullMatrix<double>                                   &M)
  {
    fe_values.reinit(cell);
    M = 0.;
    for (const unsigned int q : fe_values.quadrature_point_indices())
      {
        const double w = body.material->density * fe_values.JxW(q);
        for (unsigned int a = 0; a < component.size(); ++a)
          for (unsigned int b = 0; b < component.size(); ++b)
            if (component[a] == component[b])
              M(a, b) +=
                w * fe_values.shape_value(a, q) * fe_values.shape_value(b, q);
      }
  }


  template class Element<2>;
  template class Element<3>;
  template std::vector<unsigned int>
  components_of(const FiniteElement<2> &);
  template std::vector<unsigned int>
  components_of(const FiniteElement<3> &);
  template Tensor<2, 3>
  deformation_gradient(const FEValuesBase<2> &,
                       const std::vector<unsigned int> &,
                       const Vector<double> &,
                       const unsigned int);
  template Tensor<2, 3>
  deformation_gradient(const FEValuesBase<3> &,
                       const std::vector<unsigned int> &,
                       const Vector<double> &,
                       const unsigned int);
} // namespace Structure

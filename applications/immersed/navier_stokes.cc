// SPDX-License-Identifier: LGPL-2.1-or-later
#include "navier_stokes.h"

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_dgp.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <array>

namespace Immersed
{
  namespace
  {
    const FEValuesExtractors::Vector velocity(0);
    const FEValuesExtractors::Scalar pressure(2);

    // exact for u.grad u
    constexpr unsigned int n_gauss = 3;

    /// Call function(velocity, pressure, normal, dx) at points of a boundary.
    template <class Function>
    void
    at_boundary(const FiniteElement<2>  &fe,
                const DoFHandler<2>     &dof_handler,
                const Mapping<2>        &mapping,
                const Vector<double>    &u,
                const types::boundary_id boundary,
                const Function          &function)
    {
      FEFaceValues<2>           face(mapping,
                           fe,
                           QGauss<1>(n_gauss),
                           update_values | update_normal_vectors |
                             update_JxW_values);
      std::vector<Tensor<1, 2>> v(face.n_quadrature_points);
      std::vector<double>       p(face.n_quadrature_points);
      for (const auto &cell : dof_handler.active_cell_iterators())
        for (const unsigned int side : cell->face_indices())
          if (cell->face(side)->at_boundary() &&
              cell->face(side)->boundary_id() == boundary)
            {
              face.reinit(cell, side);
              face[velocity].get_function_values(u, v);
              face[pressure].get_function_values(u, p);
              for (const unsigned int q : face.quadrature_point_indices())
                function(v[q], p[q], face.normal_vector(q), face.JxW(q));
            }
    }
  } // namespace


  NavierStokes::NavierStokes(const FluidParameters &parameters)
    : parameters(parameters)
    , fe(FE_Q<2>(2), 2, FE_DGP<2>(1), 1)
  {}


  void
  NavierStokes::assemble(const DoFHandler<2>             &dof_handler,
                         const Mapping<2>                &mapping,
                         const Vector<double>            &u,
                         const Vector<double>            &old,
                         const double                     time_step,
                         const Pressures                 &pressures,
                         const AffineConstraints<double> &constraints,
                         const types::global_dof_index    first,
                         SparseMatrix<double>            &matrix,
                         Vector<double>                  &rhs) const
  {
    const double rho = parameters.density, mu = parameters.viscosity;
    const double gamma    = parameters.grad_div;
    const double per_time = (time_step > 0.) ? rho / time_step : 0.;

    const FiniteElement<2> &fe_u = fe.base_element(0),
                           &fe_p = fe.base_element(1);
    FEValues<2>        of_u(mapping,
                     fe_u,
                     QGauss<2>(n_gauss),
                     update_values | update_gradients | update_JxW_values);
    FEValues<2>        of_p(mapping, fe_p, QGauss<2>(n_gauss), update_values);
    FEFaceValues<2>    face(mapping,
                         fe,
                         QGauss<1>(n_gauss),
                         update_values | update_normal_vectors |
                           update_JxW_values);
    const unsigned int n_u = fe_u.n_dofs_per_cell();
    const unsigned int n_p = fe_p.n_dofs_per_cell();
    const unsigned int n   = fe.n_dofs_per_cell();
    std::vector<std::array<unsigned int, 2>> place_u(n_u);
    std::vector<unsigned int>                place_p(n_p);
    for (unsigned int k = 0; k < n_u; ++k)
      place_u[k] = {{fe.component_to_system_index(0, k),
                     fe.component_to_system_index(1, k)}};
    for (unsigned int k = 0; k < n_p; ++k)
      place_p[k] = fe.component_to_system_index(2, k);

    FullMatrix<double>                   K(n, n);
    Vector<double>                       f(n);
    std::vector<types::global_dof_index> dofs(n);
    std::vector<Tensor<1, 2>> face_velocities(face.n_quadrature_points);
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        const typename Triangulation<2>::cell_iterator tria_cell = cell;
        of_u.reinit(tria_cell);
        of_p.reinit(tria_cell);
        cell->get_dof_indices(dofs);
        K = 0.;
        f = 0.;
        for (const unsigned int q : of_u.quadrature_point_indices())
          {
            const double dx = of_u.JxW(q);
            Tensor<1, 2> v, v_old;
            Tensor<2, 2> grad; // [c][d] = dv_c/dx_d
            double       p = 0.;
            for (unsigned int k = 0; k < n_u; ++k)
              for (unsigned int c = 0; c < 2; ++c)
                {
                  const auto dof = dofs[place_u[k][c]];
                  v[c] += of_u.shape_value(k, q) * u(dof);
                  v_old[c] += of_u.shape_value(k, q) * old(dof);
                  grad[c] += u(dof) * of_u.shape_grad(k, q);
                }
            for (unsigned int k = 0; k < n_p; ++k)
              p += of_p.shape_value(k, q) * u(dofs[place_p[k]]);
            const double       div = trace(grad);
            const Tensor<1, 2> inertia =
              per_time * (v - v_old) + rho * (grad * v);

            for (unsigned int k = 0; k < n_u; ++k)
              {
                const double       N = of_u.shape_value(k, q) * dx;
                const Tensor<1, 2> G = of_u.shape_grad(k, q) * dx;
                for (unsigned int c = 0; c < 2; ++c)
                  {
                    double stress = (gamma * div - p) * G[c];
                    for (unsigned int d = 0; d < 2; ++d)
                      stress += mu * (grad[c][d] + grad[d][c]) * G[d];
                    f(place_u[k][c]) -= inertia[c] * N + stress;
                  }
                for (unsigned int l = 0; l < n_u; ++l)
                  {
                    const double        M = of_u.shape_value(l, q);
                    const Tensor<1, 2> &H = of_u.shape_grad(l, q);
                    const double        both =
                      N * (per_time * M + rho * (v * H)) + mu * (G * H);
                    for (unsigned int c = 0; c < 2; ++c)
                      for (unsigned int d = 0; d < 2; ++d)
                        K(place_u[k][c], place_u[l][d]) +=
                          (c == d ? both : 0.) + rho * N * M * grad[c][d] +
                          mu * G[d] * H[c] + gamma * G[c] * H[d];
                  }
                for (unsigned int l = 0; l < n_p; ++l)
                  for (unsigned int c = 0; c < 2; ++c)
                    {
                      const double b = -of_p.shape_value(l, q) * G[c];
                      K(place_u[k][c], place_p[l]) += b;
                      K(place_p[l], place_u[k][c]) += b;
                    }
              }
            for (unsigned int k = 0; k < n_p; ++k)
              f(place_p[k]) += of_p.shape_value(k, q) * div * dx;
          }

        for (const unsigned int side : cell->face_indices())
          {
            const auto at = pressures.find(cell->face(side)->boundary_id());
            if (!cell->face(side)->at_boundary() || at == pressures.end())
              continue;
            face.reinit(cell, side);
            face[velocity].get_function_values(u, face_velocities);
            for (const unsigned int q : face.quadrature_point_indices())
              {
                // What comes in comes from rest: p_b is its pressure there.
                // Else it brings energy from nowhere (Y. Bazilevs et al.,
                // Comput. Methods Appl. Mech. Eng. 198 (2009) 3534).
                const Tensor<1, 2> &normal = face.normal_vector(q);
                const double inflow = std::min(0., face_velocities[q] * normal);
                for (unsigned int i = 0; i < n; ++i)
                  {
                    const unsigned int c =
                      fe.system_to_component_index(i).first;
                    if (c == 2)
                      continue;
                    const double N = face.shape_value(i, q) * face.JxW(q);
                    f(i) -= at->second * normal[c] * N -
                            0.5 * rho * inflow * face_velocities[q][c] * N;
                    for (unsigned int j = 0; j < n; ++j)
                      {
                        const unsigned int d =
                          fe.system_to_component_index(j).first;
                        if (d == 2 || inflow == 0.)
                          continue;
                        const double M = face.shape_value(j, q);
                        K(i, j) -= 0.5 * rho * N * M *
                                   ((c == d ? inflow : 0.) +
                                    normal[d] * face_velocities[q][c]);
                      }
                  }
              }
          }
        for (auto &dof : dofs)
          dof += first;
        constraints.distribute_local_to_global(K, f, dofs, matrix, rhs);
      }
  }


  double
  NavierStokes::flux(const DoFHandler<2>     &dof_handler,
                     const Mapping<2>        &mapping,
                     const Vector<double>    &u,
                     const types::boundary_id boundary) const
  {
    double result = 0.;
    at_boundary(fe,
                dof_handler,
                mapping,
                u,
                boundary,
                [&](const auto &v,
                    const double,
                    const auto  &n,
                    const double dx) { result += v * n * dx; });
    return result;
  }


  double
  NavierStokes::mean_pressure(const DoFHandler<2>     &dof_handler,
                              const Mapping<2>        &mapping,
                              const Vector<double>    &u,
                              const types::boundary_id boundary) const
  {
    double sum = 0., length = 0.;
    at_boundary(
      fe,
      dof_handler,
      mapping,
      u,
      boundary,
      [&](const auto &, const double p, const auto &, const double dx) {
        sum += p * dx;
        length += dx;
      });
    AssertThrow(length > 0., ExcMessage("No face has the boundary id."));
    return sum / length;
  }
} // namespace Immersed

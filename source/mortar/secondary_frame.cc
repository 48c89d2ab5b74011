// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/secondary_frame.h>

namespace MortarContact
{
  namespace
  {
    /// Matrix of the cross product: [v] u = v x u.
    Tensor<2, 3>
    cross_matrix(const Tensor<1, 3> &v)
    {
      Tensor<2, 3> m;
      m[0][1] = -v[2];
      m[0][2] = v[1];
      m[1][0] = v[2];
      m[1][2] = -v[0];
      m[2][0] = -v[1];
      m[2][1] = v[0];
      return m;
    }
  } // namespace


  template <int dim>
  SecondaryFrame<dim>::SecondaryFrame(const Facet<dim> &f)
    : facet(f)
    , centre(MortarContact::centre(f))
    , diameter(MortarContact::diameter(f))
  {
    const Tensor<1, dim> w = centre_normal(f);
    normal_length          = w.norm();
    normal                 = w / normal_length;

    // Step 1: dw/dx_a. w is a product of p and q, see centre_normal().
    if constexpr (dim == 2)
      {
        p_of = {{-1., 1.}};
        q_of = {{0., 0.}};
        for (unsigned int a = 0; a < 2; ++a)
          {
            dw[a][0][1] = p_of[a];
            dw[a][1][0] = -p_of[a];
          }
      }
    else
      {
        if (f.n_vertices == 3)
          {
            p_of = {{-1., 1., 0., 0.}};
            q_of = {{-1., 0., 1., 0.}};
          }
        else
          {
            p_of = {{-1., 0., 1., 0.}};
            q_of = {{0., -1., 0., 1.}};
          }
        const Tensor<2, dim> p_cross = cross_matrix(interpolate(f, p_of));
        const Tensor<2, dim> q_cross = cross_matrix(interpolate(f, q_of));
        for (unsigned int a = 0; a < f.n_vertices; ++a)
          dw[a] = q_of[a] * p_cross - p_of[a] * q_cross;
      }

    // Step 2: dn = (I - n n) dw / |w|.
    for (unsigned int a = 0; a < f.n_vertices; ++a)
      dn[a] = (dw[a] - outer_product(normal, normal * dw[a])) / normal_length;

    // Step 3: the basis, e_0 along the first tangent at the centre, which lies
    // across n.
    tangent_of     = shape_gradients<dim>(f.n_vertices,
                                      reference_centre<dim>(f.n_vertices))[0];
    basis[0]       = interpolate(f, tangent_of);
    tangent_length = basis[0].norm();
    basis[0] /= tangent_length;
    if constexpr (dim == 3)
      basis[1] = cross_product_3d(normal, basis[0]);

    for (unsigned int a = 0; a < f.n_vertices; ++a)
      {
        y[a]      = project(f.x[a]);
        height[a] = normal * (f.x[a] - centre);
      }
    for (unsigned int a = f.n_vertices; a < max_vertices<dim>; ++a)
      height[a] = 0.;
  }


  template <int dim>
  PlanePoint<dim>
  SecondaryFrame<dim>::project(const Tensor<1, dim> &x) const
  {
    const Tensor<1, dim> r = x - centre;
    PlanePoint<dim>      result;
    for (unsigned int c = 0; c < dim - 1; ++c)
      result[c] = basis[c] * r;
    return result;
  }


  template <int dim>
  std::array<FacetVector<dim>, dim - 1>
  SecondaryFrame<dim>::frame_motion(const double height) const
  {
    std::array<FacetVector<dim>, dim - 1> motion = {};
    for (unsigned int c = 0; c < dim - 1; ++c)
      for (unsigned int a = 0; a < facet.n_vertices; ++a)
        {
          const Tensor<1, dim> tilt = basis[c] * dn[a];
          for (unsigned int i = 0; i < dim; ++i)
            motion[c][a * dim + i] =
              -basis[c][i] / facet.n_vertices - height * tilt[i];
        }
    return motion;
  }


  template <int dim>
  FacetVector<dim>
  SecondaryFrame<dim>::spin() const
  {
    FacetVector<dim> result = {};
    if constexpr (dim == 3)
      for (unsigned int a = 0; a < facet.n_vertices; ++a)
        for (unsigned int i = 0; i < dim; ++i)
          result[a * dim + i] = tangent_of[a] / tangent_length * basis[1][i];
    return result;
  }


  template <int dim>
  std::array<FacetVector<dim>, max_facet_components<dim>>
  SecondaryFrame<dim>::normal_curvature(const Tensor<1, dim> &across,
                                        const double          along) const
  {
    // With P = I - n n, u = n . dw and z = (P b) . dw,
    //   b . d2n = (P b) . d2w / |w|
    //             - (z u + u z + (b . n) dw . P dw) / |w|^2 .
    const Tensor<1, dim> Pb = across - (across * normal) * normal;
    const unsigned int   n  = facet.n_vertices;

    std::array<Tensor<1, dim>, max_vertices<dim>> u, z;
    std::array<Tensor<2, dim>, max_vertices<dim>> P_dw;
    for (unsigned int a = 0; a < n; ++a)
      {
        u[a]    = normal * dw[a];
        z[a]    = Pb * dw[a];
        P_dw[a] = normal_length * dn[a];
      }
    Tensor<2, dim> b_cross;
    if constexpr (dim == 3)
      b_cross = cross_matrix(Pb / normal_length);

    std::array<FacetVector<dim>, max_facet_components<dim>> result = {};
    const double w2 = normal_length * normal_length;
    for (unsigned int a = 0; a < n; ++a)
      for (unsigned int b = 0; b < n; ++b)
        {
          Tensor<2, dim> block =
            (outer_product(z[a], u[b]) + outer_product(u[a], z[b]) +
             along * (transpose(dw[a]) * P_dw[b])) /
            -w2;
          if constexpr (dim == 3)
            block -= (p_of[a] * q_of[b] - q_of[a] * p_of[b]) * b_cross;
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              result[a * dim + i][b * dim + j] = block[i][j];
        }
    return result;
  }


  template struct SecondaryFrame<2>;
  template struct SecondaryFrame<3>;
} // namespace MortarContact

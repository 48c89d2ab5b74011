// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_point_kinematics_h
#define mortar_contact_mortar_point_kinematics_h

#include <mortar_contact/mortar/point_kernel.h>

namespace MortarContact
{
  /// What the normal part of a point knows, for the friction part.
  template <int dim>
  struct PointKernel<dim>::Kinematics
  {
    static constexpr unsigned int T = dim - 1;

    VertexValues<dim>                N_s;
    std::array<VertexValues<dim>, T> dN_s;
    Tensor<1, dim>                   x_s;
    Tensor<1, dim>                   m; ///< x_p,0 x x_p,1: along n_p.
    double                           m_norm   = 0.; ///< |m|
    double                           cosine   = 0.; ///< -n_s . n_p
    double                           distance = 0.; ///< n . (x_s - x_p)
    double                           overlap  = 0.; ///< distance + thicknesses
    double level = 0., d = 0.; ///< Initial level; effective depth.
    double augmentation = 0.;
    double c_s = 0., l_s = 0.;
    std::array<double, T> dc_s; ///< dc_s/dxi
    ContactStiffness      stiffness;
    double         facing_s = 1.; ///< Argument of the angle weight, [0, 1].
    double         facing   = 1.;
    NormalResponse r;
    double         sigma = 0.; ///< Pressure times angle weight.

    // total derivatives by the pair's vertices, with a tangent only
    std::array<PairVector<dim>, T> deta;      ///< Of eta.
    PairVector<dim>                ddistance; ///< Of the distance.
    PairVector<dim>                ddepth;    ///< Of the effective depth.
    PairVector<dim>                dsigma;
  };

  /// Friction at a point. Components of vectors are those in the secondary's
  /// basis.
  template <int dim>
  struct PointKernel<dim>::Response
  {
    using Plane = PlanePoint<dim>;

    Tensor<1, dim>   x_s_before; ///< Of the secondary point.
    double           c;          ///< Compliance l/K that acts [m/Pa]
    double           d_before;   ///< Depth at the end of the last step [m]
    double           share;      ///< Part of the step in contact.
    Plane            increment;  ///< Slip of the step [m]
    double           rate;       ///< |share increment| / duration [m/s]
    Plane            trial;      ///< Elastic slip if it sticks [m]
    double           trial_size; ///< |trial|
    FrictionResponse mu;
    double           limit;   ///< mu sigma [Pa]
    double           modulus; ///< Tangential stiffness E_T [Pa/m]
    bool             sticks;
    Plane            traction; ///< tau: what the secondary exerts [Pa]
    Plane            elastic;  ///< Elastic slip after the step [m]
    double           sliding;  ///< |trial| - |elastic| [m]
  };


  /// Virtual displacement that a vector @p v at the point works on:
  ///   v . (delta x_s - delta x_p - distance delta n).
  template <int dim>
  inline PairVector<dim>
  work_of(const Tensor<1, dim>      &v,
          const SecondaryFrame<dim> &frame,
          const VertexValues<dim>   &N_s,
          const PrimaryPoint<dim>   &primary,
          const double               distance)
  {
    constexpr unsigned int P   = max_facet_components<dim>;
    PairVector<dim>        row = {};
    for (unsigned int a = 0; a < frame.facet.n_vertices; ++a)
      {
        const Tensor<1, dim> v_dn = v * frame.dn[a];
        for (unsigned int i = 0; i < dim; ++i)
          row[a * dim + i] = N_s[a] * v[i] - distance * v_dn[i];
      }
    for (unsigned int a = 0; a < primary.n_vertices; ++a)
      for (unsigned int i = 0; i < dim; ++i)
        row[P + a * dim + i] = -primary.N[a] * v[i];
    return row;
  }
} // namespace MortarContact

#endif

// SPDX-License-Identifier: LGPL-2.1-or-later
#include "beam.h"

namespace Immersed
{
  namespace
  {
    constexpr double shear_correction    = 5. / 6.;
    constexpr double thickness_stiffness = 10.;

    Tensor<1, 2>
    combine(const std::array<double, BeamElement::n_nodes> &c,
            const BeamElement::Nodes                       &x)
    {
      Tensor<1, 2> result;
      for (unsigned int i = 0; i < x.size(); ++i)
        result += c[i] * x[i];
      return result;
    }
  } // namespace


  BeamElement::BeamElement(const BeamMaterial &material, const Nodes &reference)
    : length((reference[1] - reference[0]).norm())
    , material(material)
    , Q()
  {
    const double                      l        = 1. / length;
    const std::array<double, n_nodes> r_slope  = {{-l, l, 0., 0.}};
    const std::array<double, n_nodes> d_slope  = {{0., 0., -l, l}};
    const std::array<double, n_nodes> d_middle = {{0., 0., 0.5, 0.5}};
    const std::array<double, n_nodes> first    = {{0., 0., 1., 0.}};
    const std::array<double, n_nodes> second   = {{0., 0., 0., 1.}};
    forms                                      = {{{0.5, r_slope, r_slope},
                                                   {1., r_slope, d_slope},
                                                   {1., r_slope, d_middle},
                                                   {0.5, first, first},
                                                   {0.5, second, second}}};
    for (Form &f : forms)
      f.reference = combine(f.ca, reference) * combine(f.cb, reference);

    const double E = material.youngs_modulus, nu = material.poissons_ratio;
    const double t       = material.thickness;
    const double plane   = E / (1. - nu * nu);
    const double through = thickness_stiffness * E * t * length / 6.;
    Q[0][0]              = plane * t * length;
    Q[1][1]              = plane * t * t * t / 12. * length;
    Q[2][2]              = shear_correction * 0.5 * E / (1. + nu) * t * length;
    Q[3][3] = Q[4][4] = 2. * through;
    Q[3][4] = Q[4][3] = through;
  }


  std::array<double, BeamElement::n_forms>
  BeamElement::strains(const Nodes &current) const
  {
    std::array<double, n_forms> result;
    for (unsigned int k = 0; k < n_forms; ++k)
      result[k] = forms[k].c * (combine(forms[k].ca, current) *
                                  combine(forms[k].cb, current) -
                                forms[k].reference);
    return result;
  }


  double
  BeamElement::energy(const Nodes &current) const
  {
    const auto f      = strains(current);
    double     result = 0.;
    for (unsigned int k = 0; k < n_forms; ++k)
      for (unsigned int l = 0; l < n_forms; ++l)
        result += 0.5 * f[k] * Q[k][l] * f[l];
    return result;
  }


  void
  BeamElement::differentiate(const Nodes        &current,
                             const Nodes        &update,
                             Vector<double>     &forces,
                             FullMatrix<double> *tangent) const
  {
    const auto                  f = strains(current);
    std::array<Nodes, n_forms>  slope; // of the forms, by node
    std::array<double, n_forms> stress = {}, predicted = {};
    for (unsigned int k = 0; k < n_forms; ++k)
      {
        const Tensor<1, 2> a = combine(forms[k].ca, current);
        const Tensor<1, 2> b = combine(forms[k].cb, current);
        for (unsigned int i = 0; i < n_nodes; ++i)
          slope[k][i] = forms[k].c * (forms[k].ca[i] * b + forms[k].cb[i] * a);
        for (unsigned int l = 0; l < n_forms; ++l)
          {
            const double quadratic =
              forms[l].c *
              (combine(forms[l].ca, update) * combine(forms[l].cb, update));
            stress[k] += Q[k][l] * f[l];
            predicted[k] += Q[k][l] * (f[l] - quadratic);
          }
      }
    forces.reinit(2 * n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int c = 0; c < 2; ++c)
        for (unsigned int k = 0; k < n_forms; ++k)
          forces(2 * i + c) += stress[k] * slope[k][i][c];
    if (tangent == nullptr)
      return;
    tangent->reinit(2 * n_nodes, 2 * n_nodes);
    for (unsigned int i = 0; i < n_nodes; ++i)
      for (unsigned int j = 0; j < n_nodes; ++j)
        {
          double geometric = 0.;
          for (unsigned int k = 0; k < n_forms; ++k)
            geometric += predicted[k] * forms[k].c *
                         (forms[k].ca[i] * forms[k].cb[j] +
                          forms[k].cb[i] * forms[k].ca[j]);
          for (unsigned int c = 0; c < 2; ++c)
            {
              (*tangent)(2 * i + c, 2 * j + c) += geometric;
              for (unsigned int d = 0; d < 2; ++d)
                for (unsigned int k = 0; k < n_forms; ++k)
                  for (unsigned int l = 0; l < n_forms; ++l)
                    (*tangent)(2 * i + c, 2 * j + d) +=
                      slope[k][i][c] * Q[k][l] * slope[l][j][d];
            }
        }
  }


  double
  BeamElement::mass(const unsigned int i, const unsigned int j) const
  {
    if (i / 2 != j / 2)
      return 0.; // places and directors do not couple
    const double t          = material.thickness;
    const double per_length = material.density * (i < 2 ? t : t * t * t / 12.);
    return per_length * length * (i == j ? 1. / 3. : 1. / 6.);
  }
} // namespace Immersed

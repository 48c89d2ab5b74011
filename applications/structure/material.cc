// SPDX-License-Identifier: LGPL-2.1-or-later
#include "material.h"

#include <mortar_contact/laws/contact_modulus.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/patterns.h>

#include <cmath>

namespace Structure
{
  namespace
  {
    double
    delta(const unsigned int i, const unsigned int j)
    {
      return (i == j) ? 1. : 0.;
    }

    /// A_iJkL from a function of the four indices.
    template <class Function>
    Tensor<4, 3>
    fourth_order(const Function &f)
    {
      Tensor<4, 3> A;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int J = 0; J < 3; ++J)
          for (unsigned int k = 0; k < 3; ++k)
            for (unsigned int L = 0; L < 3; ++L)
              A[i][J][k][L] = f(i, J, k, L);
      return A;
    }


    /// Hooke's law in the small strain, sym(F - I).
    class LinearElastic : public Material
    {
    public:
      StressResponse
      evaluate(const Tensor<2, 3> &F) const override
      {
        const double lambda = bulk_modulus - 2. / 3. * shear_modulus;
        Tensor<2, 3> strain = 0.5 * (F + transpose(F));
        for (unsigned int i = 0; i < 3; ++i)
          strain[i][i] -= 1.;
        StressResponse r;
        r.P = 2. * shear_modulus * strain;
        for (unsigned int i = 0; i < 3; ++i)
          r.P[i][i] += lambda * trace(strain);
        r.energy = 0.5 * scalar_product(r.P, strain);
        r.A      = fourth_order([&](auto i, auto J, auto k, auto L) {
          return lambda * delta(i, J) * delta(k, L) +
                 shear_modulus *
                   (delta(i, k) * delta(J, L) + delta(i, L) * delta(J, k));
        });
        return r;
      }
    };


    /// W = lambda/2 tr(E)^2 + mu E:E with Green's strain E.
    class StVenantKirchhoff : public Material
    {
    public:
      StressResponse
      evaluate(const Tensor<2, 3> &F) const override
      {
        const double lambda = bulk_modulus - 2. / 3. * shear_modulus;
        const double mu     = shear_modulus;
        Tensor<2, 3> E      = 0.5 * (transpose(F) * F);
        for (unsigned int i = 0; i < 3; ++i)
          E[i][i] -= 0.5;
        Tensor<2, 3> S = 2. * mu * E;
        for (unsigned int i = 0; i < 3; ++i)
          S[i][i] += lambda * trace(E);
        const Tensor<2, 3> b = F * transpose(F);

        StressResponse r;
        r.energy = 0.5 * scalar_product(S, E);
        r.P      = F * S;
        r.A      = fourth_order([&](auto i, auto J, auto k, auto L) {
          return delta(i, k) * S[J][L] + lambda * F[i][J] * F[k][L] +
                 mu * (b[i][k] * delta(J, L) + F[i][L] * F[k][J]);
        });
        return r;
      }
    };


    /// W = mu/2 (I1 - 3 - 2 ln J) + lambda/2 (ln J)^2.
    class NeoHookean : public Material
    {
    public:
      StressResponse
      evaluate(const Tensor<2, 3> &F) const override
      {
        const double       lambda = bulk_modulus - 2. / 3. * shear_modulus;
        const double       mu     = shear_modulus;
        const double       log_J  = std::log(determinant(F));
        const Tensor<2, 3> H      = transpose(invert(F));

        StressResponse r;
        r.energy = 0.5 * mu * (F.norm_square() - 3. - 2. * log_J) +
                   0.5 * lambda * log_J * log_J;
        r.P = mu * (F - H) + lambda * log_J * H;
        r.A = fourth_order([&](auto i, auto J, auto k, auto L) {
          return mu * delta(i, k) * delta(J, L) + lambda * H[i][J] * H[k][L] +
                 (mu - lambda * log_J) * H[i][L] * H[k][J];
        });
        return r;
      }
    };


    /**
     * W = C10 (J^(-2/3) I1 - 3) + C01 (J^(-4/3) I2 - 3) + K/2 (J - 1)^2
     * (T. Sussman, K.-J. Bathe, doi:10.1016/0045-7949(87)90265-3).
     */
    class MooneyRivlin : public Material
    {
    public:
      MooneyRivlin(const double C10, const double C01)
        : C10(C10)
        , C01(C01)
      {}

      bool
      is_split() const override
      {
        return true;
      }

      StressResponse
      isochoric(const Tensor<2, 3> &F) const override
      {
        const double       J  = determinant(F);
        const Tensor<2, 3> H  = transpose(invert(F));
        const Tensor<2, 3> C  = transpose(F) * F;
        const Tensor<2, 3> b  = F * transpose(F);
        const double       I1 = trace(C);
        const double       I2 = 0.5 * (I1 * I1 - C.norm_square());

        StressResponse r;
        r.energy = -3. * (C10 + C01);
        // Term c J^a I with I' = dI/dF and I'' = d2I/dF2:
        //   P = c J^a (I' + a I H),
        //   A = c J^a (I'' + a (I' H + H I') + a^2 I H H - a I H_iL H_kJ).
        const auto add = [&](const double        c,
                             const double        a,
                             const double        I,
                             const Tensor<2, 3> &dI,
                             const auto         &d2I) {
          if (c == 0.)
            return;
          const double factor = c * std::pow(J, a);
          r.energy += factor * I;
          r.P += factor * (dI + a * I * H);
          r.A += fourth_order([&](auto i, auto K, auto k, auto L) {
            return factor *
                   (d2I(i, K, k, L) +
                    a * (dI[i][K] * H[k][L] + H[i][K] * dI[k][L]) +
                    a * a * I * H[i][K] * H[k][L] - a * I * H[i][L] * H[k][K]);
          });
        };
        add(C10, -2. / 3., I1, 2. * F, [&](auto i, auto K, auto k, auto L) {
          return 2. * delta(i, k) * delta(K, L);
        });
        add(C01,
            -4. / 3.,
            I2,
            2. * (I1 * F - F * C),
            [&](auto i, auto K, auto k, auto L) {
              return 4. * F[i][K] * F[k][L] +
                     2. * I1 * delta(i, k) * delta(K, L) -
                     2. * (delta(i, k) * C[K][L] + F[i][L] * F[k][K] +
                           b[i][k] * delta(K, L));
            });
        return r;
      }

      VolumetricResponse
      volumetric(const double J) const override
      {
        return {0.5 * bulk_modulus * (J - 1.) * (J - 1.),
                bulk_modulus * (J - 1.),
                bulk_modulus};
      }

      StressResponse
      evaluate(const Tensor<2, 3> &F) const override
      {
        const double             J = determinant(F);
        const Tensor<2, 3>       H = transpose(invert(F));
        const VolumetricResponse v = volumetric(J);
        StressResponse           r = isochoric(F);
        r.energy += v.energy;
        r.P += v.pressure * J * H;
        r.A += fourth_order([&](auto i, auto K, auto k, auto L) {
          return (v.derivative * J * J + v.pressure * J) * H[i][K] * H[k][L] -
                 v.pressure * J * H[i][L] * H[k][K];
        });
        return r;
      }

    private:
      const double C10, C01;
    };
  } // namespace


  StressResponse
  Material::isochoric(const Tensor<2, 3> &) const
  {
    AssertThrow(false, ExcInternalError());
    return {};
  }


  VolumetricResponse
  Material::volumetric(const double) const
  {
    AssertThrow(false, ExcInternalError());
    return {};
  }


  void
  MaterialParameters::declare(ParameterHandler &prm)
  {
    prm.declare_entry(
      "Law",
      "automatic",
      Patterns::Selection("automatic|linear elastic|St Venant-Kirchhoff|"
                          "neo-Hookean|Mooney-Rivlin"),
      "Hyperelastic law; linear elastic means small strains. Shells: St "
      "Venant-Kirchhoff or neo-Hookean, in plane stress. automatic: "
      "neo-Hookean for solids, St Venant-Kirchhoff for shells.");
    prm.declare_entry("Young's modulus",
                      "0.0",
                      Patterns::Double(0.),
                      "E [pressure]; all laws but Mooney-Rivlin with C10.");
    prm.declare_entry("Poisson's ratio",
                      "0.3",
                      Patterns::Double(-0.999, 0.499999),
                      "nu [-].");
    prm.declare_entry(
      "C10",
      "0.0",
      Patterns::Double(0.),
      "First constant of Mooney-Rivlin [pressure]; 0: E/(4 (1 + "
      "nu)), neo-Hookean rubber.");
    prm.declare_entry("C01",
                      "0.0",
                      Patterns::Double(0.),
                      "Second constant of Mooney-Rivlin [pressure].");
    const auto not_negative = [&](const char *entry, const char *help) {
      prm.declare_entry(entry, "0.0", Patterns::Double(0.), help);
    };
    not_negative("Yield stress",
                 "Of elastic-plastic shells (J2 flow, isotropic hardening) "
                 "[pressure]; 0: elastic.");
    not_negative("Hardening modulus",
                 "Growth of the flow stress with the equivalent plastic strain "
                 "[pressure].");
    not_negative("Saturation stress",
                 "That the flow stress tends to, without the modulus above "
                 "[pressure]; 0: none.");
    not_negative("Saturation exponent", "How fast it does [-].");
    prm.declare_entry("Density",
                      "0.0",
                      Patterns::Double(0.),
                      "Undeformed density [mass/volume]; for body forces.");
  }


  void
  MaterialParameters::read(ParameterHandler &prm)
  {
    hardening.yield_stress = prm.get_double("Yield stress");
    hardening.modulus      = prm.get_double("Hardening modulus");
    hardening.saturation   = prm.get_double("Saturation stress");
    hardening.exponent     = prm.get_double("Saturation exponent");
    AssertThrow(hardening.yield_stress > 0. ||
                  (hardening.modulus == 0. && hardening.saturation == 0.),
                ExcMessage("'Hardening modulus' or 'Saturation stress' is set "
                           "but 'Yield stress' is 0; expected a yield "
                           "stress."));
    AssertThrow((hardening.saturation == 0.) == (hardening.exponent == 0.) &&
                  (hardening.saturation == 0. ||
                   hardening.saturation >= hardening.yield_stress),
                ExcMessage("'Saturation stress' is " +
                           std::to_string(hardening.saturation) +
                           " and 'Saturation exponent' is " +
                           std::to_string(hardening.exponent) +
                           "; expected both or none, and a stress of at least "
                           "'Yield stress'."));
    law            = prm.get("Law");
    youngs_modulus = prm.get_double("Young's modulus");
    poissons_ratio = prm.get_double("Poisson's ratio");
    C10            = prm.get_double("C10");
    C01            = prm.get_double("C01");
    density        = prm.get_double("Density");
    AssertThrow(youngs_modulus > 0. || C10 > 0.,
                ExcMessage("'Young's modulus' is 0" +
                           std::string(
                             law == "Mooney-Rivlin" ? " and so is 'C10'" : "") +
                           "; expected a positive pressure."));
    AssertThrow(law == "Mooney-Rivlin" || (C10 == 0. && C01 == 0.),
                ExcMessage("'C10' or 'C01' is set but 'Law' is '" + law +
                           "'; they belong to Mooney-Rivlin. Remove one of "
                           "them."));
  }


  std::unique_ptr<Material>
  MaterialParameters::make() const
  {
    const double              nu = poissons_ratio;
    double                    mu = youngs_modulus / (2. * (1. + nu));
    std::unique_ptr<Material> material;
    if (law == "linear elastic")
      {
        material            = std::make_unique<LinearElastic>();
        material->is_linear = true;
      }
    else if (law == "St Venant-Kirchhoff")
      material = std::make_unique<StVenantKirchhoff>();
    else if (law == "neo-Hookean" || law == "automatic")
      {
        material                 = std::make_unique<NeoHookean>();
        material->is_neo_hookean = true;
      }
    else if (C10 > 0.)
      {
        mu                       = 2. * (C10 + C01);
        material                 = std::make_unique<MooneyRivlin>(C10, C01);
        material->is_neo_hookean = C01 == 0.;
      }
    else
      {
        material                 = std::make_unique<MooneyRivlin>(0.5 * mu, 0.);
        material->is_neo_hookean = true;
      }
    material->shear_modulus = mu;
    material->bulk_modulus  = 2. * mu * (1. + nu) / (3. * (1. - 2. * nu));
    material->density       = density;
    material->contact_modulus =
      MortarContact::bulk_contact_modulus(2. * mu * (1. + nu), nu);
    return material;
  }


  double
  youngs_modulus_of_rubber(const double shore_a)
  {
    return 0.0981 * (56. + 7.62336 * shore_a) /
           (0.137505 * (254. - 2.54 * shore_a));
  }
} // namespace Structure

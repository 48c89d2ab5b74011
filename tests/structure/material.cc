// SPDX-License-Identifier: LGPL-2.1-or-later
#include <structure/material.h>

#include <gtest/gtest.h>

using namespace dealii;
using namespace Structure;

namespace
{
  MaterialParameters
  parameters(const std::string &law)
  {
    MaterialParameters p;
    p.law            = law;
    p.youngs_modulus = 10.;
    p.poissons_ratio = 0.3;
    if (law == "Mooney-Rivlin")
      {
        p.C10 = 1.2;
        p.C01 = 0.7;
      }
    return p;
  }

  Tensor<2, 3>
  some_gradient()
  {
    Tensor<2, 3> F;
    const double f[3][3] = {{1.1, 0.2, -0.1},
                            {0.05, 0.9, 0.15},
                            {-0.2, 0.1, 1.2}};
    for (unsigned int i = 0; i < 3; ++i)
      for (unsigned int j = 0; j < 3; ++j)
        F[i][j] = f[i][j];
    return F;
  }
} // namespace

class MaterialLaws : public testing::TestWithParam<std::string>
{};

TEST_P(MaterialLaws, StressAndStiffnessAreDerivativesOfTheEnergy)
{
  const auto         material = parameters(GetParam()).make();
  const Tensor<2, 3> F        = some_gradient();
  const auto         r        = material->evaluate(F);
  const double       h        = 1e-6;
  for (unsigned int k = 0; k < 3; ++k)
    for (unsigned int L = 0; L < 3; ++L)
      {
        Tensor<2, 3> plus = F, minus = F;
        plus[k][L] += h;
        minus[k][L] -= h;
        const auto a = material->evaluate(plus), b = material->evaluate(minus);
        EXPECT_NEAR(r.P[k][L], (a.energy - b.energy) / (2. * h), 1e-7);
        for (unsigned int i = 0; i < 3; ++i)
          for (unsigned int J = 0; J < 3; ++J)
            EXPECT_NEAR(r.A[i][J][k][L],
                        (a.P[i][J] - b.P[i][J]) / (2. * h),
                        1e-6);
      }
}

TEST_P(MaterialLaws, StressTurnsWithTheBody)
{
  if (GetParam() == "linear elastic")
    GTEST_SKIP() << "small strains are not objective";
  const auto   material = parameters(GetParam()).make();
  Tensor<2, 3> Q;
  Q[0][1]              = -1.;
  Q[1][0]              = 1.;
  Q[2][2]              = 1.;
  const Tensor<2, 3> F = some_gradient();
  EXPECT_LT((material->evaluate(Q * F).P - Q * material->evaluate(F).P).norm(),
            1e-13);
}

TEST_P(MaterialLaws, SmallStrainsFollowHooke)
{
  const auto   material = parameters(GetParam()).make();
  Tensor<2, 3> F;
  for (unsigned int i = 0; i < 3; ++i)
    F[i][i] = 1.;
  const auto r = material->evaluate(F);
  EXPECT_LT(r.P.norm(), 1e-14);
  const double lambda =
    material->bulk_modulus - 2. / 3. * material->shear_modulus;
  EXPECT_NEAR(r.A[0][0][0][0], lambda + 2. * material->shear_modulus, 1e-12);
  EXPECT_NEAR(r.A[0][0][1][1], lambda, 1e-12);
  EXPECT_NEAR(r.A[0][1][0][1], material->shear_modulus, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(All,
                         MaterialLaws,
                         testing::Values("linear elastic",
                                         "St Venant-Kirchhoff",
                                         "neo-Hookean",
                                         "Mooney-Rivlin"),
                         [](const auto &info) {
                           std::string name = info.param;
                           for (char &c : name)
                             if (!std::isalpha(c))
                               c = '_';
                           return name;
                         });

TEST(Material, RubberOfShore60HasAboutFourMegapascal)
{
  // Gent (1958), 60 Shore A: 3.6 MPa
  EXPECT_NEAR(youngs_modulus_of_rubber(60.), 3.6, 0.1);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/contact_modulus.h>
#include <mortar_contact/laws/initial_penetration.h>
#include <mortar_contact/laws/law_library.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace MortarContact;

class EveryLaw
  : public testing::TestWithParam<std::tuple<std::string, double, bool>>
{
protected:
  std::unique_ptr<PressureLaw> law = make_pressure_law(std::get<0>(GetParam()),
                                                       0.1,
                                                       std::get<1>(GetParam()),
                                                       0.5,
                                                       std::get<2>(GetParam()));
};

TEST_P(EveryLaw, PressureAndStiffnessAreDerivativesOfTheEnergy)
{
  const double K = 1000., l = 0.1;
  for (const double d : {1e-4, 0.0029, 0.0059, 0.007, 0.02, 0.026, 0.049, 0.07})
    {
      const double h    = 1e-5 * d;
      const auto   r    = law->evaluate(d, K, l);
      const auto   plus = law->evaluate(d + h, K, l),
                 minus  = law->evaluate(d - h, K, l);
      EXPECT_NEAR(r.pressure,
                  (plus.energy - minus.energy) / (2. * h),
                  1e-6 * r.pressure);
      EXPECT_NEAR(r.stiffness,
                  (plus.pressure - minus.pressure) / (2. * h),
                  1e-6 * r.stiffness);
      EXPECT_GT(r.stiffness, 0.);
    }
}

TEST_P(EveryLaw, NoResponseWithoutPenetrationAndContinuousAtZero)
{
  for (const double d : {0., -1e-3, -1e10, std::nan("")})
    {
      const auto r = law->evaluate(d, 1000., 0.1);
      EXPECT_EQ(r.pressure, 0.);
      EXPECT_EQ(r.energy, 0.);
      EXPECT_EQ(r.stiffness, 0.);
    }
  EXPECT_LT(law->evaluate(1e-12, 1000., 0.1).pressure, 1e-8);
}

TEST_P(EveryLaw, InverseGivesBackThePenetration)
{
  for (const double p : {1e-8, 1e-3, 2e-3, 3.1e-3, 0.04, 1.})
    EXPECT_NEAR(law->normalised(law->inverse(p)).pressure, p, 1e-13 * p);
  EXPECT_EQ(law->inverse(0.), 0.);
}

TEST_P(EveryLaw, DependsOnUnitsAsAPressureDoes)
{
  const auto m  = law->evaluate(0.02, 1000., 0.1);
  const auto mm = law->evaluate(20., 1e-3, 100.); // N/mm^2 = 1e6 Pa, scaled
  EXPECT_NEAR(mm.pressure, 1e-6 * m.pressure, 1e-20 * m.pressure);
  EXPECT_NEAR(mm.stiffness, 1e-9 * m.stiffness, 1e-23 * m.stiffness);
}

namespace
{
  std::vector<std::string>
  law_names()
  {
    std::vector<std::string> names;
    for (const auto &law : pressure_laws())
      names.push_back(law.first);
    return names;
  }
} // namespace

INSTANTIATE_TEST_SUITE_P(Library,
                         EveryLaw,
                         testing::Combine(testing::ValuesIn(law_names()),
                                          testing::Values(1., 10.),
                                          testing::Values(false, true)));


// THEORY 1.3: p = alpha eps K (f0 + f0(x_m) s^3/(1 - s)); here d = 0.45 l:
// x = 15, f0 = 14, s = 0.8, f0(x_m) = 47/3
TEST(PaperLaw, BarrierLetsNoPressureReachTheLargestPenetration)
{
  const auto law = make_pressure_law("parabola linear", 0.1, 1., 0.5, true);
  EXPECT_NEAR(law->normalised(0.45).pressure,
              0.1 * 0.03 * (14. + 47. / 3. * 0.512 / 0.2),
              1e-13);
  // 1000 K would be 2e4 times the release pressure of the paper's law
  EXPECT_LT(law->inverse(1.), 0.5);
  EXPECT_EQ(law->normalised(0.25).pressure,
            make_pressure_law("parabola linear", 0.1, 1., 0.5)
              ->normalised(0.25)
              .pressure);
}

TEST(PaperLaw, HasTheValuesOfThePaper)
{
  // THEORY 1.2: alpha = 0.1, K = 1000, l = 0.1
  const auto law = make_pressure_law("parabola linear", 0.1, 1., 0.5);
  EXPECT_NEAR(law->evaluate(0.003, 1000., 0.1).pressure, 0.75, 1e-13);
  EXPECT_NEAR(law->evaluate(0.006, 1000., 0.1).pressure, 3.0, 1e-13);
  EXPECT_NEAR(law->evaluate(0.025, 1000., 0.1).pressure, 22.0, 1e-12);
  EXPECT_NEAR(law->evaluate(0.05, 1000., 0.1).pressure, 47.0, 1e-12);
  // slope on both sides of x = 2, plateau alpha K / l
  EXPECT_NEAR(law->evaluate(0.006 * (1. - 1e-12), 1000., 0.1).stiffness,
              1000.,
              1e-7);
  EXPECT_NEAR(law->evaluate(0.006 * (1. + 1e-12), 1000., 0.1).stiffness,
              1000.,
              1e-7);
}

TEST(PaperLaw, StiffensProgressivelyAsTabulated)
{
  // THEORY 1.3, f(x) at x = 12.5 and x_m; p = alpha eps K f
  const double table[3][3] = {{2., 13.458, 31.333},
                              {5., 19.333, 78.333},
                              {10., 29.125, 156.667}};
  for (const auto &row : table)
    {
      const auto law = make_pressure_law("parabola linear", 0.1, row[0], 0.5);
      EXPECT_NEAR(law->normalised(12.5 * 0.03).pressure / 0.003, row[1], 1e-3);
      EXPECT_NEAR(law->normalised(0.5).pressure / 0.003, row[2], 1e-3);
      // C2 at d = l/4: unchanged there with value, slope and curvature
      const auto   plain = make_pressure_law("parabola linear", 0.1, 1., 0.5);
      const double h     = 1e-5;
      EXPECT_NEAR(law->normalised(0.25 + h).stiffness,
                  plain->normalised(0.25 + h).stiffness,
                  1e-6);
      EXPECT_EQ(law->normalised(0.2).pressure, plain->normalised(0.2).pressure);
      // beyond the largest penetration along the tangent
      EXPECT_NEAR(law->normalised(0.6).stiffness,
                  law->normalised(0.5).stiffness,
                  1e-12);
    }
}

TEST(ContactModulus, SeriesIsSymmetricAndEndsAtARigidSide)
{
  const auto a = in_series(1e-4, 0.1, 3e-4, 0.2),
             b = in_series(3e-4, 0.2, 1e-4, 0.1);
  EXPECT_DOUBLE_EQ(a.modulus, b.modulus);
  EXPECT_DOUBLE_EQ(a.length, b.length);
  EXPECT_DOUBLE_EQ(a.length / a.modulus, 4e-4);
  const auto rigid = in_series(1e-4, 0.1, 0., 7.);
  EXPECT_DOUBLE_EQ(rigid.modulus, 1000.);
  EXPECT_DOUBLE_EQ(rigid.length, 0.1);
  EXPECT_NEAR(bulk_contact_modulus(10., 0.3), 10. / 1.2, 1e-14);
  EXPECT_EQ(bulk_contact_modulus(10., 0.4999),
            bulk_contact_modulus(10., 0.499));
}

TEST(InitialPenetration, SharesGoToZeroLinearly)
{
  using I = InitialPenetration;
  EXPECT_EQ(removal_share(I::stress, 0.5, 0.), 0.);
  EXPECT_EQ(removal_share(I::track, 0.5, 0.), 1.);
  EXPECT_EQ(removal_share(I::remove, 0.5, 2.), 0.75);
  EXPECT_EQ(removal_share(I::remove_deep, 3., 2.), 0.);
  EXPECT_EQ(offset(-1., 1.), 0.);
  EXPECT_EQ(offset(2., 0.5), 1.);
}

// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/paper_law.h>

#include <gtest/gtest.h>

#include "../support/facet_pair.h"

using namespace MortarContact;
using namespace Test;

namespace
{
  /// A pair that slid by @p slip during the step, with elastic slip from
  /// before; @p opening: how far the facets were apart before.
  struct FrictionPair
  {
    Pair3d       pair;
    FacetSlip<3> slip;
    Facet<3>     before_p;

    FrictionPair(const unsigned int  n_s,
                 const unsigned int  n_p,
                 const Tensor<1, 3> &motion,
                 const unsigned int  seed,
                 const double        tilt = 0.05)
      : pair(n_s, n_p, 0.04, tilt, seed)
      , before_p(pair.primary.current)
    {
      std::mt19937                           rng(seed + 100);
      std::uniform_real_distribution<double> u(-1., 1.);
      slip.before = pair.secondary.current;
      for (auto *f : {&slip.before, &before_p})
        for (auto &x : f->x)
          for (unsigned int i = 0; i < 3; ++i)
            x[i] += 0.002 * u(rng);
      for (auto &x : slip.before.x)
        x -= motion;
      const SecondaryFrame<3> frame(slip.before);
      slip.normal = frame.normal;
      slip.basis  = frame.basis;
      for (auto &e : slip.elastic)
        for (unsigned int c = 0; c < 2; ++c)
          e[c] = 1e-3 * u(rng);
      slip.share       = 0.6;
      slip.time_step   = 0.1;
      pair.offset.slip = &slip;
    }

    FrictionPair(const FrictionPair &) = delete;

    PairBlock<3>
    evaluate(const PairKernel<3> &kernel,
             const Facet<3>      &s,
             const Facet<3>      &p,
             const bool           tangent) const
    {
      ContactFacet<3> secondary = pair.secondary, primary = pair.primary;
      secondary.current = s;
      primary.current   = p;
      PairBlock<3> block;
      kernel.evaluate_segments(SecondaryFrame<3>(s),
                               secondary,
                               pair.offset,
                               primary,
                               &before_p,
                               1.,
                               tangent,
                               block);
      return block;
    }

    PairBlock<3>
    evaluate(const PairKernel<3> &kernel) const
    {
      return evaluate(kernel,
                      pair.secondary.current,
                      pair.primary.current,
                      true);
    }
  };

  KernelOptions
  options(const StiffnessSide side         = StiffnessSide::series,
          const double        elastic_slip = 0.)
  {
    KernelOptions o;
    o.stiffness_side = side;
    o.elastic_slip   = elastic_slip;
    return o;
  }

  const Tensor<1, 3> small({2e-4, 1e-4, 0.}), large({0.03, -0.02, 0.01}),
    approach({0.02, 0.01, -0.06});
} // namespace


// Reference: central differences of the forces.
TEST(Friction, TangentIsTheDerivativeOfTheForcesInStickSlipAndFirstContact)
{
  const PaperLaw        law(PressureCurve::parabola_linear, 0.1, 5.);
  const CoulombFriction coulomb(0.4, 0.4, 0.), fading(0.5, 0.2, 3.);
  const FormulaFriction formula("0.4/(1 + p/500) + 0.1*v");
  for (const FrictionLaw *friction :
       std::initializer_list<const FrictionLaw *>{&coulomb, &fading, &formula})
    for (const StiffnessSide side :
         {StiffnessSide::series, StiffnessSide::secondary})
      for (const double elastic_slip : {0., 2e-3})
        for (const Tensor<1, 3> &motion : {small, large, approach})
          for (const unsigned int n_s : {3u, 4u})
            {
              const PairKernel<3> kernel(law,
                                         friction,
                                         options(side, elastic_slip));
              const FrictionPair  p(n_s, 7 - n_s, motion, n_s);
              const auto          evaluate =
                [&](const Facet<3> &s, const Facet<3> &f, const bool tangent) {
                  return p.evaluate(kernel, s, f, tangent);
                };
              const auto block = p.evaluate(kernel);
              ASSERT_TRUE(block.is_active());
              EXPECT_LT(tangent_error<3>(evaluate,
                                         p.pair.secondary.current,
                                         p.pair.primary.current),
                        2e-6)
                << n_s << " " << motion << " " << elastic_slip;
            }
}


TEST(Friction, SticksAndSlipsWhereExpected)
{
  const PaperLaw        law(PressureCurve::parabola_linear, 0.1);
  const CoulombFriction coulomb(0.4, 0.4, 0.);
  const PairKernel<3>   kernel(law, &coulomb, options());
  FrictionPair          stick(4, 4, small, 1), slide(4, 4, large, 1);
  for (auto *p : {&stick, &slide})
    for (auto &e : p->slip.elastic)
      e = PlanePoint<3>();
  EXPECT_LT(stick.evaluate(kernel).slip_area,
            0.5 * stick.evaluate(kernel).active_area);
  const auto block = slide.evaluate(kernel);
  EXPECT_NEAR(block.slip_area, block.active_area, 1e-14);
  EXPECT_GT(block.dissipation, 0.);
}


// THEORY T11, T13
TEST(Friction, ForcesAndMomentsAreInBalanceToRoundOff)
{
  const PaperLaw        law(PressureCurve::parabola_linear, 0.1);
  const CoulombFriction coulomb(0.4, 0.4, 0.);
  const PairKernel<3>   kernel(law, &coulomb, options());
  for (const unsigned int n_s : {3u, 4u})
    for (unsigned int seed = 0; seed < 10; ++seed)
      for (const Tensor<1, 3> &motion : {small, large})
        {
          FrictionPair p(n_s, 4, motion, seed);
          // a thick skin: contact at a distance
          p.pair.secondary.surface_offset = 0.3;
          for (auto &x : p.pair.primary.current.x)
            x[2] += 0.3;
          const auto block = p.evaluate(kernel);
          ASSERT_TRUE(block.is_active());
          const auto sums = resultants(block.residual,
                                       p.pair.secondary.current,
                                       p.pair.primary.current);
          EXPECT_LT(sums[0].norm(), 1e-14 * norm(block.residual));
          EXPECT_LT(sums[1].norm(), 1e-14 * norm(block.residual));
        }
}


// THEORY T24: also where the skin is thick.
TEST(Friction, RigidRotationGivesNoFriction)
{
  const PaperLaw        law(PressureCurve::parabola_linear, 0.1);
  const CoulombFriction coulomb(0.4, 0.4, 0.);
  const PairKernel<3>   kernel(law, &coulomb, options());
  const PairKernel<3>   frictionless(law, nullptr, options());
  FrictionPair          p(4, 4, small, 3);
  p.pair.secondary.surface_offset = 0.3;
  for (auto &x : p.pair.primary.current.x)
    x[2] += 0.3;
  p.before_p    = p.pair.primary.current;
  p.slip.before = p.pair.secondary.current;
  const SecondaryFrame<3> frame(p.slip.before);
  p.slip.normal  = frame.normal;
  p.slip.basis   = frame.basis;
  p.slip.elastic = {};
  p.pair.rotate(rotation(0.7, -0.4));
  const auto with = p.evaluate(kernel), without = p.evaluate(frictionless);
  double     difference = 0.;
  for (unsigned int i = 0; i < 24; ++i)
    difference =
      std::max(difference, std::abs(with.residual[i] - without.residual[i]));
  EXPECT_GT(with.active_area, 0.1);
  EXPECT_LT(difference, 1e-12 * norm(without.residual));

  // and what was there turns with the bodies
  FrictionPair q(4, 4, large, 5);
  const auto   f = q.evaluate(kernel).residual;
  const auto   Q = rotation(1.1, 0.5);
  q.pair.rotate(Q);
  const auto turned = q.evaluate(kernel).residual;
  for (unsigned int a = 0; a < 8; ++a)
    {
      const Tensor<1, 3> fa({f[3 * a], f[3 * a + 1], f[3 * a + 2]});
      const Tensor<1, 3> fb(
        {turned[3 * a], turned[3 * a + 1], turned[3 * a + 2]});
      EXPECT_LT((Q * fa - fb).norm(), 1e-12 * norm(f));
    }
}


TEST(FrictionLaw, DerivativesAgreeWithDifferences)
{
  const CoulombFriction fading(0.5, 0.2, 3.);
  const FormulaFriction formula("0.4/(1 + p/500) + 0.1*v^2");
  for (const FrictionLaw *law :
       std::initializer_list<const FrictionLaw *>{&fading, &formula})
    {
      const double h  = 1e-6;
      const auto   at = law->evaluate(300., 0.7);
      EXPECT_NEAR(at.by_rate,
                  (law->evaluate(300., 0.7 + h).coefficient -
                   law->evaluate(300., 0.7 - h).coefficient) /
                    (2. * h),
                  1e-8);
      EXPECT_NEAR(at.by_pressure,
                  (law->evaluate(300. + 1e-3, 0.7).coefficient -
                   law->evaluate(300. - 1e-3, 0.7).coefficient) /
                    2e-3,
                  1e-8);
    }
  EXPECT_ANY_THROW(FormulaFriction("0.4*q"));
  EXPECT_NEAR(fading.evaluate(1., 0.).coefficient, 0.5, 1e-15);
  EXPECT_NEAR(fading.evaluate(1., 100.).coefficient, 0.2, 1e-15);
}

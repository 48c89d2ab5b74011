// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/mortar/tie_kernel.h>

#include <gtest/gtest.h>

#include "../support/facet_pair.h"

using namespace MortarContact;
using namespace Test;

namespace
{
  TiePoint<3>
  tie_of(const Pair3d &pair)
  {
    TiePoint<3> tie;
    tie.xi        = PlanePoint<3>({0.3, 0.4});
    tie.eta       = PlanePoint<3>({0.45, 0.25});
    tie.weight    = 0.7;
    tie.stiffness = 100.;
    tie.apart     = apart(SecondaryFrame<3>(pair.secondary.current),
                      pair.primary.current,
                      tie.xi,
                      tie.eta);
    // a jump in all directions
    tie.apart += Tensor<1, 3>({0.02, -0.03, 0.015});
    return tie;
  }

  PairBlock<3>
  evaluate(const TiePoint<3> &tie,
           const TieLaw<3>   &law,
           const Facet<3>    &s,
           const Facet<3>    &p,
           const bool         tangent)
  {
    PairBlock<3>            block;
    const SecondaryFrame<3> frame(s);
    TiedPair<3>             ties(frame, p, law, tangent, block);
    (void)ties.add(tie);
    ties.finish();
    return block;
  }

  TieStrength
  cohesive()
  {
    TieStrength s;
    s.law              = TieStrength::Law::cohesive;
    s.normal           = 0.5;
    s.shear            = 0.8;
    s.energy_normal    = 0.02;
    s.energy_shear     = 0.05;
    s.normal_stiffness = 90.;
    s.shear_ratio      = 0.7;
    s.exponent         = 1.4;
    return s;
  }
} // namespace


TEST(TieKernel, ForcesAreTheGradientOfTheEnergyAndTheTangentTheirDerivative)
{
  for (const unsigned int n_s : {3u, 4u})
    for (unsigned int seed = 0; seed < 5; ++seed)
      {
        // far apart: an offset tie
        Pair3d pair(n_s, 7 - n_s, 0.04, 0.2, seed);
        for (auto &x : pair.primary.current.x)
          x += Tensor<1, 3>({0.1, 0.2, 0.5});
        const TiePoint<3> tie = tie_of(pair);
        const TieLaw<3>   law({});
        const auto        at =
          [&](const Facet<3> &s, const Facet<3> &p, const bool tangent) {
            return evaluate(tie, law, s, p, tangent);
          };
        const Facet<3> &s = pair.secondary.current, &p = pair.primary.current;
        EXPECT_LT(tangent_error<3>(at, s, p), 1e-8);
        const auto block     = at(s, p, true);
        double     asymmetry = 0.;
        for (unsigned int i = 0; i < 24; ++i)
          {
            const double h     = 1e-6;
            const auto   moved = [&](const double by) {
              Facet<3> ms = s, mp = p;
              (i < 12 ? ms : mp).x[(i % 12) / 3][i % 3] += by;
              return at(ms, mp, false).energy;
            };
            EXPECT_NEAR(block.residual[i],
                        (moved(h) - moved(-h)) / (2. * h),
                        1e-8 * norm(block.residual));
            for (unsigned int j = 0; j < 24; ++j)
              asymmetry =
                std::max(asymmetry,
                         std::abs(block.tangent[i][j] - block.tangent[j][i]));
          }
        EXPECT_LT(asymmetry, 1e-12 * tie.stiffness);
        const auto sums = resultants(block.residual, s, p);
        EXPECT_LT(sums[0].norm(), 1e-14 * norm(block.residual));
        EXPECT_LT(sums[1].norm(), 1e-14 * norm(block.residual));
      }
}


TEST(TieKernel, TangentOfDamageIsTheDerivativeOfTheForces)
{
  for (const bool bk : {false, true})
    for (unsigned int seed = 0; seed < 5; ++seed)
      {
        const Pair3d pair(4, 4, 0.04, 0.2, seed);
        TieStrength  strength      = cohesive();
        strength.benzeggagh_kenane = bk;
        TiePoint<3> tie            = tie_of(pair);
        // open and sheared, into softening
        tie.apart += Tensor<1, 3>({-0.01, 0.02, 0.01});
        const TieLaw<3> law(strength);
        const auto      at =
          [&](const Facet<3> &s, const Facet<3> &p, const bool tangent) {
            return evaluate(tie, law, s, p, tangent);
          };
        PairBlock<3>            block;
        const SecondaryFrame<3> frame(pair.secondary.current);
        const auto              response =
          TiedPair<3>(frame, pair.primary.current, law, false, block).add(tie);
        EXPECT_GT(response.history.damage, 0.1);
        EXPECT_LT(response.history.damage, 1.);
        EXPECT_LT(tangent_error<3>(at,
                                   pair.secondary.current,
                                   pair.primary.current),
                  1e-7);
      }
}


TEST(TieKernel, OffsetTieTransfersTheMomentOfAnEccentricPull)
{
  // THEORY T48: what pulls at the far side of the gap acts on the secondary as
  // a force on its own surface with the moment force times arm
  Facet<3> s, p;
  s.n_vertices = p.n_vertices = 4;
  const double gap            = 0.5;
  for (unsigned int a = 0; a < 4; ++a)
    {
      const double x = (a == 1 || a == 2) ? 1. : 0., y = (a > 1) ? 1. : 0.;
      s.x[a] = Tensor<1, 3>({x, y, 0.});
      p.x[a] = Tensor<1, 3>({y, x, gap}); // faces down
    }
  TiePoint<3> tie;
  tie.xi        = PlanePoint<3>({0.3, 0.4});
  tie.eta       = PlanePoint<3>({0.4, 0.3});
  tie.weight    = 0.7;
  tie.stiffness = 100.;
  tie.apart     = apart(SecondaryFrame<3>(s), p, tie.xi, tie.eta);
  const Tensor<1, 3> pull({0.01, 0.02, 0.003});
  for (unsigned int a = 0; a < 4; ++a)
    p.x[a] += pull;
  const PairBlock<3> block = evaluate(tie, TieLaw<3>({}), s, p, false);

  const Tensor<1, 3> at({0.3, 0.4, 0.});
  Tensor<1, 3>       force, moment;
  for (unsigned int a = 0; a < 4; ++a)
    {
      Tensor<1, 3> f;
      for (unsigned int i = 0; i < 3; ++i)
        f[i] = -block.residual[3 * a + i];
      force += f;
      moment += cross_product_3d(s.x[a] - at, f);
    }
  EXPECT_LT((force - tie.weight * tie.stiffness * pull).norm(), 1e-12);
  const Tensor<1, 3> arm = pull + Tensor<1, 3>({0., 0., gap});
  EXPECT_LT((moment - cross_product_3d(arm, force)).norm(),
            1e-12 * force.norm());
}


TEST(TieKernel, ForcesTurnWithTheFacets)
{
  Pair3d            pair(4, 3, 0.04, 0.2, 2);
  const TiePoint<3> tie = tie_of(pair);
  const TieLaw<3>   law({});
  const auto        f =
    evaluate(tie, law, pair.secondary.current, pair.primary.current, false)
      .residual;
  const auto Q = rotation(2.5, 0.9);
  pair.rotate(Q);
  const auto turned =
    evaluate(tie, law, pair.secondary.current, pair.primary.current, false)
      .residual;
  for (unsigned int a = 0; a < 8; ++a)
    {
      const Tensor<1, 3> fa({f[3 * a], f[3 * a + 1], f[3 * a + 2]});
      const Tensor<1, 3> fb(
        {turned[3 * a], turned[3 * a + 1], turned[3 * a + 2]});
      EXPECT_LT((Q * fa - fb).norm(), 1e-12 * norm(f));
    }
}


namespace
{
  /// Energy dissipated along a path of jumps from zero, and the peak traction;
  /// work of the tractions by the trapezoidal rule over @p n steps.
  double
  work(const TieLaw<3>    &law,
       const Tensor<1, 3> &end,
       const unsigned int  n,
       Tensor<1, 3>       &peak)
  {
    TieHistory   history;
    Tensor<1, 3> t_old;
    double       sum = 0.;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const auto r = law.evaluate(double(i) / n * end, 1., history);
        sum += 0.5 * ((r.traction + t_old) * end) / n;
        for (unsigned int c = 0; c < 3; ++c)
          peak[c] = std::max(peak[c], r.traction[c]);
        t_old   = r.traction;
        history = r.history;
      }
    EXPECT_EQ(history.damage, 1.);
    return sum;
  }
} // namespace


// THEORY T46
TEST(TieLaw, FractureTakesItsEnergyInPureAndMixedModes)
{
  TieStrength  strength = cohesive();
  const double GI = strength.energy_normal, GII = strength.energy_shear;
  {
    const TieLaw<3> law(strength);
    Tensor<1, 3>    peak;
    EXPECT_NEAR(work(law, Tensor<1, 3>({0., 0., 0.2}), 20000, peak),
                GI,
                1e-3 * GI);
    EXPECT_NEAR(peak[2], strength.normal, 1e-3 * strength.normal);
    EXPECT_NEAR(work(law, Tensor<1, 3>({0.2, 0., 0.}), 20000, peak),
                GII,
                1e-3 * GII);
    EXPECT_NEAR(peak[0], strength.shear, 1e-3 * strength.shear);
  }
  const double EN = strength.normal_stiffness,
               ET = strength.shear_ratio * strength.normal_stiffness;
  for (const double beta : {0.5, 2.})
    {
      const Tensor<1, 3> end({0.2 * beta * 0.6, 0.2 * beta * 0.8, 0.2});
      // parts of the work in the two modes: as the stiffnesses
      const double I = EN, II = ET * beta * beta;
      for (const double mu : {1., 2.})
        {
          strength.exponent = mu;
          const TieLaw<3> law(strength);
          Tensor<1, 3>    peak;
          const double    G = work(law, end, 20000, peak);
          EXPECT_NEAR(std::pow(G * I / (I + II) / GI, mu) +
                        std::pow(G * II / (I + II) / GII, mu),
                      1.,
                      1e-3);
        }
      strength.benzeggagh_kenane = true;
      strength.exponent          = 1.5;
      const TieLaw<3> law(strength);
      Tensor<1, 3>    peak;
      EXPECT_NEAR(work(law, end, 20000, peak),
                  GI + (GII - GI) * std::pow(II / (I + II), 1.5),
                  1e-3 * GI);
      strength.benzeggagh_kenane = false;
    }
}


TEST(TieLaw, UnloadingGoesToTheOriginAndPressureIsCarriedWhole)
{
  const TieLaw<3> law(cohesive());
  TieHistory      history =
    law.evaluate(Tensor<1, 3>({0., 0., 0.03}), 1., {}).history;
  EXPECT_GT(history.damage, 0.);
  EXPECT_LT(history.damage, 1.);
  const auto half = law.evaluate(Tensor<1, 3>({0., 0., 0.01}), 1., history);
  EXPECT_EQ(half.history.damage, history.damage);
  EXPECT_NEAR(half.traction[2], (1. - history.damage) * 90. * 0.01, 1e-14);
  EXPECT_NEAR(
    law.evaluate(Tensor<1, 3>({0., 0., -0.01}), 1., history).traction[2],
    -0.9,
    1e-14);
}


// THEORY T47
TEST(TieLaw, StrengthFailsWhereTheCriterionIsMet)
{
  TieStrength strength = cohesive();
  strength.law         = TieStrength::Law::strength;
  const TieLaw<3> law(strength);
  // (s_n/NFLS)^2 + (s_t/SFLS)^2 = 1 at s_n = 0.3, s_t = 0.64
  const Tensor<1, 3> at({0.64 / 63., 0., 0.3 / 90.});
  EXPECT_EQ(law.evaluate(0.999 * at, 1., {}).history.damage, 0.);
  EXPECT_EQ(law.evaluate(1.001 * at, 1., {}).history.damage, 1.);
}


TEST(TieLaw, DycossIsStrongerInShearUnderPressure)
{
  TieStrength strength    = cohesive();
  strength.law            = TieStrength::Law::dycoss;
  strength.friction_angle = 0.5;
  const TieLaw<3> law(strength);
  // pressure 0.9: shear strength 0.8 + 0.9 sin(0.5) = 1.2315
  const double start = (0.8 + 0.9 * std::sin(0.5)) / 63.;
  EXPECT_EQ(law.evaluate(Tensor<1, 3>({0.999 * start, 0., -0.01}), 1., {})
              .history.damage,
            0.);
  EXPECT_GT(law.evaluate(Tensor<1, 3>({1.001 * start, 0., -0.01}), 1., {})
              .history.damage,
            0.);
}

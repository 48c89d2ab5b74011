// SPDX-License-Identifier: LGPL-2.1-or-later
#include <mortar_contact/laws/paper_law.h>
#include <mortar_contact/mortar/pair_kernel.h>

#include <Sacado.hpp>
#include <gtest/gtest.h>

#include "../support/facet_pair.h"
#include "../support/oracle.h"

#include <random>

using namespace MortarContact;
using namespace Test;

namespace
{
  using AD = Sacado::Fad::SFad<double, 24>;

  PairBlock<3>
  evaluate(const PairKernel<3> &kernel,
           const Pair3d        &pair,
           const bool           tangent = true)
  {
    PairBlock<3> block;
    kernel.evaluate_segments(SecondaryFrame<3>(pair.secondary.current),
                             pair.secondary,
                             pair.offset,
                             pair.primary,
                             nullptr,
                             1.,
                             tangent,
                             block);
    kernel.finish(block);
    return block;
  }

  template <class T>
  Oracle::Facet<T>
  oracle_facet(const ContactFacet<3> &f, const unsigned int first)
  {
    Oracle::Facet<T> o;
    o.n          = f.current.n_vertices;
    o.compliance = f.compliance;
    o.length     = f.length;
    for (unsigned int a = 0; a < o.n; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        if constexpr (std::is_same_v<T, double>)
          o.x[a][i] = f.current.x[a][i];
        else
          o.x[a][i] = T(24, first + 3 * a + i, f.current.x[a][i]);
    return o;
  }

  template <class T>
  std::array<T, 24>
  oracle(const PairKernel<3> &kernel, const Pair3d &pair, const double igap)
  {
    Oracle::Setup setup;
    for (unsigned int a = 0; a < 4; ++a)
      for (unsigned int i = 0; i < 3; ++i)
        setup.reference[a][i] = pair.secondary.reference.x[a][i];
    setup.level  = pair.offset.level;
    setup.share  = pair.offset.share;
    setup.igap   = igap;
    setup.degree = kernel.options.integration.degree;
    setup.series = kernel.options.stiffness_side == StiffnessSide::series;
    return Oracle::residual<T>(setup,
                               oracle_facet<T>(pair.secondary, 0),
                               oracle_facet<T>(pair.primary, 12));
  }

  KernelOptions
  exact()
  {
    KernelOptions o;
    o.symmetrise = false;
    return o;
  }

} // namespace


class PairKernelShapes : public testing::TestWithParam<
                           std::tuple<unsigned int, unsigned int, double>>
{};

// Reference: tests/support/oracle.h differentiated by Sacado.
TEST_P(PairKernelShapes, TangentIsTheExactDerivativeOfTheDiscreteResidual)
{
  const auto [n_s, n_p, tilt] = GetParam();
  for (const double igap : {1., 10.})
    for (const StiffnessSide side :
         {StiffnessSide::series, StiffnessSide::secondary})
      for (unsigned int seed = 0; seed < 5; ++seed)
        {
          const PaperLaw law(PressureCurve::parabola_linear, 0.1, igap);
          KernelOptions  options = exact();
          options.stiffness_side = side;
          const PairKernel<3> kernel(law, nullptr, options);
          const Pair3d        pair(n_s, n_p, 0.04, tilt, seed);
          const auto          block = evaluate(kernel, pair);
          const auto          ad    = oracle<AD>(kernel, pair, igap);
          ASSERT_TRUE(block.is_active());
          double error = 0., scale = 0., error_f = 0.;
          for (unsigned int i = 0; i < 24; ++i)
            {
              error_f =
                std::max(error_f, std::abs(block.residual[i] - ad[i].val()));
              for (unsigned int j = 0; j < 24; ++j)
                {
                  error = std::max(error,
                                   std::abs(block.tangent[i][j] -
                                            ad[i].fastAccessDx(j)));
                  scale = std::max(scale, std::abs(ad[i].fastAccessDx(j)));
                }
            }
          EXPECT_LT(error_f, 1e-12 * norm(block.residual));
          EXPECT_LT(error, 1e-8 * scale) << "seed " << seed;
        }
}

INSTANTIATE_TEST_SUITE_P(
  TrianglesAndQuadrilaterals,
  PairKernelShapes,
  testing::Combine(testing::Values(3u, 4u),
                   testing::Values(3u, 4u),
                   // slight, and inside the angle weight's range
                   testing::Values(0.05, 1.15)));


TEST(PairKernel, TangentIsTheDerivativeOfTheResidualByDifferences)
{
  const PaperLaw      law(PressureCurve::parabola_linear, 0.1, 10.);
  const PairKernel<3> kernel(law, nullptr, exact());
  const Pair3d        pair(4, 4, 0.03, 0.03, 7);
  const auto          block = evaluate(kernel, pair);
  double              best  = 1.;
  for (const double h : {1e-4, 1e-5, 1e-6})
    {
      double error = 0., scale = 0.;
      for (unsigned int j = 0; j < 24; ++j)
        {
          const auto moved = [&](const double by) {
            Pair3d           p = pair;
            ContactFacet<3> &f = (j < 12) ? p.secondary : p.primary;
            f.current.x[(j % 12) / 3][j % 3] += by;
            return evaluate(kernel, p, false).residual;
          };
          const auto plus = moved(h), minus = moved(-h);
          for (unsigned int i = 0; i < 24; ++i)
            {
              const double fd = (plus[i] - minus[i]) / (2. * h);
              error = std::max(error, std::abs(fd - block.tangent[i][j]));
              scale = std::max(scale, std::abs(fd));
            }
        }
      best = std::min(best, error / scale);
    }
  EXPECT_LT(best, 1e-7);
}


TEST(PairKernel, ForcesAndMomentsAreInBalanceToRoundOff)
{
  const PaperLaw      law(PressureCurve::parabola_linear, 0.1);
  const PairKernel<3> kernel(law, nullptr, KernelOptions());
  for (const unsigned int n_s : {3u, 4u})
    for (const unsigned int n_p : {3u, 4u})
      for (unsigned int seed = 0; seed < 10; ++seed)
        {
          const Pair3d pair(n_s, n_p, 0.03, 0.1, seed);
          const auto   f = evaluate(kernel, pair).residual;
          Tensor<1, 3> force, moment;
          for (unsigned int a = 0; a < 8; ++a)
            {
              const auto        &x = (a < 4) ? pair.secondary.current.x[a] :
                                               pair.primary.current.x[a - 4];
              const Tensor<1, 3> fa({f[3 * a], f[3 * a + 1], f[3 * a + 2]});
              force += fa;
              moment += cross_product_3d(x, fa);
            }
          EXPECT_LT(force.norm(), 1e-14 * norm(f));
          EXPECT_LT(moment.norm(), 1e-14 * norm(f));
        }
}


TEST(PairKernel, ForcesTurnWithTheFacets)
{
  const PaperLaw      law(PressureCurve::parabola_linear, 0.1);
  const PairKernel<3> kernel(law, nullptr, exact());
  for (const double angle : {0.3, 1.5707963267948966, 3.1})
    {
      Pair3d     pair(4, 4, 0.03, 0.1, 3);
      const auto f = evaluate(kernel, pair).residual;
      const auto Q = rotation(angle, 0.7 * angle);
      pair.rotate(Q);
      const auto block  = evaluate(kernel, pair);
      const auto turned = block.residual;
      double     error  = 0.;
      for (unsigned int a = 0; a < 8; ++a)
        {
          const Tensor<1, 3> fa({f[3 * a], f[3 * a + 1], f[3 * a + 2]});
          const Tensor<1, 3> fb(
            {turned[3 * a], turned[3 * a + 1], turned[3 * a + 2]});
          error = std::max(error, (Q * fa - fb).norm());
        }
      EXPECT_LT(error, 1e-12 * norm(f));

      // Translations do no work; a rotation turns the forces (THEORY T15).
      double stiffness = 0.;
      for (const auto &row : block.tangent)
        stiffness = std::max(stiffness, norm(row));
      const Tensor<1, 3> omega({0.3, -0.5, 0.8});
      for (unsigned int i = 0; i < 24; ++i)
        {
          Tensor<1, 3> translation;
          double       rotated = 0.;
          for (unsigned int a = 0; a < 8; ++a)
            {
              const auto &x = (a < 4) ? pair.secondary.current.x[a] :
                                        pair.primary.current.x[a - 4];
              const auto  u = cross_product_3d(omega, x);
              for (unsigned int c = 0; c < 3; ++c)
                {
                  translation[c] += block.tangent[i][3 * a + c];
                  rotated += block.tangent[i][3 * a + c] * u[c];
                }
            }
          EXPECT_LT(translation.norm(), 1e-11 * stiffness);
          const unsigned int a = i / 3;
          const Tensor<1, 3> fa(
            {turned[3 * a], turned[3 * a + 1], turned[3 * a + 2]});
          EXPECT_NEAR(rotated,
                      cross_product_3d(omega, fa)[i % 3],
                      1e-11 * stiffness);
        }
    }
}


TEST(PairKernel, UniformDepthOnPlaneFacetsGivesPressureTimesOverlap)
{
  // unit squares, offset by (0.25, 0.5): overlap 0.375
  ContactFacet<3> s, p;
  const double    c[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (unsigned int a = 0; a < 4; ++a)
    {
      s.current.x[a] = Tensor<1, 3>({c[a][0], c[a][1], 0.});
      p.current.x[a] =
        Tensor<1, 3>({c[3 - a][0] + 0.25, c[3 - a][1] + 0.5, -0.02});
      s.length[a] = p.length[a] = 0.1;
      s.compliance[a] = p.compliance[a] = 0.1 / 1000.;
    }
  s.reference = s.current;
  const PaperLaw law(PressureCurve::parabola_linear, 0.1);
  KernelOptions  options;
  options.stiffness_side = StiffnessSide::secondary;
  const PairKernel<3> kernel(law, nullptr, options);
  PairBlock<3>        block;
  kernel.evaluate_segments(
    SecondaryFrame<3>(s.current), s, {}, p, nullptr, 1., true, block);
  // d = 0.02, x = 0.02/(0.03*0.1) = 6.67, f = 5.667, p = 0.1*0.03*1000 f = 17
  double force = 0.;
  for (unsigned int a = 0; a < 4; ++a)
    force += block.residual[3 * a + 2];
  EXPECT_NEAR(force, 17. * 0.375, 1e-13 * 17.);
  EXPECT_NEAR(block.area, 0.375, 1e-14);
}


TEST(PairKernel, LinearPenetrationIsIntegratedExactly)
{
  // THEORY T9: parabola law over a plane inclined by slope k: closed form.
  ContactFacet<2> s, p;
  s.current.x    = {{Tensor<1, 2>({1., 0.}), Tensor<1, 2>({0., 0.})}}; // n up
  s.reference    = s.current;
  const double k = 0.001, d0 = 0.001;
  p.current.x = {
    {Tensor<1, 2>({-1., -d0 + k}), Tensor<1, 2>({2., -d0 - 2. * k})}};
  s.length = p.length = {{0.1, 0.1}};
  s.compliance        = {{1e-4, 1e-4}};
  const PaperLaw law(PressureCurve::parabola_linear, 0.1);
  KernelOptions  options;
  options.stiffness_side     = StiffnessSide::secondary;
  options.integration.degree = 4;
  const PairKernel<2>     kernel(law, nullptr, options);
  PairBlock<2>            block;
  const SecondaryFrame<2> frame(s.current);
  EXPECT_NEAR(frame.normal[1], 1., 1e-15);
  kernel.evaluate_segments(frame, s, {}, p, nullptr, 1., true, block);
  double force = 0.;
  for (unsigned int a = 0; a < 2; ++a)
    force += block.residual[2 * a + 1];
  // p(d) = alpha eps K (d/(eps l))^2 / 4, d = d0 + k x on [0,1]
  const double factor = 0.1 * 0.03 * 1000. / 4. / (0.003 * 0.003);
  const double exact =
    factor * (std::pow(d0 + k, 3) - std::pow(d0, 3)) / (3. * k);
  EXPECT_NEAR(force, exact, 1e-13 * exact);
}


TEST(PairKernel, ResidualOfAFixedPointIsTheGradientOfItsDepth)
{
  const PaperLaw law(PressureCurve::linear, 0.1);
  KernelOptions  options   = exact();
  options.integration.rule = Integration::Rule::points;
  const PairKernel<3> kernel(law, nullptr, options);
  Pair3d              pair(4, 4, 0.03, 0.2, 5);
  pair.offset = SecondaryState<3>();
  const PlanePoint<3> xi({0.4, 0.55});
  const auto          depth = [&](const Pair3d &q) {
    return kernel.hit(SecondaryFrame<3>(q.secondary.current), xi, q.primary)
      ->depth;
  };
  const SecondaryFrame<3> frame(pair.secondary.current);
  const auto              hit = kernel.hit(frame, xi, pair.primary);
  ASSERT_TRUE(hit);
  PairBlock<3> block;
  kernel.add_fixed_point(frame,
                         pair.secondary,
                         {},
                         kernel.primary_point(pair.primary, nullptr, hit->eta),
                         xi,
                         1.,
                         false,
                         block);
  const double h = 1e-5;
  for (unsigned int j = 0; j < 24; ++j)
    {
      const auto moved = [&](const double by) {
        Pair3d           q = pair;
        ContactFacet<3> &f = (j < 12) ? q.secondary : q.primary;
        f.current.x[(j % 12) / 3][j % 3] += by;
        return depth(q);
      };
      // block.residual = W sigma dd/dx; the sum along the normal gives W sigma
      double W_sigma = 0.;
      for (unsigned int a = 0; a < 4; ++a)
        for (unsigned int i = 0; i < 3; ++i)
          W_sigma += block.residual[3 * a + i] * frame.normal[i];
      EXPECT_NEAR(block.residual[j] / W_sigma,
                  (moved(h) - moved(-h)) / (2. * h),
                  1e-9);
    }
}
